#pragma once
/// @file controls.hpp
/// Settings that a user can change. The panel, --set and --list share one description.

#include <span>
#include <string>
#include <vector>

#include "cs550/setting_range.hpp"

namespace cs550::pages {

/// The name of a setting.
struct Control {
  const char* name;   ///< on the command line: "substeps"
  const char* label;  ///< on the panel: "substeps"
  const char* unit;   ///< "m", "1/s", or empty
  /// The range that --set accepts, if it is more than a slider offers.
  std::optional<SettingRange> accepted = {};
  /// What −1 is called if it is the least whole number: "last". Null if it is a number.
  const char* minus_one = nullptr;
};

/// As the displayed step of a walk: its last one, however long the walk is. It is called "last".
inline constexpr int last_step = -1;

/// Visits settings one after another. describe() functions call it:
/// `void describe(Settings& settings, ControlVisitor& visit)`.
class ControlVisitor {
 public:
  ControlVisitor() = default;
  ControlVisitor(const ControlVisitor&) = delete;
  ControlVisitor& operator=(const ControlVisitor&) = delete;
  virtual ~ControlVisitor() = default;

  /// Starts a group of settings.
  virtual void section(const char* /*title*/) {}
  /// A setting and the range of its slider, including both ends.
  /// @{
  virtual void whole(const Control& control, int& value, int least, int most) = 0;
  /// The displayed step of a walk: 0 to most, or last_step.
  void step(Control control, int& value, int most) {
    control.minus_one = "last";
    whole(control, value, last_step, most);
  }
  virtual void number(const Control& control, Real& value, Real least, Real most) = 0;
  /// Each component between −most and most.
  virtual void vector(const Control& control, Vec3& value, Real most) = 0;
  virtual void toggle(const Control& control, bool& value) = 0;
  /// @param value index in the list of names
  virtual void choice(const Control& control, int& value, std::span<const char* const> names) = 0;
  /// A list of moves, each an index in the list of names.
  virtual void moves(const Control& control, std::vector<int>& value,
                     std::span<const char* const> names) = 0;
  /// @}
};

/// Changes the setting named in `name=value`.
class ControlSetter final : public ControlVisitor {
 public:
  /// @throws std::invalid_argument if `=` is missing
  explicit ControlSetter(const std::string& assignment);

  void whole(const Control& control, int& value, int least, int most) override;
  void number(const Control& control, Real& value, Real least, Real most) override;
  void vector(const Control& control, Vec3& value, Real most) override;
  void toggle(const Control& control, bool& value) override;
  void choice(const Control& control, int& value, std::span<const char* const> names) override;
  void moves(const Control& control, std::vector<int>& value,
             std::span<const char* const> names) override;

  /// Call this after the visit. @throws std::invalid_argument with a list of all names if no
  /// setting matched
  void expect_found() const;

 private:
  bool is_meant(const Control& control);
  [[noreturn]] void refuse(const std::string& expected) const;
  Real to_number(const std::string& word, const std::string& expected) const;
  int to_whole(const SettingRange& range, const std::string& expected) const;

  std::string name_;
  std::string text_;
  bool found_ = false;
  std::vector<std::string> names_;
};

/// Lists every setting as `name=value` with its range, one per line.
class ControlLister final : public ControlVisitor {
 public:
  void whole(const Control& control, int& value, int least, int most) override;
  void number(const Control& control, Real& value, Real least, Real most) override;
  void vector(const Control& control, Vec3& value, Real most) override;
  void toggle(const Control& control, bool& value) override;
  void choice(const Control& control, int& value, std::span<const char* const> names) override;
  void moves(const Control& control, std::vector<int>& value,
             std::span<const char* const> names) override;

  /// All lines of the list.
  const std::string& text() const { return text_; }

 private:
  void add(const Control& control, const std::string& value, const std::string& range);

  std::string text_;
};

/// A number without trailing zeros: "0.25", "3".
std::string short_number(double value, int digits = 4);

}  // namespace cs550::pages
