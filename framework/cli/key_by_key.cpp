#include "key_by_key.hpp"

#include <poll.h>
#include <unistd.h>

namespace cs550::cli {

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
