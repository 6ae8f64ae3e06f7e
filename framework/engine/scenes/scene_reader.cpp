#include "engine/scenes/scene_reader.hpp"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

#include "cs550/nearest_word.hpp"

namespace cs550 {
namespace {

using Json = nlohmann::json;

bool fits(const Json& value, double least, double most) {
  if (!value.is_number()) return false;
  const double number = value.get<double>();
  return number >= least && number <= most;
}

bool fits(const Json& value, Range range) {
  return value.is_number() && fits(value.get<double>(), range);
}

bool fits_whole(const Json& value, std::int64_t least, std::int64_t most) {
  return value.is_number_integer() && value >= least && value <= most;
}

/// Escape sequences in a title would reach the reader's terminal.
bool contains_control(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (control_length(std::string_view(text).substr(i)) > 0) return true;
  }
  return false;
}

std::string whole_number(std::int64_t least, std::int64_t most) {
  return "a whole number from " + std::to_string(least) + " to " + std::to_string(most);
}

std::string did_you_mean(const std::string& typed, const std::vector<std::string>& words) {
  const std::string nearest = nearest_word(typed, words);
  return nearest.empty() ? "" : " (did you mean \"" + cs550::excerpt(nearest) + "\"?)";
}

}  // namespace

SceneReader::SceneReader(const Json& value, std::string path, const std::string& example)
    : value_(value), path_(std::move(path)) {
  if (!value_.is_object()) {
    throw SceneFault(path_, "expected an object in braces, found " + excerpt(value_) +
                                "; for example " + example);
  }
}

bool SceneReader::has(const std::string& key) {
  asked_.push_back(key);
  return value_.contains(key);
}

void SceneReader::require(const std::string& key, const std::string& example) {
  if (has(key)) return;
  throw SceneFault(path_, "the key \"" + key + "\" is missing" + did_you_mean(key, keys()) +
                              "; for example \"" + key + "\": " + example);
}

void SceneReader::read(const std::string& key, Real& value, Range range) {
  if (!has(key)) return;
  if (!fits(json(key), range)) refuse(key, in_words(range), show(value));
  value = json(key).get<Real>();
}

void SceneReader::read(const std::string& key, Real& value, double least, double most) {
  if (!has(key)) return;
  if (!fits(json(key), least, most)) {
    std::ostringstream expected;
    expected.imbue(std::locale::classic());
    expected << "a number from " << least << " to " << most;
    refuse(key, expected.str(), show(value));
  }
  value = json(key).get<Real>();
}

void SceneReader::read(const std::string& key, int& value, int least, int most) {
  if (!has(key)) return;
  if (!fits_whole(json(key), least, most)) refuse(key, whole_number(least, most), show(value));
  value = json(key).get<int>();
}

void SceneReader::read(const std::string& key, std::uint32_t& value) {
  if (!has(key)) return;
  if (!fits_whole(json(key), 0, UINT32_MAX)) refuse(key, whole_number(0, UINT32_MAX), show(value));
  value = json(key).get<std::uint32_t>();
}

void SceneReader::read(const std::string& key, bool& value) {
  if (!has(key)) return;
  if (!json(key).is_boolean()) refuse(key, "true or false", value ? "true" : "false");
  value = json(key).get<bool>();
}

void SceneReader::read(const std::string& key, std::string& value) {
  if (!has(key)) return;
  const Json& text = json(key);
  if (!text.is_string() || contains_control(text.get_ref<const std::string&>())) {
    refuse(key, "a text in quotes without control characters", show(value));
  }
  value = text.get<std::string>();
}

void SceneReader::read(const std::string& key, Vec3& value, Range range) {
  if (!has(key)) return;
  const Json& list = json(key);
  const auto good = [range](const Json& item) { return fits(item, range); };
  if (!list.is_array() || list.size() != 3 || !std::all_of(list.begin(), list.end(), good)) {
    refuse(key, "a list of three items, each " + std::string(in_words(range)), show(value));
  }
  value = {list[0].get<Real>(), list[1].get<Real>(), list[2].get<Real>()};
}

void SceneReader::read(const std::string& key, std::vector<int>& values, int least, int most) {
  if (!has(key)) return;
  const Json& list = json(key);
  const auto good = [least, most](const Json& item) { return fits_whole(item, least, most); };
  if (!list.is_array() || list.size() != values.size() ||
      !std::all_of(list.begin(), list.end(), good)) {
    refuse(
        key,
        "a list of " + std::to_string(values.size()) + " items, each " + whole_number(least, most),
        show(values));
  }
  values = list.get<std::vector<int>>();
}

std::size_t SceneReader::read_word(const std::string& key, const std::vector<std::string>& words,
                                   std::size_t default_word) {
  if (!has(key)) return default_word;
  const Json& value = json(key);
  const auto found = value.is_string()
                         ? std::find(words.begin(), words.end(), value.get<std::string>())
                         : words.end();
  if (found == words.end()) {
    std::string expected = "one of";
    for (const std::string& word : words)
      expected += (&word == &words[0] ? " " : ", ") + show(word);
    if (value.is_string()) expected += did_you_mean(value.get<std::string>(), words);
    refuse(key, expected, show(words[default_word]));
  }
  return found - words.begin();
}

SceneReader SceneReader::object(const std::string& key, const std::string& example) {
  if (!json(key).is_object()) refuse(key, "an object in braces", example);
  return {json(key), path_of(key), example};
}

std::string SceneReader::excerpt(const Json& value) {
  return cs550::excerpt(value.dump(-1, ' ', false, Json::error_handler_t::replace));
}

bool SceneReader::is_number(const Json& value) { return fits(value, Range::Any); }

std::vector<std::pair<const Json*, std::string>> SceneReader::list(const std::string& key,
                                                                   const std::string& example) {
  std::vector<std::pair<const Json*, std::string>> items;
  if (!has(key)) return items;
  if (!json(key).is_array()) refuse(key, "a list in brackets", example);
  for (const Json& item : json(key)) {
    items.emplace_back(&item, path_of(key) + "/" + std::to_string(items.size()));
  }
  return items;
}

std::vector<SceneReader> SceneReader::objects(const std::string& key, const std::string& example) {
  std::vector<SceneReader> objects;
  for (const auto& [item, path] : list(key, "[" + example + "]")) {
    objects.emplace_back(*item, path, example);
  }
  return objects;
}

std::vector<std::string> SceneReader::keys() const {
  std::vector<std::string> keys;
  for (auto item = value_.begin(); item != value_.end(); ++item) keys.push_back(item.key());
  return keys;
}

void SceneReader::refuse_other_keys() const {
  const std::vector<std::string> present = keys();
  const auto other = std::find_if(present.begin(), present.end(), [this](const std::string& key) {
    return std::find(asked_.begin(), asked_.end(), key) == asked_.end();
  });
  if (other == present.end()) return;

  std::vector<std::string> known = asked_;
  std::sort(known.begin(), known.end());
  known.erase(std::unique(known.begin(), known.end()), known.end());
  std::string all;
  for (const std::string& word : known) all.append(all.empty() ? "" : ", ").append(word);
  throw SceneFault(path_of(*other), "there is no key \"" + cs550::excerpt(*other) + "\" here" +
                                        did_you_mean(*other, known) + "; expected one of " + all);
}

void SceneReader::refuse(const std::string& key, const std::string& expected,
                         const std::string& example) const {
  throw SceneFault(path_of(key), "expected " + expected + ", found " + excerpt(json(key)) +
                                     "; for example \"" + key + "\": " + example);
}

std::string SceneReader::show(Real value) {
  // Through a double of few digits: 0.2, not 0.20000000298023224.
  return Json(std::round(static_cast<double>(value) * 1e6) / 1e6).dump();
}
std::string SceneReader::show(int value) { return std::to_string(value); }
std::string SceneReader::show(std::uint32_t value) { return std::to_string(value); }
std::string SceneReader::show(const std::string& value) { return Json(value).dump(); }
std::string SceneReader::show(const Vec3& value) {
  return "[" + show(value.x()) + ", " + show(value.y()) + ", " + show(value.z()) + "]";
}
std::string SceneReader::show(const std::vector<int>& values) {
  std::string text;
  for (const int value : values) text += (text.empty() ? "" : ", ") + show(value);
  return "[" + text + "]";
}

}  // namespace cs550
