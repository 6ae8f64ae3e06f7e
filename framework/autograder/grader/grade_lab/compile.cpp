#include "autograder/grader/grade_lab/compile.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "autograder/grader/grade_lab/options.hpp"
#include "files/source_name.hpp"

namespace cs550::grader {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kept_errors = 256U << 10U;  ///< bytes of what the compiler prints
constexpr std::size_t shown_errors = 4096;        ///< bytes of it that are reported
constexpr std::uintmax_t largest_file = 1U << 20U;
constexpr int most_files = 100;

/// Why a submission cannot be compiled.
struct Refusal : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A compiler, assembler or linker that was stopped, which may not be the fault of what it compiled.
struct Stopped : Refusal {
  Stopped() : Refusal("the compiler was stopped at its limit of time, or for lack of memory") {}
};

/// A folder that only we and the compiler can enter, which is removed at the end.
class Stage {
 public:
  explicit Stage(Isolation isolation) {
    std::string name = (fs::temp_directory_path() / "cs550_grade.XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
      throw std::system_error(errno, std::generic_category(), name);
    }
    path_ = name;
    fs::create_directory(path_ / "out");
    fs::permissions(path_ / "out", fs::perms::owner_all);
    if (isolation == Isolation::Plain && geteuid() == 0) open_to_nobody();
  }
  ~Stage() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;
  const fs::path& path() const { return path_; }

 private:
  /// The compiler then runs as another user, who may write to out/ only.
  void open_to_nobody() const {
    constexpr unsigned nobody = 65534;
    fs::permissions(path_, fs::perms::group_read | fs::perms::group_exec, fs::perm_options::add);
    if (chown(path_.c_str(), 0, nobody) != 0 ||
        chown((path_ / "out").c_str(), nobody, nobody) != 0) {
      throw std::system_error(errno, std::generic_category(), path_.string());
    }
  }

  fs::path path_;
};

/// Copies the sources. @return those to compile, relative to the stage: as in a student's build, the
/// .cpp files of the lab's own folder. Those below it may be included.
std::vector<fs::path> copy_sources(const fs::path& from, const fs::path& to, const fs::path& root,
                                   Part part) {
  std::vector<fs::path> sources;
  int count = 0;
  const auto options = fs::directory_options::none;  // does not follow links to folders
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(from, options)) {
    const fs::path name = entry.path().lexically_relative(from);
    const bool is_file = !entry.is_symlink() && entry.is_regular_file();
    if (!is_file || !files::is_source(name) || !files::has_plain_name(name)) continue;
    if (++count > most_files) throw Refusal("more than " + std::to_string(most_files) + " files");
    if (entry.file_size() > largest_file) throw Refusal(name.string() + " is larger than 1 MB");
    fs::create_directories((to / name).parent_path());
    fs::copy_file(entry.path(), to / name);
    const bool is_compiled = name.extension() == ".cpp" && !name.has_parent_path() &&
                             (name == own_tests_file) == (part == Part::OwnTests);
    if (is_compiled) sources.push_back((to / name).lexically_relative(root));
  }
  if (sources.empty())
    throw Refusal("there is no .cpp file in the submission's folder of this lab");
  std::sort(sources.begin(), sources.end());
  return sources;
}

std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

/// A file that was read must be the system's, the contract's or the submission's.
void check_file(const std::string& file, const fs::path& stage) {
  const std::string name = (stage / file).lexically_normal().string();
  if (name.starts_with("/usr/") || name.starts_with(stage.string() + '/')) return;
  throw Refusal("the submission reads a file that is not part of it: " + file);
}

/// What the compiler printed, without the names of the files that it included (-H: ". NAME", or
/// "! NAME" if it is precompiled). A name comes before all that is quoted of the file, so that nothing
/// is quoted of a file that is not the submission's. @throws Refusal for such a file
std::string checked_output(const std::string& output, const fs::path& stage) {
  std::string messages;
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t depth = line.find_first_not_of(".!x");
    const bool is_include = depth != 0 && depth != std::string::npos && line[depth] == ' ';
    const bool is_whole = !lines.eof();  // what does not fit is cut
    if (is_include && is_whole) {
      check_file(line.substr(depth + 1), stage);
    } else {
      messages += line + '\n';
    }
  }
  return messages;
}

/// Whether a file of so many bytes fits into a folder. Some of a disk may be for root only, as whom the compiler does
/// not run, and a quota may leave less than the disk has.
bool has_room(const fs::path& folder, std::size_t size) {
  if (fs::space(folder).available < size) return false;
  const fs::path name = folder / "room";
  const int file = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (file < 0) return false;
  const bool fits = posix_fallocate(file, 0, static_cast<off_t>(size)) == 0;
  close(file);
  fs::remove(name);
  return fits;
}

/// Runs compiler, assembler and linker on the stage.
class Compiler {
 public:
  Compiler(fs::path stage, const Order& order) : order_(order) {
    const fs::path precompiled = stage / "precompiled";
    if (order.isolation == Isolation::Bubblewrap) {
      command_.mounted = {{precompiled, CS550_PRECOMPILED}};
    } else {
      // The compiler may run as another user, who cannot enter our folders and must not write to them.
      fs::copy(CS550_PRECOMPILED, precompiled);
    }
    command_.folder = std::move(stage);
    command_.writes = true;
    command_.isolation = order.isolation;
    command_.limits = compiler_limits(order);
    // Relative, because another user may not be able to enter the folders above the stage.
    command_.environment = {"PATH=/usr/bin:/bin", "LC_ALL=C.UTF-8", "TMPDIR=out"};
  }

  /// From C++ to assembler. @throws Refusal with what it printed
  void compile(const fs::path& file, const std::string& options, const std::string& object) {
    std::vector<std::string> arguments = words(options);
    arguments.insert(arguments.end(),
                     {"-H", "-MF", object + ".d", "-S", file.string(), "-o", object + ".s"});
    if (const std::optional<std::string> printed = failure(arguments)) {
      throw Refusal(checked_output(*printed, command_.folder));
    }
  }

  /// From assembler to an object file. What the assembler prints is not reported: it can be made to
  /// quote a file without naming it. @throws Refusal
  void assemble(const std::string& object) {
    if (failure({"-Wa,--MD=" + object + ".s.d", "-c", object + ".s", "-o", object + ".o"})) {
      throw Refusal("the assembler fails on an asm statement");
    }
  }

  /// @param others libraries that are loaded with this one, from its folder; the linker does not check
  /// whether it needs them
  /// @throws Refusal with what the linker printed
  void link(const std::vector<std::string>& objects, const std::vector<std::string>& others,
            const std::string& library) {
    std::vector<std::string> arguments =
        words("-shared -Wl,-z,lazy -Wl,-Bsymbolic -Wl,--version-script=exports.map");
    arguments.insert(arguments.end(), objects.begin(), objects.end());
    arguments.insert(arguments.end(), {"-Wl,--no-as-needed", "-Wl,-rpath,$ORIGIN"});
    arguments.insert(arguments.end(), others.begin(), others.end());
    arguments.insert(arguments.end(), {"-o", library});
    if (const std::optional<std::string> printed = failure(arguments)) throw Refusal(*printed);
  }

 private:
  /// Whether it was killed, or a program that it ran: GCC and Clang are drivers, and report that of a part on a line
  /// that begins with the driver's name, and may end with that of the part. Text of a submission follows the name of
  /// its file, which #line may choose, and a colon. Text with a line break could pass for a report, but earns timeouts
  /// only.
  static bool was_killed(const Process& process) {
    if (process.signal() == SIGKILL) return true;
    const std::string driver = fs::path(CS550_COMPILER).filename();
    const std::string reports[] = {driver + ": fatal error: Killed signal terminated program",
                                   driver + ": error: unable to execute command: Killed",
                                   "clang: error: unable to execute command: Killed",  // clang++
                                   "collect2: fatal error: ld terminated with signal 9 [Killed]"};
    std::istringstream lines(process.output());
    for (std::string line; std::getline(lines, line);) {
      for (const std::string& report : reports) {
        const bool ends_there = line.find(':', report.size()) == std::string::npos;
        if (line.starts_with(report) && ends_there) return true;
      }
    }
    return false;
  }

  /// After a failed step: whether this machine can compile anything. The largest file that a step may write must fit.
  /// What the submission has filled the disk with is removed before, so that it is its own failure.
  /// @throws std::runtime_error if it cannot
  void check_machine() {
    for (const fs::path& file : fs::directory_iterator(command_.folder / "out"))
      fs::remove_all(file);
    if (!has_room(command_.folder, command_.limits.file_size)) {
      throw std::runtime_error("a compilation needs " +
                               std::to_string(command_.limits.file_size >> 20U) + " MB in " +
                               fs::temp_directory_path().string() + ", and less is free");
    }
    Process process = start({"--version"});
    if (!process.wait(std::chrono::seconds(10)) || !process.succeeded())
      throw std::runtime_error("the compiler cannot be started: " + process.output());
  }

  Process start(const std::vector<std::string>& arguments) {
    command_.words = {CS550_COMPILER};
    command_.words.insert(command_.words.end(), arguments.begin(), arguments.end());
    return Process(command_, kept_errors);
  }

  /// @return what it printed; nothing if it succeeded
  /// @throws Stopped @throws std::runtime_error if it failed for a reason that is not the submission's
  std::optional<std::string> failure(const std::vector<std::string>& arguments) {
    Process process = start(arguments);
    const bool in_time =
        process.wait(time_left(order_, command_.limits.cpu + std::chrono::seconds(5)));
    process.kill();
    if (in_time && process.succeeded()) return {};
    check_machine();
    if (!in_time || was_killed(process)) throw Stopped();
    return process.output() + process.ending();
  }

  const Order& order_;
  Command command_;
};

/// Checks everything that was read, as the compiler and the assembler list it. Where the sandbox hides
/// all other files there is nothing to find.
void check_dependencies(const fs::path& list, const fs::path& stage) {
  std::ifstream stream(list);
  if (!stream) throw Refusal("the compiler did not list the files that it read");
  for (std::string file; stream >> file;) {
    if (file == "\\" || file.ends_with(':')) continue;
    check_file(file, stage);
  }
}

/// The compiled starter of a lab. It answers for the functions that a submission lacks, as in a student's own
/// build: with "not implemented". A submission is loaded before it, so every function that both define is the
/// submission's.
fs::path starter_of(const std::string& lab_name) {
  const std::string lab = lab_name.substr(0, lab_name.find('_'));
  fs::path starter = fs::path(CS550_LAB_FOLDER) / ("lib" + lab + "_stub.so");
  if (fs::exists(starter)) return starter;
  throw std::runtime_error(starter.string() + " is missing; build it: ./cs550 build test judges");
}

void build(const fs::path& source, const std::string& lab_name, const fs::path& stage,
           const fs::path& library, const Order& order, Part part) {
  const std::vector<fs::path> sources =
      copy_sources(source, stage / "labs" / lab_name, stage, part);
  fs::copy(CS550_CONTRACT_HEADERS, stage / "contract", fs::copy_options::recursive);
  std::ofstream(stage / "exports.map") << "{ global: _ZN5cs550*; local: *; };\n";
  Compiler compiler(stage, order);
  std::string options =
      CS550_LAB_OPTIONS " -Icontract -include precompiled/lab.hpp -fmax-errors=20 -MD";
  // A function that no header declares is a misspelt one in a lab, and a helper in tests.
  if (part == Part::OwnTests) options += " -Wno-missing-declarations";
  std::vector<std::string> objects;
  for (const fs::path& file : sources) {
    const std::string object = "out/" + std::to_string(objects.size());
    compiler.compile(file, options, object);
    check_dependencies(stage / (object + ".d"), stage);
    compiler.assemble(object);
    check_dependencies(stage / (object + ".s.d"), stage);
    objects.push_back(object + ".o");
  }
  std::vector<std::string> others;
  if (part == Part::Code) {
    const fs::path starter = starter_of(lab_name);
    others.push_back(starter.filename().string());
    for (const fs::path& folder : {stage, library.parent_path()}) {
      fs::copy_file(starter, folder / starter.filename());
    }
  }
  compiler.link(objects, others, "out/library.so");
  fs::copy_file(stage / "out/library.so", library);
}

}  // namespace

Compilation compile(const fs::path& source, const std::string& lab_name, const fs::path& library,
                    const Order& order, Part part) {
  const Clock::time_point start = Clock::now();
  Compilation result;
  try {
    const Stage stage(order.isolation);
    build(source, lab_name, stage.path(), library, order, part);
    result.succeeded = true;
  } catch (const Stopped& stopped) {
    result.was_stopped = true;
    result.errors = stopped.what();
  } catch (const Refusal& refusal) {
    result.errors = readable_text(refusal.what(), shown_errors);
  }
  result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return result;
}

}  // namespace cs550::grader
