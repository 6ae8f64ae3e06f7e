#include "run_record.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

#include "terminal.hpp"

namespace cs550::cli {
namespace {

/// A number with so many significant digits and its unit.
std::string in_unit(double value, const char* unit, int digits = 4) {
  std::ostringstream text;
  text << std::setprecision(digits) << value << ' ' << unit;
  return text.str();
}

std::string fixed(double value, int decimals) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(decimals) << value;
  return text.str();
}

std::string in_hex(std::uint64_t value) {
  std::ostringstream text;
  text << std::hex << std::setw(16) << std::setfill('0') << value;
  return text.str();
}

void line(std::ostream& out, const std::string& what, const std::string& how_much) {
  constexpr std::size_t column = 16;
  out << padded(what, column) << how_much << '\n';
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
  for (const StageProblem& problem : world.problems()) {
    const auto same = [&](const StageProblem& known) { return known.message == problem.message; };
    if (std::none_of(problems_.begin(), problems_.end(), same)) problems_.push_back(problem);
  }
}

bool RunRecord::good() const {
  return problems_.empty() && !too_deep() && std::isfinite(energy(world_, substep()).total());
}

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

  out << scene_.name << ": " << scene_.title << "\n\n";
  line(out, "bodies",
       std::to_string(world_.body_count()) + ", " + std::to_string(dynamic) + " of them dynamic");
  line(out, "contacts",
       std::to_string(last.contacts) + " at the end, " + std::to_string(most_contacts_) +
           " at most");
  line(out, "points",
       std::to_string(last.points) + " at the end, " + std::to_string(most_points_) + " at most");
  line(out, "steps",
       std::to_string(steps_) + " of " + in_unit(1000 * static_cast<double>(scene_.h), "ms") +
           ", " + in_unit(world_.time(), "s simulated"));
  print_times(out);
  line(out, "energy",
       in_unit(energy_at_start_.total(), "J", 6) + " at the start, " +
           in_unit(now.total(), "J", 6) + " at the end");
  line(out, "momentum error", in_unit(world_.momentum_error(), "of the sum of |P|", 2));
  const std::string bound =
      scene_.max_penetration > 0
          ? ", bound " + in_unit(1000 * static_cast<double>(scene_.max_penetration), "mm")
          : "";
  line(out, "penetration", in_unit(1000 * static_cast<double>(deepest_), "mm at most", 3) + bound);
  line(out, "state hash", in_hex(world_.state_hash()));
  print_verdict(out);
}

void RunRecord::print_times(std::ostream& out) const {
  const double per_step = 1000.0 / std::max(1, steps_);
  line(out, "time",
       padded(fixed(seconds_ * per_step, 3), 8) + "ms/step, " + in_unit(seconds_, "s in all", 3));
  for (std::size_t i = 0; i < stage_seconds_.size(); ++i) {
    line(out, std::string("  ") + to_string(static_cast<Stage>(i)),
         padded(fixed(stage_seconds_[i] * per_step, 3), 8) + "ms/step");
  }
}

void RunRecord::print_verdict(std::ostream& out) const {
  if (good()) return;
  out << '\n';
  if (!problems_.empty()) out << coloured("Stages that did not work:", Colour::Red) << '\n';
  for (const StageProblem& problem : problems_) {
    out << indented(std::string(to_string(problem.stage)) + ", lab " + std::to_string(problem.lab) +
                        ", step " + std::to_string(problem.step) + ":",
                    2)
        << indented(problem.message, 4);
  }
  if (!std::isfinite(energy(world_, substep()).total())) {
    out << coloured("The energy is not finite: a body has been lost.", Colour::Red) << '\n';
  }
  if (too_deep()) {
    out << coloured("Bodies went deeper into each other than the scene's bound.", Colour::Red)
        << '\n';
  }
}

}  // namespace cs550::cli
