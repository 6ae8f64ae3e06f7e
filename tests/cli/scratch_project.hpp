#pragma once
/// @file scratch_project.hpp
/// A folder of its own for each test.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace cs550::cli {

/// During a test its empty folder is the project's.
class ScratchProject : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(root);
    setenv("CS550_ROOT", root.c_str(), 1);
  }
  void TearDown() override {
    unsetenv("CS550_ROOT");
    std::filesystem::remove_all(root);
  }

  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path root = std::filesystem::path(testing::TempDir()) /
                                     (std::string(test.test_suite_name()) + '.' + test.name());
};

}  // namespace cs550::cli
