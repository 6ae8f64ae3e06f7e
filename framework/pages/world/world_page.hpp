#pragma once
/// @file world_page.hpp
/// The page of a running scene.

#include <deque>
#include <optional>

#include "pages/base/page.hpp"
#include "pages/world/overlays.hpp"
#include "pages/world/world_frame.hpp"

namespace cs550::pages {

/// The page of a running scene.
class WorldPage final : public Page {
 public:
  WorldPage(std::string scene, Isolation isolation);

  int lab() const override { return 0; }
  std::string title() const override;
  std::string story() const override;
  void describe(ControlVisitor& visit) override;
  void refresh() override;
  const Content& content() const override { return content_; }
  void advance() override { take_steps(1); }

  /// Begins a scene with its own settings.
  void load(const std::string& scene);
  /// Restarts the scene with the present settings, and a student's code in a new process.
  void reset();
  /// Advances by steps of the scene's own length.
  void take_steps(int count);
  /// Throws a box.
  /// @param direction of any length but 0
  void throw_box(const Vec3& from, const Vec3& direction);

  /// The first body that a ray from the eye hits. Immovable bodies hide others, except where
  /// open_view() makes them translucent.
  struct Hit {
    Index body = no_index;      ///< index in bodies
    Vec3 point = Vec3::Zero();  ///< world (m)
  };
  std::optional<Hit> pick(const Vec3& origin, const Vec3& direction) const;
  /// Shows the state of a body; if empty, of none.
  void select(std::optional<Index> body);
  std::optional<Index> selected() const { return selected_; }
  /// Pulls a body at a point, until let_go().
  void grab(const Hit& hit);
  void drag_to(const Vec3& target) { pull_.target = target; }
  void let_go() { pull_ = {}; }
  bool is_dragging() const { return pull_.body != no_index; }

  /// Length of a step (s).
  Real step_length() const { return info_.h; }
  const WorldFrame& frame() const { return frame_; }
  const WorldSettings& settings() const { return settings_; }
  /// Leaves out timings, which differ from run to run, so that pictures can be compared.
  void show_times(bool show) { shows_times_ = show; }

 private:
  void ask(const WorldRequest& request);
  void receive(const WorldFrame& frame);
  Bounds down_to_the_ground(Bounds box) const;
  void find_focus();
  std::vector<Solid> solids() const;
  std::vector<Fact> facts() const;

  std::string scene_;
  Isolation isolation_;
  std::unique_ptr<isolation::Service<WorldRequest, WorldFrame>> service_;
  SceneInfo info_;
  WorldFrame frame_;
  std::vector<MeshPtr> meshes_;
  std::deque<StepSample> history_;
  WorldSettings settings_;
  Overlays overlays_;
  Pull pull_;
  std::optional<Index> selected_;
  std::string failure_;
  Focus focus_;
  Focus first_focus_;  ///< when the scene began
  Content content_;
  bool is_loaded_ = false;
  bool shows_times_ = true;
};

}  // namespace cs550::pages
