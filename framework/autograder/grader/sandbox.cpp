#include "autograder/grader/sandbox.hpp"

#include <fcntl.h>
#include <grp.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>
#include <thread>

#include "autograder/grader/message.hpp"
#include "autograder/grader/place.hpp"
#include "files/interruption.hpp"

namespace cs550::grader {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr const char* bubblewrap = "/usr/bin/bwrap";
constexpr int cannot_start = 127;

/// What a program and the compiler need of the system, read only.
void add_system(std::vector<std::string>& words) {
  const auto add = [&](std::initializer_list<std::string> more) {
    words.insert(words.end(), more);
  };
  for (const char* folder : seen_by_submissions) {
    std::error_code absent;
    if (fs::is_symlink(folder, absent)) {
      add({"--symlink", fs::read_symlink(folder).string(), folder});
    } else {
      add({"--ro-bind-try", folder, folder});
    }
  }
  add({"--ro-bind-try", "/etc/ld.so.cache", "/etc/ld.so.cache"});
  add({"--ro-bind-try", "/etc/alternatives", "/etc/alternatives"});
  add({"--dev", "/dev", "--size", "67108864", "--tmpfs", "/tmp"});
}

/// The command inside of a sandbox.
std::vector<std::string> in_bubblewrap(const Command& command) {
  const std::string nobody = "65534";
  std::vector<std::string> words{
      bubblewrap, "--unshare-all",     "--unshare-user", "--uid",      nobody, "--gid",
      nobody,     "--die-with-parent", "--new-session",  "--cap-drop", "ALL",  "--clearenv"};
  const auto add = [&](std::initializer_list<std::string> more) {
    words.insert(words.end(), more);
  };
  add_system(words);
  for (const fs::path& path : command.readable) add({"--ro-bind", path.string(), path.string()});
  const std::string folder = command.folder.string();
  add({command.writes ? "--bind" : "--ro-bind", folder, folder, "--chdir", folder});
  for (const auto& [seen, source] : command.mounted) {
    add({"--ro-bind", source.string(), seen.string()});
  }
  for (const std::string& variable : command.environment) {
    const std::size_t equals = variable.find('=');
    add({"--setenv", variable.substr(0, equals), variable.substr(equals + 1)});
  }
  add({"--"});
  words.insert(words.end(), command.words.begin(), command.words.end());
  return words;
}

/// A file in memory that cannot grow: what does not fit is lost.
int fixed_file(std::size_t size) {
  const int file = memfd_create("output", MFD_CLOEXEC | MFD_ALLOW_SEALING);
  if (file < 0 || ftruncate(file, static_cast<off_t>(size)) != 0 ||
      fcntl(file, F_ADD_SEALS, F_SEAL_GROW | F_SEAL_SHRINK | F_SEAL_SEAL) != 0) {
    throw std::system_error(errno, std::generic_category(), "memfd_create");
  }
  return file;
}

void limit(int resource, rlim_t value) {
  const rlimit both{value, value};
  setrlimit(static_cast<__rlimit_resource>(resource), &both);
}

/// What a new process does before the program: only calls that are safe after fork().
struct Start {
  std::vector<char*> words;
  std::vector<char*> environment;
  const char* folder;
  Limits limits;
  bool becomes_nobody;
  int output;
  int channel;

  [[noreturn]] void run() const {
    setsid();
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, STDIN_FILENO);
    dup2(output, STDOUT_FILENO);
    dup2(output, STDERR_FILENO);
    if (channel == worker_channel) {
      fcntl(channel, F_SETFD, 0);  // dup2() to itself would leave it to be closed in the program
    } else if (channel >= 0) {
      dup2(channel, worker_channel);
    }
    close_range(channel >= 0 ? worker_channel + 1 : worker_channel, ~0U, 0);
    limit(RLIMIT_CPU, static_cast<rlim_t>(limits.cpu.count()));
    limit(RLIMIT_AS, limits.memory);
    limit(RLIMIT_FSIZE, limits.file_size);
    limit(RLIMIT_CORE, 0);
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    if (chdir(folder) != 0) _exit(cannot_start);
    if (becomes_nobody) {
      constexpr uid_t nobody = 65534;
      limit(RLIMIT_NPROC, limits.processes);
      if (setgroups(0, nullptr) != 0 || setresgid(nobody, nobody, nobody) != 0 ||
          setresuid(nobody, nobody, nobody) != 0) {
        _exit(cannot_start);
      }
      prctl(PR_SET_PDEATHSIG, SIGKILL);  // a change of the user has cleared it
    }
    execve(words[0], words.data(), environment.data());
    _exit(cannot_start);
  }
};

bool works(const std::vector<std::string>& words) {
  try {
    Command command;
    command.words = words;
    command.folder = "/usr";
    Process process(command, 4096);
    return process.wait(std::chrono::seconds(10)) && process.succeeded();
  } catch (const std::system_error&) {
    return false;
  }
}

/// The code point that starts here and its length in bytes; length 0 if it is not valid UTF-8.
std::pair<char32_t, std::size_t> code_point(std::string_view text) {
  const auto first = static_cast<unsigned char>(text.front());
  if (first < 0x80) return {first, 1};
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || text.size() < length) return {0, 0};
  char32_t point = first & (0x7fU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    const auto next = static_cast<unsigned char>(text[i]);
    if ((next & 0xc0U) != 0x80) return {0, 0};
    point = point << 6U | (next & 0x3fU);
  }
  return {point, length};
}

/// Characters that change how the text around them is displayed.
bool is_control(char32_t point) {
  return (point < 0x20 && point != '\n') || (point >= 0x7f && point < 0xa0) ||
         (point >= 0x200b && point <= 0x200f) || (point >= 0x2028 && point <= 0x202e) ||
         (point >= 0x2060 && point <= 0x206f) || (point >= 0xd800 && point <= 0xdfff) ||
         point == 0xfeff;
}

}  // namespace

void kill_orphans() {
  std::ifstream children("/proc/self/task/" + std::to_string(getpid()) + "/children");
  for (pid_t child = 0; children >> child;) {
    ::kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
  }
}

std::vector<char*> pointers(const std::vector<std::string>& words) {
  std::vector<char*> result;
  result.reserve(words.size() + 1);
  for (const std::string& word : words) result.push_back(const_cast<char*>(word.c_str()));
  result.push_back(nullptr);
  return result;
}

Isolation best_isolation() {
  static const bool wrapped = access(bubblewrap, X_OK) == 0 && works({"/usr/bin/true"});
  return wrapped ? Isolation::Bubblewrap : Isolation::Plain;
}

std::string to_string(Isolation isolation) {
  return isolation == Isolation::Bubblewrap ? "bubblewrap" : "plain";
}

Process::Process(const Command& command, std::size_t kept, int channel) {
  const bool wrapped = command.isolation == Isolation::Bubblewrap;
  const std::vector<std::string> words = wrapped ? in_bubblewrap(command) : command.words;
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  output_ = fixed_file(kept);
  const Start start{pointers(words),
                    pointers(command.environment),
                    command.folder.c_str(),
                    command.limits,
                    !wrapped && !command.confines_itself && geteuid() == 0,
                    output_,
                    channel};
  process_ = fork();
  if (process_ < 0) {
    close(output_);
    throw std::system_error(errno, std::generic_category(), "fork");
  }
  if (process_ == 0) start.run();
}

Process::~Process() {
  kill();
  close(output_);
}

bool Process::wait(std::chrono::milliseconds limit) {
  const Clock::time_point deadline = Clock::now() + limit;
  auto pause = std::chrono::microseconds(100);
  while (!ended_ && waitpid(process_, &status_, WNOHANG) != process_) {
    if (Clock::now() > deadline) return false;
    files::throw_if_interrupted();
    std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, std::chrono::microseconds(5000));
  }
  ended_ = true;
  return true;
}

void Process::kill() {
  ::kill(-process_, SIGKILL);
  if (!ended_) {
    waitpid(process_, &status_, 0);
    ended_ = true;
  }
  kill_orphans();
}

int Process::signal() const {
  if (WIFSIGNALED(status_)) return WTERMSIG(status_);
  // Bubblewrap passes on the signal that killed its program as 128 and the signal.
  const int code = WIFEXITED(status_) ? WEXITSTATUS(status_) : 0;
  return code > 128 ? code - 128 : 0;
}

std::string Process::ending() const {
  if (signal() != 0) return std::string("crashed: ") + strsignal(signal());
  const int code = WIFEXITED(status_) ? WEXITSTATUS(status_) : 0;
  return code == 0 ? "" : "ended with exit code " + std::to_string(code);
}

std::string Process::output() const {
  struct stat file {};
  fstat(output_, &file);
  std::string text(static_cast<std::size_t>(file.st_size), '\0');
  const ssize_t got = pread(output_, text.data(), text.size(), 0);
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  while (!text.empty() && text.back() == '\0') text.pop_back();
  return readable_text(text, text.size());
}

std::string readable_text(std::string_view text, std::size_t most) {
  constexpr std::string_view cut = "…";
  std::string result;
  while (!text.empty()) {
    const auto [point, length] = code_point(text);
    const bool keep = length > 0 && !is_control(point);
    if (keep && result.size() + length > most) {
      while (!result.empty() && (result.size() + cut.size() > most ||
                                 (static_cast<unsigned char>(result.back()) & 0xc0U) == 0x80)) {
        result.pop_back();
      }
      return most < cut.size() ? "" : result + std::string(cut);
    }
    if (keep) result += text.substr(0, length);
    if (point == '\t') result += ' ';
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result;
}

}  // namespace cs550::grader
