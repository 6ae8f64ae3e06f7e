#include <algorithm>
#include <cmath>

#include "figure.hpp"
#include "free_box.hpp"
#include "sketch.hpp"

namespace cs550::book {
namespace {

constexpr RotationMethod methods[] = {RotationMethod::Explicit, RotationMethod::ImplicitMidpoint};

double energy_of(const RigidBody& body) { return static_cast<double>(kinetic_energy(body)); }

/// time, energy over its start: explicit, midpoint
void energy_rotation(std::ostream& out) {
  RigidBody bodies[2] = {free_box(Vec3(Real(0.5), 5, Real(0.5))),
                         free_box(Vec3(Real(0.5), 5, Real(0.5)))};
  const double start = energy_of(bodies[0]);
  for (int i = 0; i <= 1200; ++i) {
    out << i / 60.0 << ' ' << energy_of(bodies[0]) / start << ' ' << energy_of(bodies[1]) / start
        << '\n';
    for (int k = 0; k < 2; ++k) turn(bodies[k], frame, methods[k]);
  }
}

using Vector = Eigen::Vector3d;

/// A free body in double precision, by the classical Runge–Kutta method: what steps are measured by.
struct Exact {
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  Vector l;                 // angular momentum, world
  Eigen::Matrix3d inverse;  // of the inertia, body frame

  Vector omega(const Eigen::Quaterniond& at) const { return at * (inverse * (at.conjugate() * l)); }
  Eigen::Vector4d rate(const Eigen::Vector4d& coeffs) const {
    const Eigen::Quaterniond at(coeffs);
    const Vector w = omega(at.normalized());
    return 0.5 * (Eigen::Quaterniond(0, w.x(), w.y(), w.z()) * at).coeffs();
  }
  void step(double h) {
    const Eigen::Vector4d c = q.coeffs();
    const Eigen::Vector4d k1 = rate(c), k2 = rate(c + h / 2 * k1), k3 = rate(c + h / 2 * k2),
                          k4 = rate(c + h * k3);
    q = Eigen::Quaterniond(Eigen::Vector4d(c + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4))).normalized();
  }
};

Exact exact_of(const RigidBody& body) {
  return {body.pose.orientation.cast<double>(), body.angular_momentum.cast<double>(),
          body.inverse_inertia.cast<double>()};
}

/// step, error of the orientation after 1 s (rad): explicit, midpoint
void convergence(std::ostream& out) {
  const Vec3 spin(Real(0.5), 5, Real(0.5));
  Exact exact = exact_of(free_box(spin));
  for (int i = 0; i < 100000; ++i) exact.step(1e-5);
  for (const int steps : {15, 30, 60, 120, 240, 480, 960}) {
    out << 1.0 / steps;
    for (const RotationMethod method : methods) {
      RigidBody body = free_box(spin);
      for (int i = 0; i < steps; ++i) turn(body, Real(1) / static_cast<Real>(steps), method);
      out << ' ' << body.pose.orientation.cast<double>().angularDistance(exact.q);
    }
    out << '\n';
  }
}

/// time, ω_y in the body's frame
void flips(std::ostream& out) {
  RigidBody body = free_box(Vec3(Real(0.5), 5, Real(0.5)));
  for (int i = 0; i <= 720; ++i) {
    out << i / 60.0 << ' ' << body.pose.unrotate(body.angular_velocity).y() << '\n';
    turn(body, frame, RotationMethod::ImplicitMidpoint);
  }
}

/// The largest gain of energy of a free body within a second, over some directions of its spin.
double largest_gain(const Vec3& half_extents, double speed) {
  Sequence random(17);
  double largest = 1;
  for (int i = 0; i < 24; ++i) {
    RigidBody body = free_box(static_cast<Real>(speed) * random.direction(), half_extents);
    const double start = energy_of(body);
    for (int step = 0; step < 60; ++step) {
      turn(body, frame, RotationMethod::ImplicitMidpoint);
      largest = std::max(largest, energy_of(body) / start);
    }
  }
  return largest;
}

/// contraction factor, largest gain of energy within a second: of a board, a needle, a box
void fixed_point(std::ostream& out) {
  for (int k = 0; k <= 50; ++k) {
    const double kappa = std::pow(10.0, -1 + 4.0 * k / 50);
    out << kappa;
    for (const Vec3& half : {Vec3(Real(0.02), Real(0.2), 1), Vec3(Real(0.02), Real(0.03), 1),
                             Vec3(Real(0.2), Real(0.5), 1)}) {
      const Vec3 squares = half.cwiseProduct(half);
      const double ratio =
          static_cast<double>((squares.y() + squares.z()) / (squares.x() + squares.y()));
      out << ' ' << largest_gain(half, kappa * 2 * 60 / ratio);
    }
    out << '\n';
  }
}

}  // namespace

std::vector<Table> rigid_body_tables() {
  return {{"energy_rotation", energy_rotation},
          {"convergence", convergence},
          {"flips", flips},
          {"fixed_point", fixed_point}};
}

}  // namespace cs550::book
