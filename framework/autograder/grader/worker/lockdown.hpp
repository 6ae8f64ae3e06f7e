#pragma once
/// @file lockdown.hpp
/// What a worker gives up before it loads a stranger's code.

#include <filesystem>

namespace cs550::grader {

/// Sees no file outside of a folder any more, and becomes an unprivileged user.
/// @return false if nothing was done, since this process is not root. @throws std::system_error
bool confine_to(const std::filesystem::path& folder);

/// Allows only what computing needs: memory, time, reading files, and descriptors that are open.
/// Starting a program, a process, a thread or a connection fails with EPERM.
/// @throws std::system_error
void forbid_system_calls();

}  // namespace cs550::grader
