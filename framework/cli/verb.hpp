#pragma once
/// @file verb.hpp
/// What a verb of ./cs550 is. A new one is a line in verbs.def and a file that defines its
/// declare_<name>().

#include <CLI/CLI.hpp>
#include <functional>

namespace cs550::cli {

/// The exit codes of every verb.
enum ExitCode { Good = 0, Failed = 1, Misused = 2 };

/// What a verb does once its command line is understood; returns an ExitCode.
using Action = std::function<int()>;

// declare_demo(CLI::App&), declare_lab(CLI::App&) and so on: each adds the verb's options to its
// part of the command line and returns what they lead to.
#define CS550_VERB(name, preset, packages, arguments, summary) Action declare_##name(CLI::App& app);
#define CS550_SCRIPT(...)
#define CS550_PLANNED(...)
#include "verbs.def"
#undef CS550_VERB
#undef CS550_SCRIPT
#undef CS550_PLANNED

}  // namespace cs550::cli
