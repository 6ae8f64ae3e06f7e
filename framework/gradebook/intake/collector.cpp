#include "gradebook/intake/collector.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "gradebook/text/escape.hpp"

namespace cs550::gradebook {
namespace {

using Json = nlohmann::json;

constexpr const char* manifest_of_submit = "manifest.json";

std::string text_of(const Json& json, const char* key) {
  constexpr std::size_t longest = 100;
  const auto found = json.find(key);
  if (found == json.end() || !found->is_string()) return {};
  return plain_line(found->get<std::string>()).substr(0, longest);
}

/// Keeps the members of the outermost object: what we read of a manifest is there.
bool keep_top(int depth, Json::parse_event_t /*event*/, const Json& /*value*/) {
  return depth <= 1;
}

/// Whether one of the paths is a folder of the other.
bool contains(const std::string& a, const std::string& b) {
  return a.starts_with(b + '/') || b.starts_with(a + '/');
}

long depth_of(const std::string& path) {
  return std::count_if(path.begin(), path.end(), [](char c) { return c == '/' || c == '\\'; });
}

/// Files nearer to the top come first.
bool is_nearer(const std::string& a, const std::string& b) {
  return std::pair(depth_of(a), a) < std::pair(depth_of(b), b);
}

}  // namespace

bool Collector::wants(const std::string& path) {
  if (path == manifest_of_submit) return true;
  const LabPath place = lab_path(path, catalogue_);
  if (place.lab == 0) ignore(path, place.ignored);
  return place.lab != 0;
}

void Collector::take(const std::string& path, std::string text) {
  if (path == manifest_of_submit) {
    read_manifest(text);
    return;
  }
  if (text.size() > IntakeLimits().file) {
    ignore(path, "larger than 1 MB");
    return;
  }
  LabPath place = lab_path(path, catalogue_);
  std::vector<Candidate>& candidates = candidates_[place.lab];
  candidates.push_back({path, std::move(place), std::move(text)});
}

/// The lab's folder in a copy of the project is what the student worked on: stray files beside it, or in a
/// second copy, are not mixed with it.
void Collector::choose(std::vector<Candidate> candidates) {
  std::stable_sort(
      candidates.begin(), candidates.end(),
      [](const Candidate& a, const Candidate& b) { return is_nearer(a.path, b.path); });
  const auto own = std::find_if(candidates.begin(), candidates.end(),
                                [](const Candidate& file) { return file.place.is_in_project; });
  if (own == candidates.end()) {
    for (Candidate& file : candidates) add(std::move(file));
    return;
  }
  const LabPath chosen = own->place;
  submission_.whole_labs.insert(chosen.lab);
  const std::string folder = (chosen.project.empty() ? "" : plain_line(chosen.project) + '/') +
                             "labs/" + catalogue_.at(chosen.lab).name + '/';
  for (Candidate& file : candidates) {
    if (file.place.is_in_project && file.place.project == chosen.project) {
      add(std::move(file));
    } else {
      ignore(file.path, "not in " + folder + ", which is graded");
    }
  }
}

void Collector::add(Candidate file) {
  const std::vector<std::string>& starter = catalogue_.at(file.place.lab).starter_files;
  std::vector<SourceFile>& files = submission_.labs[file.place.lab];
  const std::string& name = file.place.file;
  const auto is_starter = [&](const std::string& path) {
    return std::find(starter.begin(), starter.end(), path) != starter.end();
  };
  // Those of the starter that are missing are added later.
  const auto others = std::count_if(
      files.begin(), files.end(), [&](const SourceFile& known) { return !is_starter(known.path); });
  const int most = IntakeLimits().files_of_lab - static_cast<int>(starter.size());
  if (is_starter(name.substr(0, name.find('/'))) && !is_starter(name)) {
    ignore(file.path, "in a folder with the name of a starter file");
  } else if (others >= most && !is_starter(name)) {
    ignore(file.path, "the lab has more than 100 files");
  } else if (std::any_of(files.begin(), files.end(),
                         [&](const SourceFile& known) { return known.path == name; })) {
    ignore(file.path, "a second file of this name; the first one is graded");
  } else if (std::any_of(files.begin(), files.end(),
                         [&](const SourceFile& known) { return contains(known.path, name); })) {
    ignore(file.path, "a file and a folder of the same name");
  } else {
    files.push_back({name, std::move(file.text)});
  }
}

void Collector::ignore(const std::string& path, const std::string& reason) {
  constexpr std::size_t most = 200;
  // A whole copy of the project has hundreds of files outside of labs: their folder is enough.
  const bool is_given = reason == outside_of_labs;
  const std::string shown =
      plain_line(is_given ? path.substr(0, path.find('/') + 1) : path).substr(0, most);
  const std::string name = shown.empty() ? plain_line(path).substr(0, most) : shown;
  for (IgnoredFile& known : submission_.ignored) {
    if (known.path == name && known.reason == reason) {
      ++known.files;
      return;
    }
  }
  if (submission_.ignored.size() == most)
    submission_.ignored.push_back({"...", "further files", 0});
  if (submission_.ignored.size() > most) {
    ++submission_.ignored.back().files;
    return;
  }
  submission_.ignored.push_back({name, reason, 1});
}

void Collector::finish() {
  for (auto& [lab, candidates] : candidates_) choose(std::move(candidates));
  candidates_.clear();
  for (auto& [lab, files] : submission_.labs) {
    std::sort(files.begin(), files.end(),
              [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  }
  if (submission_.labs.empty() && submission_.trouble.empty()) {
    submission_.trouble = "it contains no file of a lab";
  }
}

void Collector::read_manifest(const std::string& text) {
  if (text.size() > IntakeLimits().manifest) {
    ignore(manifest_of_submit, "larger than 64 kB");
    return;
  }
  const Json json = Json::parse(text, keep_top, false);
  if (!json.is_object()) {
    ignore(manifest_of_submit, "not the manifest that ./cs550 submit writes");
    return;
  }
  submission_.claimed_student = text_of(json, "student");
  submission_.claimed_date = text_of(json, "date");
  submission_.starter = text_of(json, "starter");
}

}  // namespace cs550::gradebook
