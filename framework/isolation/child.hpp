#pragma once
/// @file child.hpp
/// A child process for code that may crash or never return.

#include <sys/types.h>

#include <functional>
#include <optional>
#include <string>

#include "isolation/channel.hpp"

namespace cs550::isolation {

/// A fork of this process that answers messages. It ends with this object. Its address space is
/// limited.
class Child {
 public:
  /// @param work runs in the child, which exits when it returns
  explicit Child(const std::function<void(Channel&)>& work);
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// The messages to and from the child.
  Channel& channel() { return *channel_; }
  /// Ends the child. @return how it ended: "crashed: Segmentation fault"
  std::string end();

 private:
  pid_t process_ = -1;
  std::optional<Channel> channel_;
};

}  // namespace cs550::isolation
