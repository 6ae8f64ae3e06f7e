#pragma once
/// @file channel.hpp
/// Messages between two processes.

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

namespace cs550::isolation {

/// One end of a pair of sockets that carries messages.
class Channel {
 public:
  /// Takes over the socket. @param longest bytes of a message that this end receives
  explicit Channel(int socket, std::size_t longest = std::size_t{1} << 30U)
      : socket_(socket), longest_(longest) {}
  ~Channel();
  Channel(const Channel&) = delete;
  Channel& operator=(const Channel&) = delete;

  /// @return false if the other end is gone, or has not read for longer than limit_sending() allows
  bool send(const std::string& message);
  void limit_sending(std::chrono::milliseconds limit);

  /// How waiting for a message ended.
  enum class Wait { Received, Closed, TooLate, TooLong };
  /// @param limit no limit if empty
  Wait receive(std::string& message, std::optional<std::chrono::milliseconds> limit);
  /// Whether something can be received already.
  bool has_input() const;

 private:
  bool take_message(std::string& message);

  int socket_;
  std::size_t longest_;
  std::string pending_;  ///< received, but not taken yet
};

}  // namespace cs550::isolation
