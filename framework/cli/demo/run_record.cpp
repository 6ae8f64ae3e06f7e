#include "cli/demo/run_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "cli/system/terminal.hpp"

namespace cs550::cli {
namespace {

void line(std::ostream& out, const std::string& what, const std::string& how_much) {
  constexpr std::size_t column = 16;
  out << padded(what, column) << how_much << '\n';
}

/// In quotes, so that a name may contain a comma (RFC 4180).
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? "\"\"" : std::string(1, c);
  return result + "\"";
}

/// Each number after a comma, with the digits that restore a float.
template <class Numbers>
std::string columns(const Numbers& numbers) {
  std::string text;
  for (const Real number : numbers) text += fmt::format(",{:.9g}", number);
  return text;
}

/// Until the first step, nothing has derived the velocities of a dynamic body.
Velocities velocities(const World& world, const RigidBody& body) {
  const bool are_derived = world.step_count() > 0 || body.kind != BodyKind::Dynamic;
  if (are_derived) return {body.linear_velocity, body.angular_velocity};
  return velocities_from_momenta(body);
}

}  // namespace

RunRecord::RunRecord(const Scene& scene, const World& world)
    : scene_(scene), world_(world), energy_at_start_(energy(world, substep())) {}

void RunRecord::add_step(const World& world, double seconds) {
  ++steps_;
  seconds_ += seconds;
  const StepStats& stats = world.stats();
  for (std::size_t i = 0; i < stage_seconds_.size(); ++i) stage_seconds_[i] += stats.seconds[i];
  most_contacts_ = std::max(most_contacts_, stats.contacts);
  most_points_ = std::max(most_points_, stats.points);
  deepest_ = std::max(deepest_, -stats.deepest_separation);
  add_problems(world.problems());
}

void RunRecord::stop(const std::vector<StageProblem>& broken) {
  stopped_ = true;
  // The others follow from the first.
  add_problems(std::span(broken).first(std::min<std::size_t>(broken.size(), 1)));
}

void RunRecord::add_problems(std::span<const StageProblem> problems) {
  for (const StageProblem& problem : problems) {
    const auto same = [&](const StageProblem& known) { return known.message == problem.message; };
    if (std::none_of(problems_.begin(), problems_.end(), same)) problems_.push_back(problem);
  }
}

bool RunRecord::good() const { return problems_.empty() && !stopped_ && !too_deep(); }

bool RunRecord::too_deep() const {
  return scene_.max_penetration > 0 && deepest_ > scene_.max_penetration;
}

Real RunRecord::substep() const {
  return scene_.h / static_cast<Real>(std::max(1, scene_.settings.substeps));
}

void RunRecord::print(std::ostream& out) const {
  const auto bodies = world_.bodies();
  const auto dynamic = std::count_if(bodies.begin(), bodies.end(), [](const RigidBody& body) {
    return body.kind == BodyKind::Dynamic;
  });
  const StepStats& last = world_.stats();
  const Energy now = energy(world_, substep());

  out << indented(scene_.name + ": " + scene_.title, 0) << '\n';
  line(out, "bodies", fmt::format("{}, {} of them dynamic", world_.body_count(), dynamic));
  line(out, "contacts", fmt::format("{} at the end, {} at most", last.contacts, most_contacts_));
  line(out, "points", fmt::format("{} at the end, {} at most", last.points, most_points_));
  if (scene_.settings.sleeping) {
    line(out, "asleep", fmt::format("{} at the end; their contacts are not counted", last.asleep));
  }
  line(out, "steps",
       fmt::format("{} of {:.4g} ms, {:.4g} s simulated", steps_,
                   1000 * static_cast<double>(scene_.h), world_.time()));
  print_times(out);
  line(out, "energy",
       fmt::format("{:.6g} J at the start, {:.6g} J at the end", energy_at_start_.total(),
                   now.total()));
  line(out, "momentum error", fmt::format("{:.2g} of the sum of |P|", world_.momentum_error()));
  const std::string bound =
      scene_.max_penetration > 0
          ? fmt::format(", bound {:.4g} mm", 1000 * static_cast<double>(scene_.max_penetration))
          : "";
  line(out, "penetration",
       fmt::format("{:.3g} mm at most{}", 1000 * static_cast<double>(deepest_), bound));
  line(out, "state hash", fmt::format("{:016x}", world_.state_hash()));
  print_verdict(out);
}

void RunRecord::print_times(std::ostream& out) const {
  const double per_step = 1000.0 / std::max(1, steps_);
  line(out, "time", fmt::format("{:<8.3f}ms/step, {:.3g} s in all", seconds_ * per_step, seconds_));
  for (std::size_t i = 0; i < stage_seconds_.size(); ++i) {
    line(out, std::string("  ") + to_string(static_cast<Stage>(i)),
         fmt::format("{:<8.3f}ms/step", stage_seconds_[i] * per_step));
  }
}

void RunRecord::print_verdict(std::ostream& out) const {
  if (good()) return;
  out << '\n';
  if (!problems_.empty()) out << coloured("Stages that failed:", Colour::Red) << '\n';
  for (const StageProblem& problem : problems_) {
    const std::string lab = problem.lab > 0 ? fmt::format(", lab {}", problem.lab) : "";
    out << fmt::format("  {}{}, step {}:\n", to_string(problem.stage), lab, problem.step)
        << indented(problem.message, 4);
  }
  if (stopped_) {
    out << coloured(fmt::format("The run stopped before step {}, which loses the finite state.",
                                world_.step_count()),
                    Colour::Red)
        << "\nThe figures are those before it.\n";
  }
  if (too_deep()) {
    out << coloured("The penetration exceeds the scene's bound.", Colour::Red) << '\n';
  }
}

TrajectoryCsv::TrajectoryCsv(const std::filesystem::path& file) : file_(file) {
  file_.write(
      "step,time_s,body,name,x_m,y_m,z_m,qw,qx,qy,qz,"
      "vx_mps,vy_mps,vz_mps,wx_radps,wy_radps,wz_radps\n");
}

void TrajectoryCsv::add(const World& world, const Scene& scene) {
  for (std::size_t i = 0; i < world.bodies().size(); ++i) {
    const RigidBody& body = world.bodies()[i];
    if (body.kind == BodyKind::Static) continue;
    const Quat& q = body.pose.orientation;
    const auto [linear, angular] = velocities(world, body);
    file_.write(fmt::format("{},{:.9g},{},{}", world.step_count(), world.time(), i,
                            quoted(scene.body_names[i])) +
                columns(body.pose.position) + columns(std::array{q.w(), q.x(), q.y(), q.z()}) +
                columns(linear) + columns(angular) + '\n');
  }
}

}  // namespace cs550::cli
