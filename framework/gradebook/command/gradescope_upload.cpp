#include "gradebook/command/gradescope_upload.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>

#include "cli/system/files.hpp"
#include "gradebook/marks/time_text.hpp"
#include "gradebook/text/escape.hpp"

namespace cs550::gradebook {
namespace {

using Json = nlohmann::json;

std::string text_in(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? plain_line(found->get<std::string>()) : "";
}

/// When Gradescope received the submission, in seconds since 1970.
long submission_time(const Json& metadata, const std::filesystem::path& file) {
  if (const std::optional<Time> time = parse_time(text_in(metadata, "created_at"))) {
    return time->time_since_epoch().count();
  }
  throw std::runtime_error(file.string() +
                           " has no time created_at such as 2026-10-12T23:59:00+02:00");
}

/// The address of the student, or the name of one without an address. Of a group it is the first student.
std::string student_in(const Json& metadata) {
  const Json users = metadata.value("users", Json::array());
  if (!users.is_array() || users.empty() || !users[0].is_object()) return {};
  const std::string address = text_in(users[0], "email");
  return address.empty() ? text_in(users[0], "name") : address;
}

FoundSubmission only_one(const std::vector<FoundSubmission>& found, const Catalogue& catalogue) {
  std::vector<FoundSubmission> with_labs;
  std::string names;
  for (const FoundSubmission& submission : found) {
    if (!read_submission(submission, catalogue).trouble.empty()) continue;
    with_labs.push_back(submission);
    names += (names.empty() ? "" : ", ") + submission.name;
  }
  if (with_labs.empty()) return found.front();
  if (with_labs.size() > 1) {
    with_labs.front().trouble = fmt::format(
        "the upload has {} submissions, and none was graded: {}. Upload only one of them",
        with_labs.size(), names);
  }
  return with_labs.front();
}

}  // namespace

FoundSubmission gradescope_upload(const std::vector<FoundSubmission>& found,
                                  const std::filesystem::path& metadata,
                                  const Catalogue& catalogue) {
  const Json parsed = Json::parse(cli::read_text(metadata), nullptr, false);
  const Json json = parsed.is_object() ? parsed : Json::object();
  const long time = submission_time(json, metadata);
  FoundSubmission submission = only_one(found, catalogue);
  submission.time = time;
  if (const std::string student = student_in(json); !student.empty()) {
    submission.student = student;
    submission.is_identified = true;
  }
  return submission;
}

}  // namespace cs550::gradebook
