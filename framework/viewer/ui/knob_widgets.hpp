#pragma once
/// @file knob_widgets.hpp
/// Knobs as widgets.

#include "viewer/knobs.hpp"

namespace cs550::viewer {

/// Shows every setting that it visits, in the present window; the user turns them.
class KnobWidgets final : public KnobVisitor {
 public:
  ~KnobWidgets() override { end_row(); }

  void section(const char* title) override;
  void whole(const Knob& knob, int& value, int least, int most) override;
  void number(const Knob& knob, Real& value, Real least, Real most) override;
  void vector(const Knob& knob, Vec3& value, Real most) override;
  void toggle(const Knob& knob, bool& value) override;
  void choice(const Knob& knob, int& value, std::span<const char* const> names) override;
  void moves(const Knob& knob, std::vector<int>& value,
             std::span<const char* const> names) override;

 private:
  /// Writes the label and leaves the rest of the line to the widget.
  void begin_row(const Knob& knob);
  void end_row();

  bool is_open_ = true;         ///< whether the section shows its settings
  bool half_row_used_ = false;  ///< two switches share a line
};

}  // namespace cs550::viewer
