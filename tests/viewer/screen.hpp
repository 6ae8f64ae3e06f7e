#pragma once
/// @file screen.hpp
/// A virtual screen.

#include <optional>
#include <string>

#include "program.hpp"

namespace cs550::test {

/// An X server. DISPLAY names it as long as this object exists.
class Screen {
 public:
  Screen();
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  bool is_there() const { return is_there_; }

 private:
  std::optional<Background> server_;
  std::optional<std::string> former_display_;
  bool is_there_ = false;
};

}  // namespace cs550::test
