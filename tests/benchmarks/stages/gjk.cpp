#include "benchmarks/stages/gjk.hpp"

#include <ccd/ccd.h>

#include <type_traits>

#include "cs550/hill_climbing.hpp"

namespace cs550::bench {
namespace {

static_assert(std::is_same_v<ccd_real_t, double>, "the distribution's libccd has double precision");

/// A body whose support points are exact: GJK and EPA compare differences of them.
class Climber {
 public:
  explicit Climber(const PosedShape& body)
      : body_(body),
        rotation_(body.pose.orientation.cast<double>().normalized().toRotationMatrix()),
        position_(body.pose.position.cast<double>()) {}

  Eigen::Vector3d support(const Eigen::Vector3d& direction) {
    const HalfEdgeMesh& mesh = body_.shape->mesh;
    const Vec3 local = (rotation_.transpose() * direction).cast<Real>();
    start_ = hill_climb(mesh, local, start_).vertex;
    return rotation_ * mesh.vertex(start_).cast<double>() + position_;
  }

 private:
  const PosedShape& body_;
  Eigen::Matrix3d rotation_;
  Eigen::Vector3d position_;
  Index start_ = 0;
};

void climb(const void* climber, const ccd_vec3_t* direction, ccd_vec3_t* result) {
  // The library passes back the pointer that it got, to an object that is not const.
  auto& body = *static_cast<Climber*>(const_cast<void*>(climber));
  const Eigen::Vector3d found = body.support(Eigen::Map<const Eigen::Vector3d>(direction->v));
  Eigen::Map<Eigen::Vector3d>(result->v) = found;
}

ccd_t settings() {
  constexpr unsigned long most_iterations = 500;  // against endless refinement; far above the usual
  // The library compares it with products of the depth and a gap (m²). Its default, 1e-4, stops shallow
  // contacts at gaps of a centimetre.
  constexpr ccd_real_t tolerance = 1e-8;
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = climb;
  ccd.support2 = climb;
  ccd.max_iterations = most_iterations;
  ccd.epa_tolerance = tolerance;
  return ccd;
}

}  // namespace

bool gjk_overlap(const PosedShape& a, const PosedShape& b) {
  Climber of_a(a), of_b(b);
  const ccd_t ccd = settings();
  return ccdGJKIntersect(&of_a, &of_b, &ccd) != 0;
}

std::optional<double> epa_depth(const PosedShape& a, const PosedShape& b) {
  Climber of_a(a), of_b(b);
  const ccd_t ccd = settings();
  ccd_real_t depth = 0;
  ccd_vec3_t direction, place;
  if (ccdGJKPenetration(&of_a, &of_b, &ccd, &depth, &direction, &place) != 0) return {};
  return static_cast<double>(depth);
}

}  // namespace cs550::bench
