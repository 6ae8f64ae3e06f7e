#pragma once
/// @file exit_code.hpp

namespace cs550::cli {

/// The exit codes of every verb.
enum ExitCode { Good = 0, Failed = 1, Misused = 2 };

}  // namespace cs550::cli
