#pragma once
/// @file call.hpp
/// A call of the submission's form of a lab function, from the judge.

#include <cereal/types/string.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "autograder/grader/judge/submission.hpp"
#include "autograder/grader/message.hpp"
#include "autograder/grader/remote/answer_indices.hpp"
#include "serialisation/arguments.hpp"

namespace cs550::grader {

/// Sends a shape or a mesh before its first use in a worker.
template <class Content>
void tell(Request kind, const Content& content) {
  const std::uint64_t hash = serialisation::content_hash(content);
  if (submission().knows(hash)) return;
  serialisation::ByteWriter message;
  message(kind, content);
  submission().tell(hash, message.take());
}

inline void make_known(const PosedShape& body) { tell(Request::Shape, *body.shape); }
inline void make_known(const HalfEdgeMesh& mesh) { tell(Request::Mesh, mesh); }
template <class Other>
void make_known(const Other& /*is sent with each call*/) {}

/// Takes over one output of the answer. Inputs were copies, so they cannot have changed.
template <class P>
void take_output(serialisation::ByteReader& answer, P original) {
  using Parameter = serialisation::Parameter<P>;
  if constexpr (Parameter::is_output) {
    typename Parameter::Stored changed;
    answer(changed);
    const typename Parameter::Stored& was = Parameter::store(original);
    keep_bodies(was, changed);
    Parameter::assign(original, std::move(changed));
  }
}

/// What the function returned, if anything, after its outputs have been taken over.
template <class R, class... P>
R take_answer(serialisation::ByteReader& answer, P... arguments) {
  if constexpr (std::is_void_v<R>) {
    (take_output<P>(answer, arguments), ...);
  } else {
    R result;
    answer(result);
    (take_output<P>(answer, arguments), ...);
    check_indices(result, arguments...);
    return result;
  }
}

template <auto function>
struct Remote;

template <class R, class... P, R (*function)(P...)>
struct Remote<function> {
  static R call(P... arguments) {
    constexpr std::string_view name = name_of<function>();
    (make_known(arguments), ...);
    serialisation::ByteWriter request;
    request(Request::Call, std::string(name));
    (request(serialisation::Parameter<P>::store(arguments)), ...);
    const std::string reply = submission().ask(name, request.take());
    serialisation::ByteReader answer(reply);
    const auto check = [&] {
      if (answer.left() > 0) submission().fail_malformed(name, "it is too long");
      if (answer.has_non_finite() && !request.has_non_finite()) submission().fail_not_finite(name);
    };
    try {
      if constexpr (std::is_void_v<R>) {
        take_answer<R, P...>(answer, arguments...);
        check();
      } else {
        R result = take_answer<R, P...>(answer, arguments...);
        check();
        return result;
      }
    } catch (const cereal::Exception& error) {
      submission().fail_malformed(name, error.what());
    }
  }
};

/// Calls `function` in the worker. A lab's remote definition of it is nothing but this call.
template <auto function, class... Arguments>
decltype(auto) call(Arguments&&... arguments) {
  return Remote<function>::call(std::forward<Arguments>(arguments)...);
}

}  // namespace cs550::grader
