#include "cli/system/terminal.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

namespace cs550::cli {
namespace {

/// https://no-color.org: any value but an empty one asks for plain text.
bool shows_colours() {
  const char* no_color = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  return isatty(STDOUT_FILENO) != 0 && (no_color == nullptr || *no_color == '\0') &&
         (terminal == nullptr || std::string_view(terminal) != "dumb");
}

const char* escape_code(Colour colour) {
  switch (colour) {
    case Colour::Red:
      return "31";
    case Colour::Green:
      return "32";
    case Colour::Yellow:
      return "33";
    case Colour::Bold:
      return "1";
    case Colour::Faint:
      return "2";
  }
  return "0";
}

}  // namespace

std::string coloured(std::string_view text, Colour colour) {
  static const bool show = shows_colours();
  if (!show) return std::string(text);
  return std::string("\033[") + escape_code(colour) + 'm' + std::string(text) + "\033[0m";
}

std::string padded(const std::string& text, std::size_t width) {
  return text + std::string(width - std::min(width, text.size()), ' ');
}

std::string duration_text(std::chrono::seconds time) {
  constexpr long seconds = 60;
  constexpr long minutes = 60;
  const long all = time.count();
  if (all < 2 * seconds) return std::to_string(all) + " s";
  const long rounded = (all + seconds / 2) / seconds;
  if (rounded < minutes) return std::to_string(rounded) + " min";
  return std::to_string(rounded / minutes) + " h " + std::to_string(rounded % minutes) + " min";
}

void show_status(const std::string& text) {
  if (isatty(STDERR_FILENO) != 0) {
    std::cerr << "\r\033[K" << text << std::flush;
  } else if (!text.empty()) {
    std::cerr << text << std::endl;
  }
}

void StatusLine::show(const std::function<std::string()>& text) {
  const Clock::time_point now = Clock::now();
  if (now < next_) return;
  next_ = now + std::chrono::milliseconds(isatty(STDERR_FILENO) != 0 ? 500 : 10000);
  visible_ = true;
  show_status(text());
}

void StatusLine::clear() {
  if (visible_) show_status("");
  visible_ = false;
}

void ProgressBar::show(int done) {
  const Clock::time_point now = Clock::now();
  if (now < next_ || isatty(STDERR_FILENO) == 0) return;
  next_ = now + std::chrono::milliseconds(100);
  visible_ = true;

  constexpr int width = 40;
  const int filled = static_cast<int>(static_cast<long>(done) * width / total_);
  std::cerr << "\r\033[K[" << std::string(filled, '#') << std::string(width - filled, ' ') << "] "
            << step_ << ' ' << done << " of " << total_;
  if (done > 0) {
    const auto left = (now - start_) * (total_ - done) / done;
    std::cerr << ", " << duration_text(std::chrono::duration_cast<std::chrono::seconds>(left))
              << " left";
  }
  std::cerr << std::flush;
}

ProgressBar::~ProgressBar() {
  if (visible_) show_status("");
}

KeyByKey::KeyByKey() {
  tcgetattr(STDIN_FILENO, &before_);
  termios now = before_;
  now.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  tcsetattr(STDIN_FILENO, TCSANOW, &now);
}

KeyByKey::~KeyByKey() { tcsetattr(STDIN_FILENO, TCSANOW, &before_); }

char KeyByKey::wait() {
  constexpr int milliseconds = 200;
  pollfd input{STDIN_FILENO, POLLIN, 0};
  if (poll(&input, 1, milliseconds) <= 0) return 0;
  char key = 'q';
  return read(STDIN_FILENO, &key, 1) == 1 ? key : 'q';
}

}  // namespace cs550::cli
