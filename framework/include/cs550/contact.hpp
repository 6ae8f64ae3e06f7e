#pragma once
/// @file contact.hpp
/// Where and how two bodies touch: what collision detection hands to the solvers.

#include "cs550/separating_axis.hpp"
#include "cs550/static_vector.hpp"

namespace cs550 {

/// Names the pair of features that makes a contact point, in 32 bits: equal in two steps if and
/// only if the same features meet, so that last step's impulse can be carried over.
/// 3 bits of kind, 14 bits for an element of A, 14 bits for an element of B.
struct FeatureId {
  /// Which kinds of features meet, and on whose reference face.
  enum class Kind : std::uint8_t {
    None,           ///< names nothing
    VertexOnFaceA,  ///< reference face of A, incident vertex of B
    CrossingOnA,    ///< reference on A: side edge of A, incident edge of B
    CornerOfFaceA,  ///< reference on A: vertex of A inside the incident face of B
    VertexOnFaceB,  ///< reference face of B, incident vertex of A
    CrossingOnB,    ///< reference on B: incident edge of A, side edge of B
    CornerOfFaceB,  ///< reference on B: incident face of A, vertex of B
    Edges,          ///< edge of A against edge of B
  };

  std::uint32_t bits = 0;  ///< kind, element of A, element of B, from the highest bits down

  FeatureId() = default;  ///< names nothing
  /// @param of_a, of_b numbers of the vertex, face or *edge* (half-edge / 2) that the kind names
  FeatureId(Kind kind, Index of_a, Index of_b)
      : bits(static_cast<std::uint32_t>(kind) << 28 | static_cast<std::uint32_t>(of_a) << 14 |
             static_cast<std::uint32_t>(of_b)) {}

  /// What the bits say.
  /// @{
  Kind kind() const { return static_cast<Kind>(bits >> 28); }
  Index of_a() const { return static_cast<Index>(bits >> 14 & 0x3fffU); }
  Index of_b() const { return static_cast<Index>(bits & 0x3fffU); }
  /// @}

  /// Whether the same features meet.
  /// @{
  bool operator==(const FeatureId& other) const { return bits == other.bits; }
  bool operator!=(const FeatureId& other) const { return bits != other.bits; }
  /// @}
};

/// One point of a manifold: a point on A and a point on B that are `separation` apart along the
/// normal, and the impulses that the solver has gathered there.
struct ContactPoint {
  Vec3 anchor_a = {0, 0, 0};      ///< on A, A's body frame (m)
  Vec3 anchor_b = {0, 0, 0};      ///< on B, B's body frame (m)
  Real separation = 0;            ///< normal·(point on B − point on A) (m)
  FeatureId feature;              ///< what meets here
  Real normal_impulse = 0;        ///< λ_n ≥ 0 of the last substep (N·s)
  Vec2 tangent_impulse = {0, 0};  ///< λ_u, λ_v of the last substep (N·s)
};

/// The most points of a manifold.
inline constexpr int max_manifold_points = 4;

/// How two bodies touch: up to four points that share a normal.
struct Manifold {
  Vec3 normal = {0, 0, 0};   ///< n, unit, A → B, world frame
  Vec3 tangent = {0, 0, 0};  ///< u, unit, perpendicular to n, world frame; v = n × u
  AxisFeature reference = AxisFeature::None;  ///< whose face the points were clipped against
  StaticVector<ContactPoint, max_manifold_points> points;  ///< none while apart
};

/// A pair of bodies that may touch, and what their surfaces are like.
struct Contact {
  Index body_a = no_index;  ///< body_a < body_b
  Index body_b = no_index;  ///< place in World::bodies(), like body_a
  Manifold manifold;        ///< empty while they do not touch
  Real friction = 0;        ///< Coulomb's μ
  Real restitution = 0;     ///< Newton's e, 0–1
};

/// Gives the points of `now` the impulses of the points of `before` that have the same feature, as
/// far as they push along the new normal. Points whose features are new continue the nearest old
/// point that is left over, so that the load a pair carries is not dropped when a corner slides over
/// an edge. The tangent impulses are carried as a world vector and projected onto the new tangents.
void carry_impulses(const Manifold& before, Manifold& now);

}  // namespace cs550
