#pragma once
/// @file wire.hpp
/// Calls a lab's function on arguments that went through a serialisation round trip. Its results go
/// through another one.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string>

#include "helpers/fixtures.hpp"
#include "serialisation/arguments.hpp"

namespace cs550::test {

using namespace serialisation;

/// Two overlapping bodies. The receiver of a call has their shapes.
struct TwoBodies {
  ShapePtr cube = fixture_shape("cube");
  ShapePtr hull = fixture_shape("dodecahedron");
  PosedShape a{cube.get(), {{0.1F, 0.2F, 0.3F}, rotation_exp({0.5F, 0.6F, 0.7F})}};
  PosedShape b{hull.get(), {{1.2F, 0.9F, 1.0F}, rotation_exp({-1, 2, 0.5F})}};
  ContentRegistry known;

  TwoBodies() {
    known.add(cube);
    known.add(hull);
  }
};

inline const TwoBodies& two_bodies() {
  static const TwoBodies bodies;
  return bodies;
}

inline void send(ContentRegistry& receiver, const NamedMesh& named) {
  receiver.add(std::make_shared<HalfEdgeMesh>(*named.mesh));
}
template <class Other>
void send(ContentRegistry& /*receiver*/, const Other& /*is sent with the call*/) {}

template <class R, class... P>
void expect_same_across_wire(R (*function)(P...), typename Parameter<P>::Stored... stored) {
  ContentRegistry known = two_bodies().known;
  (send(known, stored), ...);
  Arguments<P...> arguments(stored...);
  const std::string request = to_bytes(arguments);
  const Answer<R, P...> direct = answer(function, arguments);

  auto received = from_bytes<Arguments<P...>>(request, &known);
  EXPECT_EQ(to_bytes(received), request);
  const std::string reply = to_bytes(answer(function, received));
  const auto restored = from_bytes<Answer<R, P...>>(reply, &known);
  EXPECT_EQ(to_bytes(restored), to_bytes(direct));
}

/// Calls a lab's function directly and across the wire. coverage_test.cpp searches for this name.
#define EXPECT_SAME_ACROSS_WIRE(function, ...)      \
  do {                                              \
    SCOPED_TRACE(#function);                        \
    expect_same_across_wire(function, __VA_ARGS__); \
  } while (false)

/// Serialises a value with all bytes 1 and reads it into one with all bytes 0. Members are words of
/// four bytes, or smaller ones with padding, so a word that is still 0 is a member that was not
/// archived.
template <class T>
void expect_every_word_sent(const char* name) {
  alignas(T) std::array<std::byte, sizeof(T)> sent;
  alignas(T) std::array<std::byte, sizeof(T)> received{};
  sent.fill(std::byte{1});
  const std::string bytes = to_bytes(reinterpret_cast<const T&>(sent));
  ByteReader archive(bytes);
  archive(reinterpret_cast<T&>(received));
  for (std::size_t i = 0; i < sizeof(T); i += 4) {
    EXPECT_NE(std::count(&received[i], &received[i] + 4, std::byte{1}), 0)
        << "a member of " << name << " at byte " << i;
  }
}

#define EXPECT_EVERY_WORD_SENT(type) expect_every_word_sent<type>(#type)

}  // namespace cs550::test
