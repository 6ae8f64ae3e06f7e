#include "gradebook/course/course.hpp"

namespace cs550::gradebook {

LabSettings Course::lab(int number) const {
  const auto found = labs.find(number);
  return found == labs.end() ? LabSettings{} : found->second;
}

Limits Course::limits_of(int number) const {
  Limits own = lab(number).limits;
  if (!own.wall) own.wall = limits.wall;
  if (!own.cpu) own.cpu = limits.cpu;
  if (!own.memory) own.memory = limits.memory;
  return own;
}

}  // namespace cs550::gradebook
