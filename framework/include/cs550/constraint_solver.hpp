#pragma once
/// @file constraint_solver.hpp
/// **Lab 7:** Sequential impulses: every contact is a constraint JV + b ≥ 0. Constraints are solved
/// one at a time, repeatedly, with accumulated impulses. Document §4.2; Catto, *Iterative Dynamics
/// with Temporal Coherence* (GDC 2005), *Modeling and Solving Constraints* (GDC 2009), *Solver2D*
/// (2024).
///
/// Two immovable bodies: such a constraint has zero masses, and every function accepts it. No
/// impulse is applied, and no division by zero occurs.

#include <span>

#include "cs550/contact_constraint.hpp"

namespace cs550 {

/// One row of the Jacobian matrix, for the velocities V of two bodies:
/// JV = linear_a·v_A + angular_a·ω_A + linear_b·v_B + angular_b·ω_B.
struct ContactJacobian {
  Vec3 linear_a = {0, 0, 0};   ///< coefficient of v_A
  Vec3 angular_a = {0, 0, 0};  ///< coefficient of ω_A (m)
  Vec3 linear_b = {0, 0, 0};   ///< coefficient of v_B
  Vec3 angular_b = {0, 0, 0};  ///< coefficient of ω_B (m)
};

/// How penetration is corrected.
enum class ContactModel : std::uint8_t {
  Baumgarte,  ///< the document's bias: a fraction β of the error per substep, restitution in the bias
  Soft,       ///< a damped spring (Catto 2024), then relax passes, then apply_restitution()
};

/// The parameters of a substep.
struct ContactStep {
  Real h = 0;                               ///< duration of the substep (s)
  bool use_bias = true;                     ///< false in relax passes
  bool backwards = false;                   ///< solve in reverse order, as in every second step
  ContactModel model = ContactModel::Soft;  ///< how penetration is corrected
  Softness soft;                            ///< for contacts between two movable bodies
  Softness soft_static;                     ///< for contacts with an immovable body
  Real baumgarte = Real(0.2);               ///< β
  Real slop = 0;                            ///< penetration that Baumgarte leaves uncorrected (m)
  Real max_push_speed = HUGE_VALF;          ///< largest speed of recovery from penetration (m/s)
  Real restitution_threshold = 0;           ///< slower approaches do not bounce (m/s)
  int restitution_iterations = 1;           ///< sweeps of apply_restitution()
};

/// The bias b of one constraint in one pass, with the scales of its impulse.
struct ContactBias {
  Real velocity = 0;       ///< b (m/s): the constraint asks for v_n ≥ −b
  Real mass_scale = 1;     ///< of the effective mass, see Softness
  Real impulse_scale = 0;  ///< of the accumulated impulse, see Softness
};

/// **L7.1** The row J for a direction d at a contact: JV is the velocity along d of B's contact
/// point relative to A's.
/// @param direction d, unit, world frame
/// @param r_a, r_b contact from each centre of mass, world frame (m)
ContactJacobian contact_jacobian(const Vec3& direction, const Vec3& r_a, const Vec3& r_b);

/// **L7.2** The effective mass of a constraint, (JM⁻¹Jᵀ)⁻¹ (kg). Returns 0 for two immovable
/// bodies.
Real constraint_mass(const ContactJacobian& jacobian, const SolverBody& a, const SolverBody& b);

/// **L7.3** The bias b of a normal constraint, which asks for v_n ≥ −b. A negative bias pushes the
/// bodies apart.
///
/// - Separated (d > 0), in every pass and both models: the gap may close within this substep, but
///   not more (speculative contact).
/// - Penetrating (d ≤ 0), in a relax pass (`use_bias` is false): b = 0.
/// - Penetrating, Baumgarte: a fraction β of the penetration beyond the slop is corrected per
///   substep, at no more than max_push_speed.
/// - Penetrating, soft: a spring of constraint.softness corrects the whole penetration (no slop),
///   at no more than max_push_speed. Only here are the scales those of constraint.softness; in all
///   other cases they are those of a rigid contact, 1 and 0.
/// - Restitution belongs to the bias in the Baumgarte model only, and there only if `use_bias` is
///   true, e > 0 and v_n⁰ < −restitution_threshold, whether the bodies are separated or not. Of
///   bounce and correction the stronger demand holds, never their sum.
/// @param separation current separation d (m)
ContactBias contact_bias(const ContactConstraint& constraint, Real separation,
                         const ContactStep& step);

/// **L7.4** Computes what hardly changes during a step, for every constraint: normal_mass;
/// tangent_mass, the inverse of the 2 × 2 matrix JM⁻¹Jᵀ of the two rows for u and v; and softness,
/// which is soft_static if at least one of the bodies is immovable (inverse_mass of 0). For two
/// immovable bodies both masses are zero.
void prepare_contacts(std::span<ContactConstraint> constraints, std::span<const SolverBody> bodies,
                      const ContactStep& step);

/// **L7.5** Applies the accumulated impulses along n, u and v to B, and their opposite to A.
void warm_start(const ContactConstraint& constraint, SolverBody& a, SolverBody& b);

/// **L7.6** Solves the normal constraint once, at its contact_bias() and softened as described at
/// Softness. The effective mass is normal_mass, which the world may enlarge in relax passes.
/// normal_impulse is the sum of all impulses: it never becomes negative, a single impulse may. Both
/// bodies receive the change. The bias is that of the current separation, which follows the
/// displacements of the bodies since the step began, to first order and with r_a and r_b as they
/// are.
void solve_normal(ContactConstraint& constraint, SolverBody& a, SolverBody& b,
                  const ContactStep& step);

/// **L7.7** Solves both friction constraints once, u and v together. The accumulated pair stays in
/// the disk ‖λ‖ ≤ μ·λ_n, where λ_n is the *accumulated* normal impulse. Both bodies receive the
/// change.
///
/// - Sticking: the slip along u and v stops, if the disk allows it.
/// - Sliding: otherwise friction opposes the slip, also where the effective mass is anisotropic,
///   with the smaller eigenvalue of tangent_mass as the mass. The accumulated pair is scaled back
///   onto the disk. A pair that is inside the disk already stays as it is.
void solve_friction(ContactConstraint& constraint, SolverBody& a, SolverBody& b);

/// **L7.8** One pass over all constraints. Forwards: from the first to the last, the normal and
/// then the friction of each. Backwards: in exact reverse order, so that normals are solved last.
///
/// A pass and its reverse together form a *symmetric* Gauss–Seidel iteration. Its error decays
/// without oscillation. Passes in one direction only have complex eigenvalues, and can amplify slow
/// modes of a warm-started stack. Both: Saad, *Iterative Methods for Sparse Linear Systems*, §4.1.
void solve_contacts(std::span<ContactConstraint> constraints, std::span<SolverBody> bodies,
                    const ContactStep& step);

/// **L7.9** Applies restitution. The world calls it after the relax passes of each substep in which
/// something can bounce (e > 0), in the soft model only.
///
/// - A constraint *bounces* if e > 0, impact_handled is false and v_n⁰ < −restitution_threshold.
/// - A contact is *touching* if λ_n > 0 or its current separation is less than −2·v_n⁰·h. The
///   second case covers corners that would arrive within two substeps: other corners may have
///   stopped the body already. Decided at each visit, since λ_n changes from sweep to sweep.
///
/// If at least one constraint with λ_n > 0 bounces, restitution_iterations sweeps visit all
/// constraints in order. They let those that bounce leave at e times their speed of approach, and
/// keep the other touching ones from approaching, so that an impact passes through resting
/// contacts. Contacts are rigid here, and accumulated impulses do not become negative.
///
/// Finally, whether or not anything bounced, impact_handled is set for every constraint with a
/// positive λ_n. It is never cleared here. The impact thus belongs to the substep in which λ_n
/// first becomes positive.
void apply_restitution(std::span<ContactConstraint> constraints, std::span<SolverBody> bodies,
                       const ContactStep& step);

}  // namespace cs550
