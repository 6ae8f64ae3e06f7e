#pragma once
/// @file read_archive.hpp
/// Submissions as zip or tar archives. Nothing is unpacked to disk.

#include <filesystem>

#include "gradebook/intake/collector.hpp"

namespace cs550::gradebook {

/// Whether a file's name is that of an archive: .zip, .tar, .tar.gz, .tgz, in capitals or not.
bool is_archive(const std::filesystem::path& file);
/// Whether it is that of an archive of another kind, such as .rar, which cannot be read.
bool is_unknown_archive(const std::filesystem::path& file);

/// Offers every file of an archive to the collector. Links and devices are ignored. What is no file is not opened: a
/// named pipe would never end.
/// @return why the archive was not read to its end; empty if it was
std::string read_archive(const std::filesystem::path& file, Collector& collector,
                         const IntakeLimits& limits = {});

}  // namespace cs550::gradebook
