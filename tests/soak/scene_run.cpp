#include "soak/scene_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "cs550/diagnostics.hpp"
#include "cs550/scene.hpp"

namespace cs550::test {
namespace {

using Json = nlohmann::json;

/// The thinness of a needle of 1 : 20. Thinner ones turn so fast in their contacts that the substeps do
/// not always keep the energy.
constexpr Real thin = Real(0.05);

bool is_needle(const RigidBody& body) {
  return body.kind == BodyKind::Dynamic &&
         body.inertia.trace() * body.inverse_inertia.trace() > 1 / (thin * thin);
}

/// The impulses of the naive solver reflect what gravity adds to a body in a step, if it reaches that body
/// through another one.
bool bounces_in_passes(const World& world) {
  if (world.settings().solver == SolverKind::Constraint) return false;
  for (Index i = 0; i < static_cast<Index>(world.bodies().size()); ++i) {
    if (world.definition(world.id_at(i)).restitution > 0) return true;
  }
  return false;
}

/// What a scene may gain (J). Overlapping bodies are pushed apart: each may get a few times the
/// push-out speed, and be lifted by a few lengths. There is no bound where a kinematic body pushes without
/// end, and for needles.
double allowed_gain(const World& world) {
  const double unit = static_cast<double>(world.settings().length_unit);
  const double gravity = static_cast<double>(world.settings().gravity.norm());
  const double push = 6 * unit * static_cast<double>(world.settings().max_push_speed);
  double mass = 0;
  for (const RigidBody& body : world.bodies()) {
    if (body.kind == BodyKind::Kinematic || is_needle(body)) return HUGE_VAL;
    mass += static_cast<double>(body.mass);
  }
  const double bounces = bounces_in_passes(world) ? 3 : 1;
  return bounces * mass * (push * push / 2 + 4 * gravity * unit);
}

/// Without weight, bodies that push each other to rest keep a momentum that is rounding and nothing else:
/// its error has no scale.
bool has_scale(const World& world) {
  if (!world.settings().gravity.isZero()) return true;
  const Real push = world.settings().max_push_speed * world.settings().length_unit;
  const auto bodies = world.bodies();
  return std::any_of(bodies.begin(), bodies.end(), [&](const RigidBody& body) {
    return body.linear_momentum.norm() > Real(1e-3) * push * body.mass;
  });
}

/// The laws that hold for a world, measured against its beginning.
class Laws {
 public:
  Laws(const World& world, Real h)
      : h_(h), start_(world), start_energy_(energy(world, h)), gain_(allowed_gain(world)) {}

  std::string broken_by(const World& world) const {
    if (!is_finite(world)) return "the state is not finite";
    if (!world.problems().empty()) return world.problems()[0].message;
    if (has_scale(world) && world.momentum_error() > 5e-4) {
      return fmt::format("momentum from nowhere: {:.2g} of the sum of |P|", world.momentum_error());
    }
    const double gain = energy(world, h_).invariant - start_energy_.invariant;
    const double allowed = gain_ + 0.1 * start_energy_.kinetic;
    if (gain > allowed) {
      return fmt::format("energy from nowhere: {:.3g} J gained, {:.3g} J allowed", gain, allowed);
    }
    return lost_body(world);
  }

 private:
  /// How far a body of this mass can have come in the time, with all the energy that there is.
  double reach(const World& world, const RigidBody& body) const {
    const double time = world.time();
    const double gravity = static_cast<double>(world.settings().gravity.norm());
    const double available = 2 * (start_energy_.kinetic + gain_);
    const double thrown = std::sqrt(2 * available / static_cast<double>(body.mass));
    const double unit = static_cast<double>(world.settings().length_unit);
    return 20 * unit + time * (2 * thrown + 10 * gravity * time);
  }

  std::string lost_body(const World& world) const {
    for (std::size_t i = 0; i < world.bodies().size(); ++i) {
      const RigidBody& body = world.bodies()[i];
      if (body.kind != BodyKind::Dynamic) continue;
      const Vec3 way = body.pose.position - start_.bodies()[i].pose.position;
      const double distance = static_cast<double>(way.norm());
      if (distance > reach(world, body)) {
        return fmt::format("body {} is {:.3g} m from where it began, {:.3g} m can be reached", i,
                           distance, reach(world, body));
      }
    }
    return "";
  }

  Real h_;
  World start_;
  Energy start_energy_;
  double gain_;
};

void write(const Json& document, const std::filesystem::path& file) {
  std::ofstream(file) << document.dump(1) << '\n';
}

/// Tries changes of a document, and keeps those after which it still has a fault.
class Shrinking {
 public:
  Shrinking(Json document, const std::filesystem::path& file)
      : document_(std::move(document)), file_(file) {}

  Json result() {
    shorten();
    bool smaller = true;
    while (smaller) {
      smaller = drop_bodies();
      smaller = drop_properties() || smaller;
    }
    shorten();
    write(document_, file_);
    return document_;
  }

 private:
  bool keep(const Json& smaller) {
    if (smaller == document_ || fault_of(smaller, file_).empty()) return false;
    document_ = smaller;
    return true;
  }

  void shorten() {
    for (int part = document_["steps"].get<int>() / 2; part > 0; part /= 2) {
      Json shorter = document_;
      shorter["steps"] = std::max(1, document_["steps"].get<int>() - part);
      while (keep(shorter)) shorter["steps"] = std::max(1, document_["steps"].get<int>() - part);
    }
  }

  bool drop_bodies() {
    bool any = false;
    for (std::size_t i = document_["bodies"].size(); i-- > 0 && document_["bodies"].size() > 1;) {
      Json fewer = document_;
      fewer["bodies"].erase(i);
      any = keep(fewer) || any;
    }
    return any;
  }

  bool drop_properties() {
    bool any = false;
    for (std::size_t i = 0; i < document_["bodies"].size(); ++i) {
      for (const char* key :
           {"orientation", "angular_velocity", "restitution", "friction", "mass"}) {
        Json plainer = document_;
        if (plainer["bodies"][i].erase(key) > 0) any = keep(plainer) || any;
      }
    }
    return any;
  }

  Json document_;
  const std::filesystem::path& file_;
};

}  // namespace

std::string fault_of(const Json& document, const std::filesystem::path& file) {
  write(document, file);
  SceneResult read = load_scene(file);
  if (!read) return "refused: " + read.error;
  read.scene.settings.audit_momentum = true;
  read.scene.settings.check_stages = true;
  World world = make_world(read.scene);
  const int substeps = world.settings().solver == SolverKind::Naive ? 1 : world.settings().substeps;
  const Laws laws(world, read.scene.h / static_cast<Real>(substeps));
  for (int step = 0; step < read.scene.steps; ++step) {
    world.step(read.scene.h);
    const std::string broken = laws.broken_by(world);
    if (!broken.empty()) return fmt::format("after step {}: {}", step, broken);
  }
  return "";
}

Json shrunk(Json document, const std::filesystem::path& file) {
  return Shrinking(std::move(document), file).result();
}

}  // namespace cs550::test
