#include "files/usage_fault.hpp"

namespace cs550::files {

std::string usage_fault(const std::string& words) {
  const std::size_t flag_end = words.find(" was given a disallowed flag override");
  if (flag_end == std::string::npos) return words;
  return "--" + words.substr(0, flag_end) + " takes no value";
}

}  // namespace cs550::files
