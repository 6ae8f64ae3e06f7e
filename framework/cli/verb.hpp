#pragma once
/// @file verb.hpp
/// The verbs of ./cs550 that this program implements. A new one is a line in verbs.def and a file
/// in verbs/ that defines its declare_<name>().

#include <CLI/CLI.hpp>
#include <functional>

#include "cli/system/exit_code.hpp"

namespace cs550::cli {

/// Runs a verb whose command line was parsed; returns an ExitCode.
using Action = std::function<int()>;

// declare_lab(CLI::App&), declare_progress(CLI::App&) and so on: each adds the verb's options to its
// part of the command line and returns its action.
#define CS550_VERB(name, preset, packages, arguments, summary) Action declare_##name(CLI::App& app);
#include "cli/verbs.def"

}  // namespace cs550::cli
