#pragma once
/// @file scratch_project.hpp
/// A folder of its own for each test.

#include <gtest/gtest.h>

#include <filesystem>

#include "helpers/scoped_environment.hpp"
#include "helpers/scratch_folder.hpp"

namespace cs550::cli {

/// During a test its empty folder is the project's.
class ScratchProject : public testing::Test {
 protected:
  const test::ScratchFolder folder;
  const std::filesystem::path root = folder.path();

 private:
  const test::ScopedEnvironment variable_{"CS550_ROOT", root.string()};
};

}  // namespace cs550::cli
