#include "gradebook/course/course.hpp"

#include <algorithm>

namespace cs550::gradebook {

LabSettings Course::lab(int number) const {
  const auto found = labs.find(number);
  return found == labs.end() ? LabSettings{} : found->second;
}

bool Course::counts_challenges() const {
  return std::find(leaderboard.begin(), leaderboard.end(), "challenge") != leaderboard.end();
}

Limits Course::limits_of(int number) const {
  Limits own = lab(number).limits;
  if (!own.wall) own.wall = limits.wall;
  if (!own.cpu) own.cpu = limits.cpu;
  if (!own.memory) own.memory = limits.memory;
  if (!own.lab) own.lab = limits.lab;
  return own;
}

}  // namespace cs550::gradebook
