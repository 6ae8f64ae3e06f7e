#include "pages/base/controls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace cs550::pages {
namespace {

/// The range that --set accepts. @param least, most of the slider
SettingRange accepted(const Control& control, Real least, Real most) {
  return control.accepted.value_or(SettingRange{least, most});
}

SettingRange accepted(const Control& control, int least, int most) {
  return accepted(control, static_cast<Real>(least), static_cast<Real>(most));
}

std::string range_text(const SettingRange& range, const Control& control) {
  const std::string unit = *control.unit == '\0' ? "" : std::string(" ") + control.unit;
  return short_number(range.least) + " to " + short_number(range.most) + unit;
}

/// The range of a whole number, without a −1 that has a name.
std::string whole_range_text(const SettingRange& range, const Control& control) {
  if (control.minus_one == nullptr) return range_text(range, control);
  return range_text({0, range.most}, control) + ", or " + control.minus_one;
}

bool is_named(const Control& control, int value) {
  return value == -1 && control.minus_one != nullptr;
}

std::string alternatives(std::span<const char* const> names) {
  std::string text;
  for (const char* name : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

}  // namespace

std::string short_number(double value, int digits) {
  return fmt::format("{:.{}g}", value == 0 ? 0.0 : value, digits);
}

// --- setting ---------------------------------------------------------------------------------

ControlSetter::ControlSetter(const std::string& assignment) {
  const std::size_t sign = assignment.find('=');
  if (sign == std::string::npos) {
    throw std::invalid_argument("--set takes name=value, not '" + assignment +
                                "'; --list shows the names");
  }
  name_ = assignment.substr(0, sign);
  text_ = assignment.substr(sign + 1);
}

bool ControlSetter::is_meant(const Control& control) {
  names_.emplace_back(control.name);
  const bool meant = name_ == control.name;
  found_ = found_ || meant;
  return meant;
}

void ControlSetter::refuse(const std::string& expected) const {
  throw std::invalid_argument("--set " + name_ + "=" + text_ + ": expected " + expected);
}

Real ControlSetter::to_number(const std::string& word, const std::string& expected) const {
  std::size_t used = 0;
  Real value = 0;
  try {
    value = std::stof(word, &used);
  } catch (const std::exception&) {
    refuse(expected);
  }
  if (used != word.size() || !std::isfinite(value)) refuse(expected);
  return value;
}

int ControlSetter::to_whole(const SettingRange& range, const std::string& expected) const {
  const Real given = to_number(text_, expected);
  if (given != std::floor(given) || given < range.least || given > range.most) refuse(expected);
  return static_cast<int>(given);
}

void ControlSetter::whole(const Control& control, int& value, int least, int most) {
  if (!is_meant(control)) return;
  const SettingRange range = accepted(control, least, most);
  const bool is_name = control.minus_one != nullptr && text_ == control.minus_one;
  value = is_name ? -1 : to_whole(range, "a whole number, " + whole_range_text(range, control));
}

void ControlSetter::number(const Control& control, Real& value, Real least, Real most) {
  if (!is_meant(control)) return;
  const SettingRange range = accepted(control, least, most);
  const std::string expected = "a number, " + range_text(range, control);
  const Real given = to_number(text_, expected);
  if (given < range.least || given > range.most) refuse(expected);
  value = given;
}

void ControlSetter::vector(const Control& control, Vec3& value, Real most) {
  if (!is_meant(control)) return;
  const SettingRange range = accepted(control, -most, most);
  const std::string expected = "x,y,z, each " + range_text(range, control);
  std::vector<Real> given;
  std::istringstream words(text_);
  for (std::string word; std::getline(words, word, ',');) {
    given.push_back(to_number(word, expected));
    if (given.back() < range.least || given.back() > range.most) refuse(expected);
  }
  if (given.size() != 3) refuse(expected);
  value = {given[0], given[1], given[2]};
}

void ControlSetter::toggle(const Control& control, bool& value) {
  if (!is_meant(control)) return;
  if (text_ != "on" && text_ != "off") refuse("on or off");
  value = text_ == "on";
}

void ControlSetter::choice(const Control& control, int& value, std::span<const char* const> names) {
  if (!is_meant(control)) return;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (text_ == names[i]) {
      value = static_cast<int>(i);
      return;
    }
  }
  refuse("one of " + alternatives(names));
}

void ControlSetter::moves(const Control& control, std::vector<int>& value,
                          std::span<const char* const> names) {
  if (!is_meant(control)) return;
  value.clear();
  std::istringstream words(text_);
  for (std::string word; std::getline(words, word, ',');) {
    const auto name = std::find(names.begin(), names.end(), word);
    if (name == names.end()) refuse("a list of " + alternatives(names) + ", as in next,twin,next");
    value.push_back(static_cast<int>(name - names.begin()));
  }
}

void ControlSetter::expect_found() const {
  if (found_) return;
  std::string list;
  for (const std::string& name : names_) list += (list.empty() ? "" : ", ") + name;
  throw std::invalid_argument("--set " + name_ +
                              ": this page has no such setting. It has: " + list);
}

// --- listing ---------------------------------------------------------------------------------

void ControlLister::add(const Control& control, const std::string& value,
                        const std::string& range) {
  std::string line = std::string(control.name) + "=" + value;
  constexpr std::size_t column = 34;
  line.resize(std::max(line.size() + 2, column), ' ');
  text_ += line + range + "\n";
}

void ControlLister::whole(const Control& control, int& value, int least, int most) {
  add(control, is_named(control, value) ? control.minus_one : std::to_string(value),
      whole_range_text(accepted(control, least, most), control));
}
void ControlLister::number(const Control& control, Real& value, Real least, Real most) {
  add(control, short_number(value), range_text(accepted(control, least, most), control));
}
void ControlLister::vector(const Control& control, Vec3& value, Real most) {
  add(control,
      short_number(value.x()) + "," + short_number(value.y()) + "," + short_number(value.z()),
      "each " + range_text(accepted(control, -most, most), control));
}
void ControlLister::toggle(const Control& control, bool& value) {
  add(control, value ? "on" : "off", "on, off");
}
void ControlLister::choice(const Control& control, int& value, std::span<const char* const> names) {
  add(control, names[value], alternatives(names));
}
void ControlLister::moves(const Control& control, std::vector<int>& value,
                          std::span<const char* const> names) {
  std::string list;
  for (const int move : value) {
    list += (list.empty() ? "" : ",") + std::string(names[move]);
  }
  add(control, list, "a list of " + alternatives(names));
}

}  // namespace cs550::pages
