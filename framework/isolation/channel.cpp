#include "isolation/channel.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>

namespace cs550::isolation {
namespace {

using Clock = std::chrono::steady_clock;
using Length = std::uint64_t;

constexpr std::size_t chunk = std::size_t{64} << 10U;  ///< bytes received at a time

/// @return whether there is something to read, or the end of it, before the deadline
bool wait_for_input(int socket, std::optional<Clock::time_point> deadline) {
  pollfd watched{socket, POLLIN, 0};
  while (true) {
    int milliseconds = -1;
    if (deadline) {
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(*deadline - Clock::now());
      milliseconds = static_cast<int>(std::max<std::int64_t>(left.count(), 0));
    }
    const int ready = poll(&watched, 1, milliseconds);
    if (ready > 0) return true;
    if (ready == 0) return false;
    if (errno != EINTR) return true;
  }
}

}  // namespace

Channel::~Channel() { close(socket_); }

bool Channel::send(const std::string& message) {
  Length length = message.size();
  std::array<iovec, 2> parts{
      {{&length, sizeof length}, {const_cast<char*>(message.data()), message.size()}}};
  msghdr header{};
  header.msg_iov = parts.data();
  header.msg_iovlen = parts.size();
  while (header.msg_iovlen > 0) {
    // Not writev(): a reader that is gone must not end this process by SIGPIPE.
    const ssize_t sent = sendmsg(socket_, &header, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    auto count = static_cast<std::size_t>(sent);
    while (header.msg_iovlen > 0 && count >= header.msg_iov->iov_len) {
      count -= header.msg_iov->iov_len;
      ++header.msg_iov;
      --header.msg_iovlen;
    }
    if (header.msg_iovlen > 0) {
      header.msg_iov->iov_base = static_cast<char*>(header.msg_iov->iov_base) + count;
      header.msg_iov->iov_len -= count;
    }
  }
  return true;
}

void Channel::limit_sending(std::chrono::milliseconds limit) {
  const timeval time{static_cast<time_t>(limit.count() / 1000),
                     static_cast<suseconds_t>((limit.count() % 1000) * 1000)};
  setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &time, sizeof time);
}

bool Channel::take_message(std::string& message) {
  Length length = 0;
  if (pending_.size() < sizeof length) return false;
  std::memcpy(&length, pending_.data(), sizeof length);
  if (pending_.size() - sizeof length < length) return false;
  message.assign(pending_, sizeof length, length);
  pending_.erase(0, sizeof length + length);
  return true;
}

Channel::Wait Channel::receive(std::string& message,
                               std::optional<std::chrono::milliseconds> limit) {
  std::optional<Clock::time_point> deadline;
  if (limit) deadline = Clock::now() + *limit;
  while (!take_message(message)) {
    if (pending_.size() > longest_ + sizeof(Length)) return Wait::TooLong;
    if (!wait_for_input(socket_, deadline)) return Wait::TooLate;
    char part[chunk];
    const ssize_t got = recv(socket_, part, chunk, 0);
    if (got == 0 || (got < 0 && errno != EINTR)) return Wait::Closed;
    if (got > 0) pending_.append(part, static_cast<std::size_t>(got));
  }
  return Wait::Received;
}

bool Channel::has_input() const {
  pollfd watched{socket_, POLLIN, 0};
  return !pending_.empty() || poll(&watched, 1, 0) > 0;
}

}  // namespace cs550::isolation
