/// Runs a student's own tests of a lab. What the tests call of that lab is answered by a worker, which has the
/// reference or a known mistake; the tests cannot see which.
///
///   labN_own_tests [--confine] TESTS SEED
///
/// TESTS: the compiled tests. SEED: of their order. --confine: sees nothing but the folder of the tests.
/// Exit code: 0 if no test fails.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "autograder/grader/judge/submission.hpp"
#include "autograder/grader/message.hpp"
#include "autograder/grader/worker/lockdown.hpp"

namespace {

using namespace cs550::grader;

void load(std::vector<std::string> arguments) {
  const bool confined = arguments.front() == "--confine";
  if (confined) arguments.erase(arguments.begin());
  std::filesystem::path tests = arguments.at(0);
  testing::GTEST_FLAG(shuffle) = true;
  testing::GTEST_FLAG(random_seed) = std::stoi(arguments.at(1));
  if (confined && confine_to(tests.parent_path())) tests = "/" / tests.filename();
  forbid_system_calls();
  if (dlopen(tests.c_str(), RTLD_NOW) == nullptr) throw std::runtime_error(dlerror());
}

}  // namespace

int main(int argc, char** argv) {
  try {
    connect(worker_channel);
    int none = 1;
    testing::InitGoogleTest(&none, argv);
    load({argv + 1, argv + argc});
    return RUN_ALL_TESTS();
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
