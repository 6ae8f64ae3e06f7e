#include "isolation/child.hpp"

#include <poll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>
#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace cs550::isolation {
namespace {

/// Limit of the address space (bytes). An endless allocation must not exhaust the machine.
constexpr rlim_t memory_limit = rlim_t{8} << 30;

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

Child::Child(const std::function<void(Channel&)>& work) {
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
      Channel channel(sockets[1]);
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
