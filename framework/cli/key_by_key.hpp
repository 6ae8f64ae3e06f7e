#pragma once
/// @file key_by_key.hpp
/// A terminal on which one key is an answer.

#include <termios.h>

namespace cs550::cli {

/// Keys come one by one, unseen, as long as this object lives.
class KeyByKey {
 public:
  KeyByKey();
  ~KeyByKey();
  KeyByKey(const KeyByKey&) = delete;
  KeyByKey& operator=(const KeyByKey&) = delete;

  /// The next key, or 0 when none comes for a while; 'q' when the terminal is gone.
  static char wait();

 private:
  termios before_{};
};

}  // namespace cs550::cli
