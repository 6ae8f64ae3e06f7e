#include "isolation/child.hpp"

#include <poll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <system_error>
#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace cs550::isolation {
namespace {

using Clock = std::chrono::steady_clock;

/// Limit of the address space (bytes). An endless allocation must not exhaust the machine.
constexpr rlim_t memory_limit = rlim_t{8} << 30;

/// @return whether there is data or an end of file before the deadline
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

Channel::Wait read_all(int socket, char* bytes, std::size_t count,
                       std::optional<Clock::time_point> deadline) {
  while (count > 0) {
    if (!wait_for_input(socket, deadline)) return Channel::Wait::TooLate;
    const ssize_t got = read(socket, bytes, count);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return Channel::Wait::Closed;
    bytes += got;
    count -= got;
  }
  return Channel::Wait::Received;
}

bool write_all(int socket, const char* bytes, std::size_t count) {
  while (count > 0) {
    // Not write(), which raises SIGPIPE if the other process has ended.
    const ssize_t sent = ::send(socket, bytes, count, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    bytes += sent;
    count -= sent;
  }
  return true;
}

void limit_child() {
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // an endless loop must not survive a killed viewer
#endif
  const rlimit memory{memory_limit, memory_limit};
  setrlimit(RLIMIT_AS, &memory);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
}

}  // namespace

Channel::~Channel() { close(socket_); }

bool Channel::send(const std::string& message) const {
  const std::uint64_t length = message.size();
  return write_all(socket_, reinterpret_cast<const char*>(&length), sizeof length) &&
         write_all(socket_, message.data(), message.size());
}

Channel::Wait Channel::receive(std::string& message,
                               std::optional<std::chrono::milliseconds> limit) const {
  std::optional<Clock::time_point> deadline;
  if (limit) deadline = Clock::now() + *limit;
  std::uint64_t length = 0;
  Wait wait = read_all(socket_, reinterpret_cast<char*>(&length), sizeof length, deadline);
  if (wait != Wait::Received) return wait;
  message.resize(length);
  return read_all(socket_, message.data(), message.size(), deadline);
}

Child::Child(const std::function<void(const Channel&)>& work) {
  int sockets[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) != 0) {
    throw std::system_error(errno, std::generic_category(), "socketpair");
  }
  process_ = fork();
  if (process_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (process_ == 0) {
    close(sockets[0]);
    limit_child();
    {
      const Channel channel(sockets[1]);
      work(channel);
    }
    _exit(0);  // without the destructors of the viewer's objects, such as its window
  }
  close(sockets[1]);
  channel_.emplace(sockets[0]);
}

Child::~Child() { end(); }

std::string Child::end() {
  if (process_ < 0) return "";
  // A child that has closed its channel is about to end. How it ends explains more than SIGKILL.
  int status = 0;
  pollfd watched{-1, 0, 0};
  for (int patience = 50; patience > 0 && waitpid(process_, &status, WNOHANG) == 0; --patience) {
    if (patience == 1) {
      kill(process_, SIGKILL);
      waitpid(process_, &status, 0);
    } else {
      poll(&watched, 0, 1);
    }
  }
  process_ = -1;
  if (WIFSIGNALED(status)) return std::string("crashed: ") + strsignal(WTERMSIG(status));
  return "ended with exit code " + std::to_string(WEXITSTATUS(status));
}

}  // namespace cs550::isolation
