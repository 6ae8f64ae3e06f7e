/// The substeps of a world, run by the worker. A random sample of them is run again here, one call
/// of a lab function at a time, and must give the same bits: the worker's process belongs to the
/// submission, which could report any trajectory.
#include <algorithm>
#include <random>
#include <string>
#include <utility>

#include "autograder/grader/judge/submission.hpp"
#include "autograder/grader/message.hpp"
#include "autograder/grader/remote/answer_indices.hpp"
#include "autograder/grader/substeps_archive.hpp"
#include "cs550/integration.hpp"
#include "engine/contacts/contact_constraints.hpp"
#include "engine/world/stages.hpp"

namespace cs550 {
namespace {

using grader::submission;
using serialisation::ByteReader;
using serialisation::ByteWriter;

constexpr std::string_view name = "run_substeps";

/// Mostly the first steps of a world, then fewer and fewer: about k·ln(n/k) of n steps. A step of
/// many constraints takes many calls, so that k is 4 for a tower and 0.1 for a large pyramid.
bool is_checked(const WorldState& world) {
  constexpr double constraints = 160;
  static std::mt19937_64 random(std::random_device{}());
  const double k = std::min(4.0, constraints / static_cast<double>(world.constraints.size()));
  return std::bernoulli_distribution(k / (k + static_cast<double>(world.step_count)))(random);
}

/// Replaces what substeps change. The judge's own bodies keep their masses, and its constraints
/// their bodies.
void take_output(WorldState& world, ByteReader& answer) {
  WorldState changed;
  changed.bodies = world.bodies;
  grader::archive_substeps_output(answer, changed);
  grader::keep_bodies(world.constraints, changed.constraints);
  for (RigidBody& body : changed.bodies) {
    if (body.kind != BodyKind::Static) refresh_velocity(body);
  }
  world.bodies = std::move(changed.bodies);
  world.constraints = std::move(changed.constraints);
  for (StageProblem& problem : changed.problems) world.problems.push_back(std::move(problem));
}

std::string output_of(WorldState& world) {
  ByteWriter bytes;
  grader::archive_substeps_output(bytes, world);
  return bytes.take();
}

void run_here(WorldState& world, const ContactStep& step, int count) {
  run_stage(world, Stage::Prepare, prepare, step);
  for (int i = 0; i < count; ++i) substep(world, step);
}

/// @returns whether the worker ran them. It does not if a function that they call is unwritten.
bool ask(WorldState& world, const ContactStep& step, int count) {
  ByteWriter request;
  request(grader::Request::Call, std::string(name));
  grader::archive_substeps_input(request, world);
  request(step, count);
  const std::string reply = submission().ask(name, request.take());
  ByteReader answer(reply);
  try {
    bool is_unwritten = false;
    answer(is_unwritten);
    if (is_unwritten) return false;
    take_output(world, answer);
  } catch (const cereal::Exception& error) {
    submission().fail_malformed(name, error.what());
  }
  if (answer.left() > 0) submission().fail_malformed(name, "it is too long");
  if (answer.has_non_finite() && !request.has_non_finite()) submission().fail_not_finite(name);
  return true;
}

}  // namespace

void run_substeps(WorldState& world, const ContactStep& step, int count) {
  const bool calls_the_submission = !world.constraints.empty();
  if (!calls_the_submission || world.settings.audit_momentum) return run_here(world, step, count);
  make_constraints(world);  // take_output() keeps their bodies
  if (!is_checked(world)) {
    if (!ask(world, step, count)) run_here(world, step, count);
    return;
  }
  WorldState here = world;
  run_here(here, step, count);
  if (!ask(world, step, count)) {
    world = std::move(here);
  } else if (output_of(world) != output_of(here)) {
    submission().fail_malformed(name, "the functions of the submission do not reproduce it");
  }
}

}  // namespace cs550
