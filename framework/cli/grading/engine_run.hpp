#pragma once
/// @file engine_run.hpp
/// Running the milestones of a lab on the engine made of the student's own labs.

#include "cli/grading/lab_result.hpp"

namespace cs550::cli {

/// Compares the engine with the recorded reference, and stops it if it does not end. Where it fails and
/// an earlier lab is not finished, offers that lab's released solution.
/// @param grading Sanitized: prints what the sanitizers report. Debugged: opens gdb if the milestone is
///   not reached
/// @return an ExitCode
int run_engine(int lab, Grading grading);

}  // namespace cs550::cli
