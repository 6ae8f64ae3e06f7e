#pragma once
/// @file contact.hpp
/// Contact manifolds: what collision detection passes to the solvers.

#include "cs550/separating_axis.hpp"
#include "cs550/static_vector.hpp"

namespace cs550 {

/// Identifies the pair of features that form a contact point, in 32 bits. Ids from two steps are
/// equal if and only if the same features meet, so that the impulse of the last step can be carried
/// over. Layout: 3 bits for the kind, 14 for an element of A, 14 for an element of B.
struct FeatureId {
  /// The kinds of the features that meet, and the body that owns the reference face.
  enum class Kind : std::uint8_t {
    None,           ///< no features
    VertexOnFaceA,  ///< reference face of A, incident vertex of B
    CrossingOnA,    ///< reference on A: side edge of A, incident edge of B
    CornerOfFaceA,  ///< reference on A: vertex of A inside the incident face of B
    VertexOnFaceB,  ///< reference face of B, incident vertex of A
    CrossingOnB,    ///< reference on B: incident edge of A, side edge of B
    CornerOfFaceB,  ///< reference on B: incident face of A, vertex of B
    Edges,          ///< edge of A against edge of B
  };

  std::uint32_t bits = 0;  ///< kind, element of A, element of B, from the highest bits down

  FeatureId() = default;  ///< no features
  /// @param of_a, of_b indices of the vertex, face or *edge* (half-edge / 2) that the kind asks for
  FeatureId(Kind kind, Index of_a, Index of_b)
      : bits(static_cast<std::uint32_t>(kind) << 28 | static_cast<std::uint32_t>(of_a) << 14 |
             static_cast<std::uint32_t>(of_b)) {}

  /// The fields of `bits`.
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

/// One point of a manifold: a point on A, a point on B, their separation along the normal, and the
/// impulses that the solver has accumulated there. Those of a sleeping pair are of another substep,
/// see World::sleeping_contacts().
struct ContactPoint {
  Vec3 anchor_a = {0, 0, 0};      ///< on A, A's body frame (m)
  Vec3 anchor_b = {0, 0, 0};      ///< on B, B's body frame (m)
  Real separation = 0;            ///< normal·(point on B − point on A) (m)
  FeatureId feature;              ///< the features that meet here
  Real normal_impulse = 0;        ///< λ_n ≥ 0 of the last substep (N·s)
  Vec2 tangent_impulse = {0, 0};  ///< λ_u, λ_v of the last substep (N·s)
};

/// The largest number of points in a manifold.
inline constexpr int max_manifold_points = 4;

/// The contact between two bodies: up to four points that share a normal.
struct Manifold {
  Vec3 normal = {0, 0, 0};   ///< n, unit, A → B, world frame
  Vec3 tangent = {0, 0, 0};  ///< u, unit, perpendicular to n, world frame; v = n × u
  AxisFeature reference = AxisFeature::None;  ///< the feature that the manifold was built from
  /// Some may be across a gap (separation > 0), before the bodies touch: speculative contacts.
  StaticVector<ContactPoint, max_manifold_points> points;
};

/// A pair of bodies that may touch, and the properties of their surfaces.
struct Contact {
  Index body_a = no_index;  ///< body_a < body_b
  Index body_b = no_index;  ///< index in World::bodies(), like body_a
  Manifold manifold;        ///< if it has no points, the bodies do not touch
  Real friction = 0;        ///< Coulomb's μ
  Real restitution = 0;     ///< Newton's e, 0–1
};

/// Transfers accumulated impulses from the manifold of the last step for warm starting. Points with
/// the same feature id are matched first. A point with a new feature id takes the impulse of the
/// nearest unmatched old point, so that a pair keeps its load when a corner slides over an edge.
/// Impulses are transferred as world vectors and projected onto the new normal, where they must not
/// pull, and onto the new tangents.
/// @param before manifold of the last step
/// @param now manifold of this step; points without a match keep their impulses
void carry_impulses(const Manifold& before, Manifold& now);

}  // namespace cs550
