#pragma once
/// @file arguments.hpp
/// The arguments and the answer of any function as values that can be archived.

#include <algorithm>
#include <cereal/types/optional.hpp>
#include <optional>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "serialisation/named_content.hpp"

namespace cs550::serialisation {

/// What an argument becomes while it waits to be passed: a value that owns everything it refers to.
/// A function may change what an output refers to; assign() copies such changes to the original.
template <class P>
struct Parameter {
  using Stored = std::remove_cvref_t<P>;
  static constexpr bool is_output =
      std::is_lvalue_reference_v<P> && !std::is_const_v<std::remove_reference_t<P>>;
  static const Stored& store(const Stored& argument) { return argument; }
  static P pass(Stored& stored) { return stored; }
  static void assign(Stored& original, Stored&& changed) { original = std::move(changed); }
};

/// A mesh is sent once, however many calls it is an argument of.
template <>
struct Parameter<const HalfEdgeMesh&> {
  using Stored = NamedMesh;
  static constexpr bool is_output = false;
  static Stored store(const HalfEdgeMesh& argument) { return Stored(argument); }
  static const HalfEdgeMesh& pass(const Stored& stored) { return *stored.mesh; }
};

template <class T>
struct Parameter<std::span<T>> {
  using Stored = std::vector<std::remove_const_t<T>>;
  static constexpr bool is_output = !std::is_const_v<T>;
  static Stored store(std::span<T> argument) { return {argument.begin(), argument.end()}; }
  static std::span<T> pass(Stored& stored) { return stored; }
  static void assign(std::span<T> original, Stored&& changed) {
    if (changed.size() != original.size()) throw cereal::Exception("an array changed its size");
    std::move(changed.begin(), changed.end(), original.begin());
  }
};

/// A pointer that may be null.
template <class T>
struct Parameter<T*> {
  using Stored = std::optional<T>;
  static constexpr bool is_output = !std::is_const_v<T>;
  static Stored store(T* argument) { return argument ? Stored(*argument) : std::nullopt; }
  static T* pass(Stored& stored) { return stored ? &*stored : nullptr; }
  static void assign(T* original, Stored&& changed) {
    if (changed.has_value() != (original != nullptr))
      throw cereal::Exception("an output is absent");
    if (original) *original = std::move(*changed);
  }
};

/// The arguments of a function with parameters P.
template <class... P>
using Arguments = std::tuple<typename Parameter<P>::Stored...>;

/// A tuple of the value, or an empty tuple for an argument that cannot change.
template <class P>
auto if_output(const typename Parameter<P>::Stored& stored) {
  if constexpr (Parameter<P>::is_output) {
    return std::tuple<typename Parameter<P>::Stored>(stored);
  } else {
    return std::tuple<>();
  }
}

/// Calls a function. Its answer is a tuple of what it returns, if anything, and of its outputs.
template <class R, class... P>
auto answer(R (*function)(P...), Arguments<P...>& arguments) {
  const auto call = [&](auto&... stored) { return function(Parameter<P>::pass(stored)...); };
  const auto outputs = [](const auto&... stored) {
    return std::tuple_cat(if_output<P>(stored)...);
  };
  if constexpr (std::is_void_v<R>) {
    std::apply(call, arguments);
    return std::apply(outputs, arguments);
  } else {
    std::tuple<R> result(std::apply(call, arguments));
    return std::tuple_cat(std::move(result), std::apply(outputs, arguments));
  }
}

/// The type of answer().
template <class R, class... P>
using Answer = decltype(answer(std::declval<R (*)(P...)>(), std::declval<Arguments<P...>&>()));

}  // namespace cs550::serialisation
