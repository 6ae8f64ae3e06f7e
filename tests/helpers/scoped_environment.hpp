#pragma once
/// @file scoped_environment.hpp
/// An environment variable of a test.

#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

namespace cs550::test {

/// Sets a variable, or removes it, until the end of the scope. Then it is as it was before, also if a
/// test ends early.
class ScopedEnvironment {
 public:
  /// @param value empty: the variable is removed
  ScopedEnvironment(std::string name, const std::optional<std::string>& value)
      : name_(std::move(name)) {
    if (const char* former = std::getenv(name_.c_str())) former_ = former;
    assign(value);
  }
  ~ScopedEnvironment() { assign(former_); }
  ScopedEnvironment(const ScopedEnvironment&) = delete;
  ScopedEnvironment& operator=(const ScopedEnvironment&) = delete;

 private:
  void assign(const std::optional<std::string>& value) const {
    if (value) {
      setenv(name_.c_str(), value->c_str(), 1);
    } else {
      unsetenv(name_.c_str());
    }
  }

  std::string name_;
  std::optional<std::string> former_;
};

}  // namespace cs550::test
