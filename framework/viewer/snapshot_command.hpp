#pragma once
/// @file snapshot_command.hpp
/// What to type where there is no screen.

#include <string>

#include "viewer/options.hpp"

namespace cs550::viewer {

/// The command that takes a picture of what the options show: what was typed, with --snapshot. Lines of at
/// most 80 columns if its words allow it, for a shell.
std::string snapshot_command(const Options& options);

}  // namespace cs550::viewer
