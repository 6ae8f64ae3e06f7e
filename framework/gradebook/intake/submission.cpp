#include "gradebook/intake/submission.hpp"

#include "gradebook/text/sha256.hpp"

namespace cs550::gradebook {

std::string Submission::hash() const {
  std::vector<std::string> parts;
  for (const auto& [lab, files] : labs) {
    parts.push_back(std::to_string(lab));
    parts.push_back(lab_hash(lab));
  }
  return sha256_of({parts.begin(), parts.end()});
}

std::string Submission::lab_hash(int lab) const {
  std::vector<std::string_view> parts;
  if (const auto found = labs.find(lab); found != labs.end()) {
    for (const SourceFile& file : found->second) {
      parts.emplace_back(file.path);
      parts.emplace_back(file.text);
    }
  }
  return sha256_of(parts);
}

}  // namespace cs550::gradebook
