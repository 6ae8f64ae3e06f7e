#pragma once
/// @file terminal.hpp
/// What a terminal adds to plain output: colours, lines of at most 80 columns, a progress bar,
/// single keys.

#include <termios.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "files/indented.hpp"

namespace cs550::cli {

enum class Colour { Red, Green, Yellow, Bold, Faint };

/// The text in a colour; plain when standard output is no terminal, or NO_COLOR is set.
std::string coloured(std::string_view text, Colour colour);

using files::indented;

/// The text filled up to `width` columns with spaces.
std::string padded(const std::string& text, std::size_t width);

/// A length of time that is only roughly known: "40 s", "12 min", "1 h 40 min".
std::string duration_text(std::chrono::seconds time);

/// Prints what is about to run. On a terminal the next output replaces the line, and empty text
/// clears it.
void show_status(const std::string& text);

/// What is running, if it takes longer than 2 s: on a terminal a line that changes twice a second, else a
/// line every 10 s.
class StatusLine {
 public:
  StatusLine() = default;
  ~StatusLine() { clear(); }
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  /// Called often; calls `text` only if it is time for a line.
  void show(const std::function<std::string()>& text);
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point next_ = Clock::now() + std::chrono::seconds(2);
  bool visible_ = false;
};

/// How far a long run has come, and how long it still takes: one line on standard error that changes
/// in place. Nothing is shown where standard error is no terminal, or in the first half second.
class ProgressBar {
 public:
  /// @param step what is counted
  explicit ProgressBar(int total, std::string step = "step")
      : total_(total), step_(std::move(step)) {}
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// @param done steps, of the total
  void show(int done);

 private:
  using Clock = std::chrono::steady_clock;
  int total_;
  std::string step_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_ = start_ + std::chrono::milliseconds(500);
  bool visible_ = false;
};

/// While this object lives, keys are read one by one and are not echoed.
class KeyByKey {
 public:
  KeyByKey();
  ~KeyByKey();
  KeyByKey(const KeyByKey&) = delete;
  KeyByKey& operator=(const KeyByKey&) = delete;

  /// The next key, or 0 when none comes within 0.2 s; 'q' when the terminal is gone.
  static char wait();

 private:
  termios before_{};
};

}  // namespace cs550::cli
