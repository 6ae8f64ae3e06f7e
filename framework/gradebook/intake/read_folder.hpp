#pragma once
/// @file read_folder.hpp
/// Submissions as folders, a Git checkout for example.

#include <filesystem>

#include "gradebook/intake/collector.hpp"

namespace cs550::gradebook {

/// Offers every file below a folder to the collector. Links are not followed. Git is never run
/// there, because the configuration of a checkout can make it run programs.
/// @return why the folder was not read to its end; empty if it was
/// @throws std::runtime_error if a file of a lab cannot be read
std::string read_folder(const std::filesystem::path& folder, Collector& collector,
                        const IntakeLimits& limits = {});

}  // namespace cs550::gradebook
