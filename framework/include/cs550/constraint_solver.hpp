#pragma once
/// @file constraint_solver.hpp
/// **Lab 7:** Sequential impulses: every contact is a constraint Jv + b ≥ 0, solved a constraint at a time,
/// over and over, with accumulated impulses. Document §4.2; Catto, *Iterative Dynamics with Temporal
/// Coherence* (GDC 2005), *Modeling and Solving Constraints* (GDC 2009), *Solver2D* (2024).

#include <span>

#include "cs550/contact_constraint.hpp"

namespace cs550 {

/// One constraint of the constraint matrix: JV = linear_a·v_A + angular_a·ω_A + linear_b·v_B + angular_b·ω_B.
struct ContactJacobian {
  Vec3 linear_a = {0, 0, 0};   ///< times v of A
  Vec3 angular_a = {0, 0, 0};  ///< times ω of A (m)
  Vec3 linear_b = {0, 0, 0};   ///< times v of B
  Vec3 angular_b = {0, 0, 0};  ///< times ω of B (m)
};

/// How penetration is undone.
enum class ContactModel : std::uint8_t {
  Baumgarte,  ///< the document's bias: a share β of the error per step, restitution in the bias
  Soft,       ///< a damped spring (Catto 2024), then a relax pass, then restitution
};

/// What the solver is told about a substep.
struct ContactStep {
  Real h = 0;                               ///< length of the substep (s)
  bool use_bias = true;                     ///< false in the relax pass
  bool backwards = false;                   ///< visit the constraints in reverse: every second pass
  ContactModel model = ContactModel::Soft;  ///< how penetration is undone
  Softness soft;                            ///< contacts between movable bodies
  Softness soft_static;                     ///< contacts with an immovable body
  Real baumgarte = Real(0.2);               ///< β
  Real slop = 0;                            ///< penetration that Baumgarte leaves alone (m)
  Real max_push_speed = HUGE_VALF;          ///< fastest recovery from penetration (m/s)
  Real restitution_threshold = 0;           ///< approaches slower than this do not bounce (m/s)
  int restitution_iterations = 1;           ///< sweeps of apply_restitution()
};

/// b of one constraint in one pass, with what softness makes of the impulse.
struct ContactBias {
  Real velocity = 0;       ///< b (m/s): the constraint asks for v_n ≥ −b
  Real mass_scale = 1;     ///< of the effective mass, see Softness
  Real impulse_scale = 0;  ///< of the accumulated impulse, see Softness
};

/// **L7.1** The constraint of J for a direction d at a contact: [−d, −r_A × d, d, r_B × d].
/// @param direction unit, world frame
/// @param r_a, r_b contact from each centre of mass, world frame (m)
ContactJacobian contact_jacobian(const Vec3& direction, const Vec3& r_a, const Vec3& r_b);

/// **L7.2** (JM⁻¹Jᵀ)⁻¹ (kg); 0 for two immovable bodies.
Real constraint_mass(const ContactJacobian& jacobian, const SolverBody& a, const SolverBody& b);

/// **L7.3** The bias of a constraint, negative to push apart.
/// - Apart (d > 0): b = d/h, whatever the pass: the gap may close, not more (speculative contact).
/// - In the relax pass otherwise: b = 0.
/// - In penetration, Baumgarte: position term b_p = (β/h)·min(0, d + slop), not below −max_push_speed.
/// - In penetration, soft: b_p = rate·d, not below −max_push_speed, with the constraint's mass and impulse
///   scales. A spring under load rests a little deep; that is what brings a leaning stack back.
/// - Restitution, in the Baumgarte model only: b_r = e·v_n⁰ where v_n⁰ < −threshold, else 0, and
///   b = min(b_p, b_r), never the sum, whether the bodies are apart or not.
/// @param separation d at present (m)
ContactBias contact_bias(const ContactConstraint& constraint, Real separation,
                         const ContactStep& step);

/// **L7.4** Fills normal_mass, tangent_mass (the inverse of the 2 × 2 matrix JM⁻¹Jᵀ of u and v) and
/// softness (soft_static where either body is immovable) of every constraint.
void prepare_contacts(std::span<ContactConstraint> constraints, std::span<const SolverBody> bodies,
                      const ContactStep& step);

/// **L7.5** Applies the impulses that a constraint has accumulated: −λ to A, +λ to B, along n, u and v.
void warm_start(const ContactConstraint& constraint, SolverBody& a, SolverBody& b);

/// **L7.6** One normal impulse: λ = −m·(Jv + b), softened, added to the accumulated one, which is
/// kept ≥ 0; the difference is applied. An impulse may go back down. The present separation is the
/// constraint's plus n·(Δx_B + Δθ_B × r_B − Δx_A − Δθ_A × r_A): the same J, applied to displacements.
void solve_normal(ContactConstraint& constraint, SolverBody& a, SolverBody& b,
                  const ContactStep& step);

/// **L7.7** One friction impulse: u and v solved together, λ = λ_acc − m_t·(J_u v, J_v v). If the pair
/// lies in the disk ‖λ‖ ≤ μ·λ_n of the *accumulated* normal impulse, the contact sticks. If not, it
/// slides, and friction must point against the slip: m_t turns away from it where the mass differs
/// between directions, so the pair is then λ_acc − s·(J_u v, J_v v), with s the smaller eigenvalue of
/// m_t, scaled back onto the disk.
void solve_friction(ContactConstraint& constraint, SolverBody& a, SolverBody& b);

/// **L7.8** One pass over the constraints: forwards the normal and then the friction of each; `backwards`
/// exactly the reverse, from the last constraint to the first, friction and then the normal, which has its
/// last word. A pass and its reverse together are a *symmetric* Gauss–Seidel step: its
/// error only decays. Passes in one direction make slow modes of a warm-started stack swing up
/// (complex eigenvalues; Saad, *Iterative Methods for Sparse Linear Systems*, §4.1).
void solve_contacts(std::span<ContactConstraint> constraints, std::span<SolverBody> bodies,
                    const ContactStep& step);

/// **L7.9** Bounces. A constraint bounces if its `impact_handled` is not set and its approach velocity is below
/// −threshold. If one with λ_n > 0 does, restitution_iterations sweeps drive v_n of every constraint in touch
/// to its target, accumulated and clamped as in solve_normal(): −e·v_n⁰ if it bounces, else 0, for a
/// blow is passed on through contacts that rest. In touch is a constraint with λ_n > 0, or whose present
/// separation is less than −2·v_n⁰·h: the first corners of a body stop it before the others arrive.
/// Then every constraint with λ_n > 0 is marked as `impact_handled`. Runs after the relax pass of each substep; the
/// substep in which λ_n first becomes positive is the impact's.
void apply_restitution(std::span<ContactConstraint> constraints, std::span<SolverBody> bodies,
                       const ContactStep& step);

}  // namespace cs550
