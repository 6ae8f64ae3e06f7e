#pragma once
/// @file not_implemented.hpp
/// The exception of functions that are not written yet.

#include <exception>
#include <string>

namespace cs550 {

/// The only exception that a lab function may throw. Tests report it as "not implemented" rather
/// than as a crash; the world skips the stage and reports it in World::problems().
///
/// A starter contains `throw NotImplemented("L3.2");`. Default arguments supply function, file and
/// line.
class NotImplemented : public std::exception {
 public:
  /// @param step the step of the lab, "L3.2"
  explicit NotImplemented(const char* step, const char* function = __builtin_FUNCTION(),
                          const char* file = __builtin_FILE(), int line = __builtin_LINE())
      : step_(step),
        function_(function),
        message_("not implemented: " + step_ + " " + function_ + " (" +
                 (*file == '/' ? file + 1 : file) + ":" + std::to_string(line) +
                 "); see the handout") {}

  /// "not implemented: L3.2 hill_climb (file:line); see the handout".
  const char* what() const noexcept override { return message_.c_str(); }
  /// The step of the lab, "L3.2".
  const std::string& step() const { return step_; }
  /// The name of the missing function.
  const std::string& function() const { return function_; }
  /// The number of the lab, from its step: 3 for "L3.2".
  int lab() const { return std::stoi(step_.substr(1)); }

 private:
  std::string step_;
  std::string function_;
  std::string message_;
};

}  // namespace cs550
