#pragma once
/// @file message.hpp
/// What the judge and its worker send each other. A message is its length and that many bytes.

#include <cstdint>
#include <string>
#include <string_view>

namespace cs550::grader {

/// The descriptor of the channel in the worker.
inline constexpr int worker_channel = 3;
/// Bytes. The largest honest message is a mesh of 2¹⁴ edges.
inline constexpr std::uint32_t longest_message = 16U << 20U;

/// The first byte of a request.
enum class Request : std::uint8_t {
  Call,   ///< then the function's name and its arguments
  Shape,  ///< then a shape, to be named by its hash from now on; there is no reply
  Mesh,   ///< then a mesh, likewise
};

/// The first byte of a reply.
enum class Reply : std::uint8_t {
  Ready,           ///< the submission is loaded; sent once, unasked
  Returned,        ///< then what the function returned, and its outputs
  NotImplemented,  ///< then step, function and text
  Threw,           ///< then the text of another exception
  Refused,         ///< then why there can be no answer, which ends the worker
};

/// A name for a lab's function that is the same in judge and worker.
template <auto function>
constexpr std::string_view name_of() {
  std::string_view text = __PRETTY_FUNCTION__;  // "… [with auto function = cs550::hill_climb; …]"
  text.remove_prefix(text.find("function = ") + std::string_view("function = ").size());
  text = text.substr(0, text.find_first_of(";]"));
  return text.substr(text.find_last_of(":&") + 1);
}

}  // namespace cs550::grader
