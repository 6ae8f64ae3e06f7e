#pragma once
/// @file sandbox.hpp
/// Processes that run a stranger's code, or compile it.

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace cs550::grader {

/// How a process is kept from the rest of the machine.
enum class Isolation {
  Bubblewrap,  ///< name spaces of its own: a view of a few files, no network, no other processes
  Plain,       ///< limits and an unprivileged user where we are root
};

/// Bubblewrap if a probe shows that it works here.
Isolation best_isolation();
std::string to_string(Isolation isolation);

struct Limits {
  std::chrono::seconds cpu{60};
  std::size_t memory = std::size_t{2} << 30U;      ///< bytes of address space
  std::size_t file_size = std::size_t{64} << 20U;  ///< bytes
  /// Of the user who runs all submissions of a machine, without bubblewrap.
  std::size_t processes = 256;
};

/// What runs, and what it can see.
struct Command {
  std::vector<std::string> words;               ///< the program's absolute path, and its arguments
  std::vector<std::filesystem::path> readable;  ///< files and folders, at their own paths
  std::filesystem::path folder;                 ///< working directory; writable if `writes`
  /// Folders that are seen in other places, read-only. Bubblewrap only.
  std::map<std::filesystem::path, std::filesystem::path> mounted;
  bool writes = false;
  bool confines_itself = false;  ///< gives up its privileges by itself
  std::vector<std::string> environment;
  Isolation isolation = Isolation::Bubblewrap;
  Limits limits;
};

/// A process with an empty environment, no descriptors but its channel and its output, and a
/// process group of its own. It ends, with all of its children, when this object does.
class Process {
 public:
  /// @param kept bytes of output that are kept; the rest is lost
  /// @param channel becomes descriptor `worker_channel`; -1 for none
  /// @throws std::system_error if it cannot be started
  Process(const Command& command, std::size_t kept, int channel = -1);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Waits until it ends by itself. @return false if it was still running after the limit
  /// @throws std::runtime_error if this program is interrupted
  bool wait(std::chrono::milliseconds limit);
  /// Kills it and its children, if they still run.
  void kill();
  /// "crashed: Segmentation fault", "ended with exit code 3"; empty for exit code 0.
  std::string ending() const;
  /// The signal that ended the program; 0 if none did.
  int signal() const;
  bool succeeded() const { return ended_ && status_ == 0; }
  /// The start of what it printed, without control characters.
  std::string output() const;

 private:
  pid_t process_ = -1;
  int output_ = -1;
  int status_ = 0;
  bool ended_ = false;
};

/// Kills this program's children. Those that lost their parent are among them, once it has started a Process.
void kill_orphans();

/// The words as execve() takes them: pointers to their characters, then a null pointer.
std::vector<char*> pointers(const std::vector<std::string>& words);

/// Text without control characters other than line ends, in valid UTF-8, of at most `most` bytes.
std::string readable_text(std::string_view text, std::size_t most);

}  // namespace cs550::grader
