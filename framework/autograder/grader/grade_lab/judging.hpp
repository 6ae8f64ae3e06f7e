#pragma once
/// @file judging.hpp
/// Running a lab's judge.

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "autograder/grader/order.hpp"

namespace cs550::grader {

/// Runs a lab's graded tests, or the milestones, on the submission. A judge that ends in the middle of
/// a test is started again for the tests after it.
/// @param tests the number of tests that the filter lets run, or more
/// @param filter of GoogleTest
/// @return the row of each test that ran, by its name without the suite (results.hpp)
/// @throws std::runtime_error if there is no judge, or if it fails for a reason that is not the submission's
nlohmann::json run_judge(const Order& order, std::size_t tests, const std::string& filter,
                         const std::filesystem::path& work);

/// Counts the challenges of a lab on the submission, with the published seeds, so that a student's own counts are
/// the same. @return [{what, better, count}]; empty if the submission fails meanwhile
/// @throws std::runtime_error if the judge fails for a reason that is not the submission's
nlohmann::json run_challenge(const Order& order, const std::filesystem::path& work);

}  // namespace cs550::grader
