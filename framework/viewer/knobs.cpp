#include "viewer/knobs.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <sstream>
#include <stdexcept>

namespace cs550::viewer {
namespace {

std::string range_text(double least, double most, const Knob& knob) {
  const std::string unit = *knob.unit == '\0' ? "" : std::string(" ") + knob.unit;
  return short_number(least) + " to " + short_number(most) + unit;
}

std::string alternatives(std::span<const char* const> names) {
  std::string text;
  for (const char* name : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

}  // namespace

std::string short_number(double value, int digits) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, value == 0 ? 0.0 : value);
  return text.data();
}

// --- setting ---------------------------------------------------------------------------------

KnobSetter::KnobSetter(const std::string& assignment) {
  const std::size_t sign = assignment.find('=');
  if (sign == std::string::npos) {
    throw std::invalid_argument("--set takes name=value, not '" + assignment +
                                "'; --list shows the names");
  }
  name_ = assignment.substr(0, sign);
  text_ = assignment.substr(sign + 1);
}

bool KnobSetter::is_meant(const Knob& knob) {
  names_.emplace_back(knob.name);
  const bool meant = name_ == knob.name;
  found_ = found_ || meant;
  return meant;
}

void KnobSetter::refuse(const std::string& expected) const {
  throw std::invalid_argument("--set " + name_ + "=" + text_ + ": expected " + expected);
}

Real KnobSetter::to_number(const std::string& word, const std::string& expected) const {
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

void KnobSetter::whole(const Knob& knob, int& value, int least, int most) {
  if (!is_meant(knob)) return;
  const std::string expected = "a whole number, " + range_text(least, most, knob);
  const Real given = to_number(text_, expected);
  if (given != std::floor(given)) refuse(expected);
  if (given < static_cast<Real>(least) || given > static_cast<Real>(most)) refuse(expected);
  value = static_cast<int>(given);
}

void KnobSetter::number(const Knob& knob, Real& value, Real least, Real most) {
  if (!is_meant(knob)) return;
  const std::string expected = "a number, " + range_text(least, most, knob);
  const Real given = to_number(text_, expected);
  if (given < least || given > most) refuse(expected);
  value = given;
}

void KnobSetter::vector(const Knob& knob, Vec3& value, Real most) {
  if (!is_meant(knob)) return;
  const std::string expected = "x,y,z, each " + range_text(-most, most, knob);
  std::vector<Real> given;
  std::istringstream words(text_);
  for (std::string word; std::getline(words, word, ',');) {
    given.push_back(to_number(word, expected));
    if (std::abs(given.back()) > most) refuse(expected);
  }
  if (given.size() != 3) refuse(expected);
  value = {given[0], given[1], given[2]};
}

void KnobSetter::toggle(const Knob& knob, bool& value) {
  if (!is_meant(knob)) return;
  if (text_ != "on" && text_ != "off") refuse("on or off");
  value = text_ == "on";
}

void KnobSetter::choice(const Knob& knob, int& value, std::span<const char* const> names) {
  if (!is_meant(knob)) return;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (text_ == names[i]) {
      value = static_cast<int>(i);
      return;
    }
  }
  refuse("one of " + alternatives(names));
}

void KnobSetter::moves(const Knob& knob, std::vector<int>& value,
                       std::span<const char* const> names) {
  if (!is_meant(knob)) return;
  value.clear();
  std::istringstream words(text_);
  for (std::string word; std::getline(words, word, ',');) {
    const auto name = std::find(names.begin(), names.end(), word);
    if (name == names.end()) refuse("a list of " + alternatives(names) + ", as in next,twin,next");
    value.push_back(static_cast<int>(name - names.begin()));
  }
}

void KnobSetter::expect_found() const {
  if (found_) return;
  std::string list;
  for (const std::string& name : names_) list += (list.empty() ? "" : ", ") + name;
  throw std::invalid_argument("--set " + name_ +
                              ": this page has no such setting. It has: " + list);
}

// --- listing ---------------------------------------------------------------------------------

void KnobLister::add(const Knob& knob, const std::string& value, const std::string& range) {
  std::string line = std::string(knob.name) + "=" + value;
  constexpr std::size_t column = 34;
  line.resize(std::max(line.size() + 2, column), ' ');
  text_ += line + range + "\n";
}

void KnobLister::whole(const Knob& knob, int& value, int least, int most) {
  add(knob, std::to_string(value), range_text(least, most, knob));
}
void KnobLister::number(const Knob& knob, Real& value, Real least, Real most) {
  add(knob, short_number(value), range_text(least, most, knob));
}
void KnobLister::vector(const Knob& knob, Vec3& value, Real most) {
  add(knob, short_number(value.x()) + "," + short_number(value.y()) + "," + short_number(value.z()),
      "each " + range_text(-most, most, knob));
}
void KnobLister::toggle(const Knob& knob, bool& value) {
  add(knob, value ? "on" : "off", "on, off");
}
void KnobLister::choice(const Knob& knob, int& value, std::span<const char* const> names) {
  add(knob, names[static_cast<std::size_t>(value)], alternatives(names));
}
void KnobLister::moves(const Knob& knob, std::vector<int>& value,
                       std::span<const char* const> names) {
  std::string list;
  for (const int move : value) {
    list += (list.empty() ? "" : ",") + std::string(names[static_cast<std::size_t>(move)]);
  }
  add(knob, list, "a list of " + alternatives(names));
}

}  // namespace cs550::viewer
