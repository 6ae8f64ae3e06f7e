#pragma once
/// @file control_json.hpp
/// Settings as JSON, so that a web page can make its inputs.

#include <nlohmann/json.hpp>
#include <string_view>

#include "pages/base/controls.hpp"

namespace cs550::live {

using pages::Control;

/// Why the browser cannot offer a setting; empty for all that it can.
constexpr std::string_view why_unavailable(std::string_view setting) {
  if (setting == "minkowski") return "the Minkowski difference needs the hull library";
  if (setting == "threads" || setting == "adaptive_threads")
    return "the browser's engine has one thread";
  return {};
}

/// Lists every setting that the browser can offer: {kind, name, label, unit, value}, and least and
/// most or names as the kind needs; and minus_one, what −1 is called, if it has a name.
class ControlJson final : public pages::ControlVisitor {
 public:
  void section(const char* title) override {
    all_.push_back({{"kind", "section"}, {"label", title}});
  }
  void whole(const Control& control, int& value, int least, int most) override {
    if (!why_unavailable(control.name).empty()) return;
    nlohmann::json& added = add("whole", control, value);
    added.update({{"least", least}, {"most", most}});
    if (control.minus_one != nullptr) added["minus_one"] = control.minus_one;
  }
  void number(const Control& control, Real& value, Real least, Real most) override {
    add("number", control, value).update({{"least", least}, {"most", most}});
  }
  void vector(const Control& control, Vec3& value, Real most) override {
    add("vector", control, {value.x(), value.y(), value.z()})
        .update({{"least", -most}, {"most", most}});
  }
  void toggle(const Control& control, bool& value) override {
    if (why_unavailable(control.name).empty()) add("toggle", control, value);
  }
  void choice(const Control& control, int& value, std::span<const char* const> names) override {
    add("choice", control, names[value])["names"] = names;
  }
  void moves(const Control& control, std::vector<int>& value,
             std::span<const char* const> names) override {
    nlohmann::json words = nlohmann::json::array();
    for (const int move : value) words.push_back(names[move]);
    add("moves", control, words)["names"] = names;
  }

  std::string text() const { return all_.dump(); }

 private:
  nlohmann::json& add(const char* kind, const Control& control, const nlohmann::json& value) {
    all_.push_back({{"kind", kind},
                    {"name", control.name},
                    {"label", control.label},
                    {"unit", control.unit},
                    {"value", value}});
    return all_.back();
  }

  nlohmann::json all_ = nlohmann::json::array();
};

}  // namespace cs550::live
