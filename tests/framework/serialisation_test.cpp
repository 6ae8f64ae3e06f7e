// Every function of the labs can be called across a wire: its arguments and its answer are values
// that survive becoming bytes.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <functional>
#include <regex>
#include <set>

#include "cs550/naive_solver.hpp"
#include "cs550/primitives.hpp"
#include "support/fixtures.hpp"
#include "support/random.hpp"
#include "support/shape_archive.hpp"

namespace cs550::test {
namespace {

/// What a parameter becomes while it waits to be passed: a value that owns all that it says.
template <class P>
struct Parameter {
  using Stored = std::remove_cvref_t<P>;
  static P pass(Stored& stored) { return stored; }
};
template <class T>
struct Parameter<std::span<T>> {
  using Stored = std::vector<std::remove_const_t<T>>;
  static std::span<T> pass(Stored& stored) { return stored; }
};
template <class T>
struct Parameter<T*> {
  using Stored = T;
  static T* pass(Stored& stored) { return &stored; }
};

template <class... P>
using Arguments = std::tuple<typename Parameter<P>::Stored...>;

/// Calls a function; its answer is what it returns, and the arguments, which it may have changed.
template <class R, class... P>
auto answer(R (*function)(P...), Arguments<P...> arguments) {
  const auto call = [&](auto&... stored) { return function(Parameter<P>::pass(stored)...); };
  if constexpr (std::is_void_v<R>) {
    std::apply(call, arguments);
    return arguments;
  } else {
    const R result = std::apply(call, arguments);
    return std::tuple_cat(std::tuple<R>(result), arguments);
  }
}

/// Two overlapping bodies, the shapes known to whoever receives a call.
struct Bodies {
  ShapePtr cube = fixture_shape("cube");
  ShapePtr hull = fixture_shape("dodecahedron");
  PosedShape a{cube.get(), {{0.1F, 0.2F, 0.3F}, rotation_exp({0.5F, 0.6F, 0.7F})}};
  PosedShape b{hull.get(), {{1.2F, 0.9F, 1.0F}, rotation_exp({-1, 2, 0.5F})}};
  SeparatingAxis axis = find_separating_axis(a, b, {}, HUGE_VALF);
  ShapeRegistry known;

  Bodies() {
    known.add(cube);
    known.add(hull);
  }
};

/// One function with arguments, to be called here and across the wire.
struct Case {
  std::string function;
  std::function<void(const ShapeRegistry&)> check;
};

template <class R, class... P>
Case make_case(const char* name, R (*function)(P...), typename Parameter<P>::Stored... stored) {
  const Arguments<P...> arguments(stored...);
  return {name, [=](const ShapeRegistry& known) {
            const auto direct = answer(function, arguments);

            const std::string request = to_bytes(arguments);
            const auto received = from_bytes<Arguments<P...>>(request, known);
            const std::string reply = to_bytes(answer(function, received));
            const auto restored = from_bytes<std::remove_const_t<decltype(direct)>>(reply, known);

            EXPECT_EQ(to_bytes(restored), to_bytes(direct));
            EXPECT_EQ(to_bytes(received), request);
          }};
}

/// The name comes from the function, so that it cannot be wrong.
#define CALL(function, ...) make_case(#function, function, __VA_ARGS__)

RigidBody spinning_body() {
  RigidBody body = make_dynamic_body(2, Vec3(3, 4, 5).asDiagonal(),
                                     {{1, 2, 3}, rotation_exp({0.1F, -0.2F, 0.3F})});
  set_velocity(body, {1, 2, 3}, {0.5F, 5, 0.5F});
  refresh_velocity(body);
  body.force = {7, 8, 9};
  body.torque = {-1, -2, -3};
  return body;
}

void add_cases_of_lab_1(std::vector<Case>& cases) {
  const RigidBody body = spinning_body();
  cases.push_back(CALL(add_force, body, {1, 2, 3}, {4, 5, 6}));
  cases.push_back(CALL(apply_impulse, body, {1, 2, 3}, {4, 5, 6}));
  cases.push_back(CALL(world_inverse_inertia, body));
  cases.push_back(CALL(refresh_velocity, body));
  cases.push_back(CALL(integrate_momentum, body, 0.01F));
  cases.push_back(CALL(integrate_pose, body, 0.01F, RotationMethod::ImplicitMidpoint));
}

void add_cases_of_labs_2_and_3(std::vector<Case>& cases, const Bodies& bodies) {
  const TriangleSoup soup = prism_soup(6, 1, 2);
  const HalfEdgeMesh mesh = fixture_mesh("triangulated_cube");
  const std::vector<Triangle> open(soup.triangles.begin() + 1, soup.triangles.end());
  cases.push_back(CALL(build_half_edge_mesh, soup.vertices, soup.triangles));
  cases.push_back(CALL(build_half_edge_mesh, soup.vertices, open));
  cases.push_back(CALL(polygon_plane, soup.vertices));
  cases.push_back(CALL(face_plane, mesh, 3));
  cases.push_back(CALL(merge_coplanar_faces, mesh, coplanar_tolerance));

  const HalfEdgeMesh sphere = fixture_mesh("icosphere2");
  cases.push_back(CALL(support_brute_force, sphere.vertices, {1, 2, 3}));
  cases.push_back(CALL(hill_climb, sphere, {1, 2, 3}, 5, {}));
  cases.push_back(CALL(support, bodies.b, {1, 2, 3}, 5));
}

void add_cases_of_lab_4(std::vector<Case>& cases, const Bodies& bodies) {
  const auto& [cube, hull, a, b, axis, known] = bodies;
  cases.push_back(CALL(is_minkowski_face, Vec3::UnitX(), Vec3::UnitY(), Vec3(1, 1, 1).normalized(),
                       Vec3(1, 1, -1).normalized()));
  cases.push_back(CALL(query_face_directions, a, b));
  cases.push_back(CALL(query_edge_directions, a, b));
  cases.push_back(CALL(find_separating_axis, a, b, axis, 0.1F));
  cases.push_back(CALL(overlap, a, b));
}

void add_cases_of_lab_5(std::vector<Case>& cases, const Bodies& bodies) {
  const auto& [cube, hull, a, b, axis, known] = bodies;
  ClipPolygon triangle;
  for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 2, 0)}) {
    const Index edge = triangle.size();
    triangle.push_back(
        {corner, {ClipEdge::Source::Incident, edge}, {ClipEdge::Source::Reference, edge + 1}});
  }
  std::vector<ContactPoint> points;
  Random random(31);
  for (Index i = 0; i < 9; ++i) {
    ContactPoint& point = points.emplace_back();
    point.anchor_a = random.point_in_box({1, 1, 0.01F});
    point.anchor_b = random.point_in_box({1, 1, 0.01F});
    point.separation = random.real(-0.1F, 0);
    point.feature = {FeatureId::Kind::CrossingOnA, i, 2 * i};
    point.normal_impulse = random.real(0, 1);
    point.tangent_impulse = {0.5F, -0.5F};
  }
  cases.push_back(
      CALL(clip_polygon, triangle, Plane{Vec3::UnitX(), 1}, {ClipEdge::Source::Reference, 7}));
  cases.push_back(CALL(find_incident_face, b, axis.axis));
  SeparatingAxis face_axis = axis;
  face_axis.feature = AxisFeature::FaceA;
  cases.push_back(CALL(face_manifold, a, b, face_axis, 0.1F));
  cases.push_back(CALL(edge_manifold, a, b, axis));
  cases.push_back(CALL(reduce_manifold, points, Vec3::UnitZ()));
  cases.push_back(CALL(build_manifold, a, b, axis, 0.1F));
}

BodyVelocity moving(Random& random) {
  BodyVelocity body;
  body.v = random.point_in_box({3, 3, 3});
  body.w = random.point_in_box({3, 3, 3});
  body.inverse_mass = random.real(0.5F, 2);
  body.world_inverse_inertia = Vec3(2, 3, 4).asDiagonal();
  body.delta_position = random.point_in_box({0.01F, 0.01F, 0.01F});
  body.delta_rotation = random.point_in_box({0.01F, 0.01F, 0.01F});
  return body;
}

/// A contact that approaches, overlaps, slides and has impulses from before.
ContactRow touching(Random& random) {
  ContactRow row;
  row.body_a = 0;
  row.body_b = 1;
  row.n = random.unit_vector();
  row.u = any_perpendicular(row.n);
  row.r_a = random.point_in_box({1, 1, 1});
  row.r_b = random.point_in_box({1, 1, 1});
  row.separation = -0.1F;
  row.friction = 0.4F;
  row.restitution = 0.5F;
  row.normal_mass = 0.7F;
  row.tangent_mass << 0.6F, 0.1F, 0.1F, 0.5F;
  row.softness = {10, 0.9F, 0.1F};
  row.approach_velocity = -2;
  row.normal_impulse = 1;
  row.tangent_impulse = {0.2F, 0.1F};
  return row;
}

void add_cases_of_labs_6_and_7(std::vector<Case>& cases) {
  Random random(32);
  const BodyVelocity a = moving(random);
  const BodyVelocity b = moving(random);
  const ContactRow row = touching(random);
  const std::vector<ContactRow> rows = {row, touching(random), touching(random)};
  const std::vector<BodyVelocity> bodies = {a, b};
  ContactStep step;
  step.h = 0.004F;
  step.backwards = true;
  step.soft = {20, 0.8F, 0.2F};
  step.soft_static = {40, 0.7F, 0.3F};
  step.slop = 0.001F;
  step.max_push_speed = 3;
  step.restitution_threshold = 0.5F;
  step.restitution_iterations = 3;
  ContactStep relax = step;
  relax.use_bias = false;
  const ContactJacobian jacobian = contact_jacobian(row.n, row.r_a, row.r_b);

  cases.push_back(CALL(effective_mass, a, b, row.r_a, row.r_b, row.n));
  cases.push_back(CALL(normal_velocity, a, b, row.r_a, row.r_b, row.n));
  cases.push_back(CALL(resolve_contacts_naive, rows, bodies));

  cases.push_back(CALL(contact_jacobian, row.n, row.r_a, row.r_b));
  cases.push_back(CALL(constraint_mass, jacobian, a, b));
  cases.push_back(CALL(contact_bias, row, row.separation, step));
  cases.push_back(CALL(contact_bias, row, row.separation, relax));
  cases.push_back(CALL(prepare_contacts, rows, bodies, step));
  cases.push_back(CALL(warm_start, row, a, b));
  cases.push_back(CALL(solve_normal, row, a, b, step));
  cases.push_back(CALL(solve_friction, row, a, b));
  cases.push_back(CALL(solve_contacts, rows, bodies, step));
  cases.push_back(CALL(apply_restitution, rows, bodies, step));
}

std::vector<Case> all_cases(const Bodies& bodies) {
  std::vector<Case> cases;
  add_cases_of_lab_1(cases);
  add_cases_of_labs_2_and_3(cases, bodies);
  add_cases_of_lab_4(cases, bodies);
  add_cases_of_lab_5(cases, bodies);
  add_cases_of_labs_6_and_7(cases);
  return cases;
}

/// The functions whose comment names a step of a lab, in all headers of the contract.
std::set<std::string> declared_lab_functions() {
  const std::regex step(R"(\*\*L\d+\.\d+\*\*)");
  const std::regex function(R"((\w+)\()");
  std::set<std::string> names;
  for (const auto& header :
       std::filesystem::directory_iterator(std::string(CS550_ASSETS) + "/../include/cs550")) {
    std::ifstream file(header.path());
    bool belongs_to_a_lab = false;
    for (std::string line; std::getline(file, line);) {
      std::smatch match;
      if (line.starts_with("///")) {
        belongs_to_a_lab = belongs_to_a_lab || std::regex_search(line, step);
      } else if (belongs_to_a_lab && std::regex_search(line, match, function)) {
        names.insert(match[1]);
        belongs_to_a_lab = false;
      }
    }
  }
  return names;
}

TEST(Serialisation, EveryLabFunctionCanBeCalledAcrossAWire) {
  const Bodies bodies;
  ASSERT_TRUE(bodies.axis.edges) << "an edge manifold needs a pair of edges";
  for (const Case& test_case : all_cases(bodies)) {
    SCOPED_TRACE(test_case.function);
    test_case.check(bodies.known);
  }
}

TEST(Serialisation, CoversTheFunctionsThatTheHeadersDeclare) {
  std::set<std::string> covered;
  for (const Case& test_case : all_cases(Bodies())) covered.insert(test_case.function);
  EXPECT_EQ(covered, declared_lab_functions());
  EXPECT_EQ(covered.size(), 36U);
}

/// Sends a value whose every byte is 1 to where every byte is 0. Members are words of four bytes, or
/// smaller with padding around them: a word that is still 0 is a member that was not sent.
template <class T>
void expect_every_word_sent(const char* name) {
  alignas(T) std::array<std::byte, sizeof(T)> sent;
  alignas(T) std::array<std::byte, sizeof(T)> received{};
  sent.fill(std::byte{1});
  std::istringstream stream(to_bytes(reinterpret_cast<const T&>(sent)));
  cereal::BinaryInputArchive archive(stream);
  archive(reinterpret_cast<T&>(received));
  for (std::size_t i = 0; i < sizeof(T); i += 4) {
    EXPECT_NE(std::count(&received[i], &received[i] + 4, std::byte{1}), 0)
        << "a member of " << name << " at byte " << i;
  }
}

TEST(Serialisation, NoMemberIsForgotten) {
#define EXPECT_EVERY_WORD_SENT(type) expect_every_word_sent<type>(#type)
  EXPECT_EVERY_WORD_SENT(Plane);
  EXPECT_EVERY_WORD_SENT(Pose);
  EXPECT_EVERY_WORD_SENT(RigidBody);
  EXPECT_EVERY_WORD_SENT(HalfEdge);
  EXPECT_EVERY_WORD_SENT(Face);
  EXPECT_EVERY_WORD_SENT(MeshIssue);
  EXPECT_EVERY_WORD_SENT(Support);
  EXPECT_EVERY_WORD_SENT(SupportPoint);
  EXPECT_EVERY_WORD_SENT(FaceQuery);
  EXPECT_EVERY_WORD_SENT(EdgeQuery);
  EXPECT_EVERY_WORD_SENT(SeparatingAxis);
  EXPECT_EVERY_WORD_SENT(ClipEdge);
  EXPECT_EVERY_WORD_SENT(ClipVertex);
  EXPECT_EVERY_WORD_SENT(FeatureId);
  EXPECT_EVERY_WORD_SENT(ContactPoint);
  EXPECT_EVERY_WORD_SENT(BodyVelocity);
  EXPECT_EVERY_WORD_SENT(Softness);
  EXPECT_EVERY_WORD_SENT(ContactRow);
  EXPECT_EVERY_WORD_SENT(ContactJacobian);
  EXPECT_EVERY_WORD_SENT(ContactStep);
  EXPECT_EVERY_WORD_SENT(ContactBias);
}

TEST(Serialisation, AShapeIsNamedByItsContent) {
  const ShapePtr cube = fixture_shape("cube");
  const ShapePtr twin = make_shape(fixture_mesh("cube")).shape;
  EXPECT_EQ(content_hash(*cube), content_hash(*twin));
  EXPECT_NE(content_hash(*cube), content_hash(*fixture_shape("needle")));
  EXPECT_LT(to_bytes(PosedShape{cube.get(), {}}).size(), 50U);
}

TEST(Serialisation, AShapeThatWasNeverSentIsMissed) {
  const std::string bytes = to_bytes(PosedShape{fixture_shape("cube").get(), {}});
  EXPECT_THROW(from_bytes<PosedShape>(bytes, {}), std::out_of_range);
}

}  // namespace
}  // namespace cs550::test
