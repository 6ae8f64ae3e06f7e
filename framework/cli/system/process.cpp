#include "cli/system/process.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>
#include <thread>

namespace cs550::cli {
namespace {

constexpr int cannot_start = 127;
constexpr std::chrono::milliseconds glance{5};  ///< short beside the time of a test run
constexpr std::chrono::seconds time_to_end{
    10};  ///< enough for a sanitizer to read debug information

std::vector<char*> as_arguments(const std::vector<std::string>& command) {
  std::vector<char*> arguments;
  arguments.reserve(command.size() + 1);
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  return arguments;
}

void limit(decltype(RLIMIT_AS) resource, std::uint64_t most) {
  const rlimit limit{most, most};
  setrlimit(resource, &limit);
}

void apply(const Limits& limits) {
  if (limits.memory > 0) limit(RLIMIT_AS, limits.memory);
  if (limits.output > 0) limit(RLIMIT_FSIZE, limits.output);
  if (limits.memory > 0 || limits.output > 0) limit(RLIMIT_CORE, 0);
}

/// In the child: only calls that are safe after fork().
[[noreturn]] void start(char* const* arguments, const Surroundings& surroundings) {
  const char* folder = surroundings.folder.c_str();
  const char* output = surroundings.output.c_str();
  apply(surroundings.limits);
  if (*folder != '\0' && chdir(folder) != 0) _exit(cannot_start);
  if (*output != '\0') {
    const int file = open(output, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (file < 0) _exit(cannot_start);
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
  }
  execvp(arguments[0], arguments);
  _exit(cannot_start);
}

/// A temporary file that vanishes with the process, however that ends.
class NamelessFile {
 public:
  NamelessFile() {
    std::string name = (std::filesystem::temp_directory_path() / "cs550.XXXXXX").string();
    descriptor_ = mkostemp(name.data(), O_CLOEXEC);
    if (descriptor_ < 0) throw std::system_error(errno, std::generic_category(), name);
    unlink(name.c_str());
  }
  ~NamelessFile() { close(descriptor_); }
  NamelessFile(const NamelessFile&) = delete;
  NamelessFile& operator=(const NamelessFile&) = delete;

  /// For this process, and for its children until they run another program.
  std::string path() const { return "/dev/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_ = -1;
};

/// Whether a program can be started. One found along PATH is not looked for.
bool is_startable(const std::string& program) {
  return program.find('/') != std::string::npos && access(program.c_str(), X_OK) == 0;
}

}  // namespace

bool Ending::printed_too_much() const { return signal == SIGXFSZ; }

std::string Ending::in_words() const {
  if (stopped) return "stopped: it did not end in time (an endless loop?)";
  if (printed_too_much()) return "stopped: it printed too much (a loop that prints without end?)";
  if (signal != 0) return std::string("crashed: ") + strsignal(signal);
  return "the program exited during the test, with exit code " + std::to_string(exit_code);
}

// Sanitizers reserve terabytes of address space, which they do not use.
Limits students_limits(bool sanitized) {
  constexpr std::uint64_t memory = std::uint64_t{4} << 30;
  constexpr std::uint64_t output = std::uint64_t{64} << 20;
  return {sanitized ? 0 : memory, output};
}

Ending run(const std::vector<std::string>& command, const Surroundings& surroundings) {
  const std::vector<char*> arguments = as_arguments(command);
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) start(arguments.data(), surroundings);

  using Clock = std::chrono::steady_clock;
  Ending ending;
  Clock::time_point last_moment;
  int status = 0;
  while (waitpid(child, &status, WNOHANG) != child) {
    if (!ending.stopped && surroundings.is_stuck()) {
      ending.stopped = true;
      last_moment = Clock::now() + time_to_end;
      kill(child, surroundings.stop_signal);
    }
    if (ending.stopped && Clock::now() > last_moment) kill(child, SIGKILL);
    std::this_thread::sleep_for(glance);
  }
  if (WIFSIGNALED(status)) ending.signal = WTERMSIG(status);
  if (WIFEXITED(status)) ending.exit_code = WEXITSTATUS(status);
  // The dynamic linker exits with the same code if a program lacks a function.
  if (ending.exit_code == cannot_start && !is_startable(command.front())) {
    throw std::system_error(ENOENT, std::generic_category(), command.front());
  }
  return ending;
}

std::string read_output(const std::filesystem::path& file, const Ending& ending) {
  constexpr std::size_t beginning = 2000;
  std::ifstream stream(file, std::ios::binary);
  if (!ending.printed_too_much()) return {std::istreambuf_iterator<char>(stream), {}};
  std::string text(beginning, '\0');
  stream.read(text.data(), beginning);
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text + "...\n";
}

std::string output_of(const std::vector<std::string>& command,
                      const std::filesystem::path& folder) {
  const NamelessFile file;
  const Ending ending = run(command, {folder, file.path()});
  std::string text = read_output(file.path(), ending);
  if (!ending.good()) throw std::runtime_error(command.front() + " failed: " + text);
  return text;
}

void become(const std::vector<std::string>& command) {
  execvp(command.front().c_str(), as_arguments(command).data());
  throw std::system_error(errno, std::generic_category(), command.front());
}

}  // namespace cs550::cli
