#pragma once
/// @file child.hpp
/// A child process for code that may crash or never return.

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <optional>
#include <string>

namespace cs550::isolation {

/// One end of a pair of sockets that carries messages.
class Channel {
 public:
  explicit Channel(int socket) : socket_(socket) {}
  ~Channel();
  Channel(const Channel&) = delete;
  Channel& operator=(const Channel&) = delete;

  /// @return whether the other end is still open
  bool send(const std::string& message) const;

  /// The outcome of waiting for a message.
  enum class Wait { Received, Closed, TooLate };
  /// @param limit no limit if empty
  Wait receive(std::string& message, std::optional<std::chrono::milliseconds> limit) const;

 private:
  int socket_;
};

/// A fork of this process that answers messages. It ends with this object. Its address space is
/// limited.
class Child {
 public:
  /// @param work runs in the child, which exits when it returns
  explicit Child(const std::function<void(const Channel&)>& work);
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// The messages to and from the child.
  const Channel& channel() const { return *channel_; }
  /// Ends the child. @return how it ended: "crashed: Segmentation fault"
  std::string end();

 private:
  pid_t process_ = -1;
  std::optional<Channel> channel_;
};

}  // namespace cs550::isolation
