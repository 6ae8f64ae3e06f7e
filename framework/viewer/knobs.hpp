#pragma once
/// @file knobs.hpp
/// Settings that a person can turn: one description serves the panel, the command line and --help.

#include <span>
#include <string>
#include <vector>

#include "cs550/math.hpp"

namespace cs550::viewer {

/// What a setting is called.
struct Knob {
  const char* name;   ///< on the command line: "substeps"
  const char* label;  ///< on the panel: "substeps"
  const char* unit;   ///< "m", "1/s", or empty
};

/// Meets every setting of something, one after the other. describe() functions call it:
/// `void describe(Settings& settings, KnobVisitor& visit)`.
class KnobVisitor {
 public:
  KnobVisitor() = default;
  KnobVisitor(const KnobVisitor&) = delete;
  KnobVisitor& operator=(const KnobVisitor&) = delete;
  virtual ~KnobVisitor() = default;

  /// What follows belongs together.
  virtual void section(const char* /*title*/) {}
  /// A setting and the values that it may have, both ends included.
  /// @{
  virtual void whole(const Knob& knob, int& value, int least, int most) = 0;
  virtual void number(const Knob& knob, Real& value, Real least, Real most) = 0;
  /// Each component between −most and most.
  virtual void vector(const Knob& knob, Vec3& value, Real most) = 0;
  virtual void toggle(const Knob& knob, bool& value) = 0;
  /// @param value place in the list of names
  virtual void choice(const Knob& knob, int& value, std::span<const char* const> names) = 0;
  /// A list of moves, each a place in the list of names.
  virtual void moves(const Knob& knob, std::vector<int>& value,
                     std::span<const char* const> names) = 0;
  /// @}
};

/// Sets the one setting that `name=value` names.
class KnobSetter final : public KnobVisitor {
 public:
  /// @throws std::invalid_argument unless there is a `=`
  explicit KnobSetter(const std::string& assignment);

  void whole(const Knob& knob, int& value, int least, int most) override;
  void number(const Knob& knob, Real& value, Real least, Real most) override;
  void vector(const Knob& knob, Vec3& value, Real most) override;
  void toggle(const Knob& knob, bool& value) override;
  void choice(const Knob& knob, int& value, std::span<const char* const> names) override;
  void moves(const Knob& knob, std::vector<int>& value,
             std::span<const char* const> names) override;

  /// Call after the visit. @throws std::invalid_argument that lists the names there are, unless one
  /// of them was meant
  void expect_found() const;

 private:
  bool is_meant(const Knob& knob);
  [[noreturn]] void refuse(const std::string& expected) const;
  Real to_number(const std::string& word, const std::string& expected) const;

  std::string name_;
  std::string text_;
  bool found_ = false;
  std::vector<std::string> names_;
};

/// Writes every setting with its value as `name=value`, one a line, with what else it may be.
class KnobLister final : public KnobVisitor {
 public:
  void whole(const Knob& knob, int& value, int least, int most) override;
  void number(const Knob& knob, Real& value, Real least, Real most) override;
  void vector(const Knob& knob, Vec3& value, Real most) override;
  void toggle(const Knob& knob, bool& value) override;
  void choice(const Knob& knob, int& value, std::span<const char* const> names) override;
  void moves(const Knob& knob, std::vector<int>& value,
             std::span<const char* const> names) override;

  /// All lines.
  const std::string& text() const { return text_; }

 private:
  void add(const Knob& knob, const std::string& value, const std::string& range);

  std::string text_;
};

/// A number without trailing zeros: "0.25", "3".
std::string short_number(double value, int digits = 4);

}  // namespace cs550::viewer
