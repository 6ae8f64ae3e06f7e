#pragma once
/// @file control_widgets.hpp
/// Widgets for the settings of a page.

#include "pages/base/controls.hpp"

namespace cs550::viewer {

using namespace pages;

/// Visits settings and shows a widget for each in the present window.
class ControlWidgets final : public ControlVisitor {
 public:
  ~ControlWidgets() override { end_row(); }

  void section(const char* title) override;
  void whole(const Control& control, int& value, int least, int most) override;
  void number(const Control& control, Real& value, Real least, Real most) override;
  void vector(const Control& control, Vec3& value, Real most) override;
  void toggle(const Control& control, bool& value) override;
  void choice(const Control& control, int& value, std::span<const char* const> names) override;
  void moves(const Control& control, std::vector<int>& value,
             std::span<const char* const> names) override;

 private:
  void slider(const Control& control, int& value, int least, int most, const std::string& format);
  /// Writes the label and leaves the rest of the line to the widget.
  void begin_row(const Control& control);
  void end_row();

  bool is_open_ = true;         ///< whether the section shows its settings
  bool half_row_used_ = false;  ///< two switches share a line
};

}  // namespace cs550::viewer
