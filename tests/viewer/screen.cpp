#include "screen.hpp"

#include <unistd.h>

#include <cstdlib>

namespace cs550::test {

Screen::Screen() {
  if (const char* display = std::getenv("DISPLAY")) former_display_ = display;
  int ends[2];
  if (pipe(ends) != 0) return;
  server_.emplace(std::vector<std::string>{"Xvfb", "-displayfd", "1", "-screen", "0", "1400x900x24",
                                           "-nolisten", "tcp"},
                  ends[1]);
  close(ends[1]);
  std::string number;
  for (char digit = 0; read(ends[0], &digit, 1) == 1 && digit != '\n';) number += digit;
  close(ends[0]);
  if (!number.empty()) setenv("DISPLAY", (":" + number).c_str(), 1);
  is_there_ = !number.empty();
}

Screen::~Screen() {
  if (former_display_) {
    setenv("DISPLAY", former_display_->c_str(), 1);
  } else {
    unsetenv("DISPLAY");
  }
}

}  // namespace cs550::test
