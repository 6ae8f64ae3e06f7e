#pragma once
/// @file course.hpp
/// The settings of a course: what a lab is worth, until when, and what a student gets to see.

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace cs550::gradebook {

using Time = std::chrono::sys_seconds;

/// Limits of one lab's run. An empty one leaves the choice to the program that grades.
struct Limits {
  std::optional<int> wall;    ///< seconds of one test
  std::optional<int> cpu;     ///< seconds of processor time of one test
  std::optional<int> memory;  ///< MB
  std::optional<int> lab;     ///< seconds of compilation and all tests together
};

enum class Visibility { Visible, Hidden, AfterDueDate, AfterPublished };

/// Which clock decides whether a submission is late.
enum class Clock {
  File,      ///< modification time of the submission's file, as the learning platform set it
  Manifest,  ///< the date that ./cs550 submit wrote on the student's computer
  Roster     ///< the column `submitted` of the roster
};

/// Which of a student's submissions counts, for each lab.
enum class Attempt { Best, Last };

struct LabSettings {
  double weight = 1;     ///< share of the total
  double points = 60;    ///< what the 60 points of the project are scaled to
  double own_tests = 0;  ///< bonus for tests that find every known mistake
  std::optional<Time> due;
  std::optional<Time> solution_released;  ///< a later submission earns nothing
  Limits limits;
};

struct LatePolicy {
  Clock clock = Clock::File;
  double percent_per_day = 0;  ///< of what was earned, for every day begun
  double grace_minutes = 0;
  double most_percent = 100;  ///< the deduction never exceeds this
};

/// Points given or taken by hand.
struct Adjustment {
  std::string student;
  int lab = 0;
  double points = 0;  ///< of the course's scale
  std::string reason;
};

struct Extension {
  std::string student;
  int lab = 0;
  Time due;
  std::chrono::minutes offset{0};  ///< of the written due date from UTC
  std::string reason;
};

struct RegradeRequest {
  enum class Status { Open, Granted, Declined };
  std::string student;
  int lab = 0;
  std::string test;  ///< "Lab3.FirstOfEqualVerticesWins"
  Status status = Status::Open;
  std::string note;
};

struct Course {
  std::string title = "CS550";
  std::string secret;                 ///< seeds derive from it; empty: the published seeds
  std::optional<int> retention_days;  ///< how long records are kept
  Attempt attempt = Attempt::Best;
  std::vector<std::string> leaderboard;  ///< "points", "seconds", "challenge"; empty: none
  Limits limits;
  Visibility visible_tests = Visibility::Visible;
  Visibility hidden_tests = Visibility::AfterPublished;
  std::optional<LatePolicy> late;
  std::map<int, LabSettings> labs;  ///< only those that the file lists
  double milestones_weight = 0;     ///< of the assembled engine's milestones in the total
  std::vector<Adjustment> adjustments;
  std::vector<Extension> extensions;
  std::vector<RegradeRequest> regrades;

  /// Of a lab; the default for one that is not listed.
  LabSettings lab(int number) const;
  /// Whether the leaderboard shows the challenges of the labs.
  bool counts_challenges() const;
  /// The lab's limits, filled up with the course's.
  Limits limits_of(int number) const;
};

}  // namespace cs550::gradebook
