#include "gradebook/records/record.hpp"

#include <algorithm>
#include <numeric>

namespace cs550::gradebook {

int LabRecord::points() const {
  return std::accumulate(tests.begin(), tests.end(), 0,
                         [](int sum, const TestResult& test) { return sum + test.points; });
}

int LabRecord::earned() const {
  return std::accumulate(tests.begin(), tests.end(), 0,
                         [](int sum, const TestResult& test) { return sum + test.earned; });
}

double LabRecord::seconds() const {
  return std::accumulate(tests.begin(), tests.end(), compile_seconds,
                         [](double sum, const TestResult& test) { return sum + test.seconds; });
}

bool LabRecord::is_graded() const {
  return not_graded.empty() && (!own_tests || own_tests->not_graded.empty());
}

int LabRecord::tests_with(const std::string& status) const {
  return static_cast<int>(std::count_if(
      tests.begin(), tests.end(), [&](const TestResult& test) { return test.status == status; }));
}

bool LabRecord::has_test(const std::string& name) const {
  return std::any_of(tests.begin(), tests.end(),
                     [&name](const TestResult& test) { return test.name == name; });
}

bool LabRecord::is_final() const {
  const bool was_stopped = own_tests && own_tests->stopped;
  return is_graded() && tests_with("timeout") == 0 && !was_stopped;
}

bool Record::is_graded() const {
  return (!engine || engine->is_graded()) &&
         std::all_of(labs.begin(), labs.end(),
                     [](const LabRecord& lab) { return lab.is_graded(); });
}

const LabRecord* Record::lab(int number) const {
  for (const LabRecord& lab : labs) {
    if (lab.lab == number) return &lab;
  }
  return nullptr;
}

}  // namespace cs550::gradebook
