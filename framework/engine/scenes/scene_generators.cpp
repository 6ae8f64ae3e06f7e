#include "engine/scenes/scene_generators.hpp"

#include "engine/scenes/scene_cost.hpp"
#include "engine/scenes/scene_random.hpp"

namespace cs550 {
namespace {

/// What a generator may use of its scene.
struct Context {
  const SceneShapes& shapes;
  SceneCost& cost;
};

/// The most in one direction; the product is checked by SceneCost.
constexpr int most_in_a_row = 1000000;

/// Copies of one body, each at its own place.
class Copies {
 public:
  explicit Copies(NamedBody original) : original_(std::move(original)) {}

  /// A copy, displaced from the original's position (world frame, m).
  NamedBody& add(const Vec3& displacement) {
    NamedBody copy = original_;
    copy.def.pose.position += displacement;
    if (!copy.name.empty()) copy.name += " " + std::to_string(bodies_.size() + 1);
    bodies_.push_back(std::move(copy));
    return bodies_.back();
  }

  /// The size of one copy's bounds (world frame, m).
  Vec3 size() const {
    return world_bounds({original_.def.shape.get(), original_.def.pose}).extent();
  }

  std::vector<NamedBody> take() { return std::move(bodies_); }

 private:
  NamedBody original_;
  std::vector<NamedBody> bodies_;
};

Copies copies_of_body(SceneReader& generator, const Context& context) {
  const std::string example = R"({"shape": {"kind": "box", "half_extents": [0.5, 0.5, 0.5]}})";
  generator.require("body", example);
  return Copies(read_body(generator.object("body", example), context.shapes));
}

/// How far the i-th of `count` places is from their middle, in places.
Real from_middle(int i, int count) {
  return static_cast<Real>(i) - Real(0.5) * static_cast<Real>(count - 1);
}

/// Layers of rows of columns; the body's position is the middle of the lowest layer.
std::vector<NamedBody> grid(SceneReader& generator, const Context& context) {
  Copies copies = copies_of_body(generator, context);
  std::vector<int> count = {8, 8, 1};
  Vec3 spacing = Vec3::Constant(2);
  generator.need("count", count, 1, most_in_a_row);
  generator.need("spacing", spacing, Range::Positive);
  context.cost.add_bodies(std::int64_t{count[0]} * count[1] * count[2], generator.path_of("count"));
  for (int z = 0; z < count[2]; ++z) {
    for (int y = 0; y < count[1]; ++y) {
      for (int x = 0; x < count[0]; ++x) {
        const Vec3 place(from_middle(x, count[0]), from_middle(y, count[1]), static_cast<Real>(z));
        copies.add(spacing.cwiseProduct(place));
      }
    }
  }
  return copies.take();
}

/// One on top of the other; the body's position is that of the lowest.
std::vector<NamedBody> stack(SceneReader& generator, const Context& context) {
  Copies copies = copies_of_body(generator, context);
  int count = 10;
  Real gap = 0;
  generator.need("count", count, 1, most_in_a_row);
  generator.read("gap", gap);
  context.cost.add_bodies(count, generator.path_of("count"));
  const Real step = copies.size().z() + gap;
  for (int i = 0; i < count; ++i) copies.add(static_cast<Real>(i) * step * Vec3::UnitZ());
  return copies.take();
}

/// A row of bodies along x in the middle of a structure, `row` rows above its foot.
void add_row(Copies& copies, int row, int columns, Real shift, Real gap) {
  const Vec3 step = copies.size() + Vec3::Constant(gap);
  for (int column = 0; column < columns; ++column) {
    const Real x = (from_middle(column, columns) + shift) * step.x();
    copies.add({x, 0, static_cast<Real>(row) * step.z()});
  }
}

/// Rows along x in running bond: shifted by a quarter of a body, the lowest one along +x, the next along −x. The
/// body's position is the middle of the lowest row before the shift.
std::vector<NamedBody> wall(SceneReader& generator, const Context& context) {
  Copies copies = copies_of_body(generator, context);
  int columns = 15;
  int rows = 14;
  Real gap = 0;
  generator.need("columns", columns, 1, most_in_a_row);
  generator.need("rows", rows, 1, most_in_a_row);
  generator.read("gap", gap);
  context.cost.add_bodies(std::int64_t{rows} * columns, generator.path_of("rows"));
  for (int row = 0; row < rows; ++row) {
    const Real quarter_brick = Real(row % 2 == 0 ? 0.25 : -0.25);
    add_row(copies, row, columns, quarter_brick, gap);
  }
  return copies.take();
}

/// Rows along x, each one body shorter; the body's position is the middle of the lowest row.
std::vector<NamedBody> pyramid(SceneReader& generator, const Context& context) {
  Copies copies = copies_of_body(generator, context);
  int rows = 20;
  Real gap = 0;
  generator.need("rows", rows, 1, most_in_a_row);
  generator.read("gap", gap);
  context.cost.add_bodies(std::int64_t{rows} * (rows + 1) / 2, generator.path_of("rows"));
  for (int row = 0; row < rows; ++row) add_row(copies, row, rows - row, 0, gap);
  return copies.take();
}

/// One after the other from the body's position, along the world's x axis at first; the heading of
/// each is turned a little further about z.
std::vector<NamedBody> line(SceneReader& generator, const Context& context) {
  Copies copies = copies_of_body(generator, context);
  int count = 40;
  Real spacing = Real(0.5);
  Real turn_degrees = 0;
  generator.need("count", count, 1, most_in_a_row);
  generator.need("spacing", spacing, Range::Positive);
  generator.read("turn_degrees", turn_degrees);
  context.cost.add_bodies(count, generator.path_of("count"));

  Vec3 displacement = Vec3::Zero();
  for (int i = 0; i < count; ++i) {
    const Real angle = static_cast<Real>(i) * turn_degrees * pi / 180;
    const Quat heading = rotation_exp(angle * Vec3::UnitZ());
    Pose& pose = copies.add(displacement).def.pose;
    pose.orientation = heading * pose.orientation;
    displacement += spacing * (heading * Vec3::UnitX());
  }
  return copies.take();
}

/// What the bodies of a drop look like.
struct DropShapes {
  bool boxes = false;
  std::vector<int> vertices = {16, 32};       ///< of a hull: least and most
  Vec3 smallest = Vec3::Constant(Real(0.3));  ///< half extents of a box, radii of a hull (m)
  Vec3 largest = Vec3::Constant(Real(0.5));
};

ShapePtr random_shape(const SceneReader& generator, const DropShapes& range, SceneRandom& random) {
  Vec3 size;
  for (int axis = 0; axis < 3; ++axis) {
    size[axis] = random.real(range.smallest[axis], range.largest[axis]);
  }
  if (range.boxes) return SceneShapes::box(generator, size);
  const int vertices = random.integer(range.vertices[0], range.vertices[1]);
  return SceneShapes::random_hull(generator, vertices, random.bits(), size);
}

void add_cost(const SceneReader& generator, SceneCost& cost, int count, const DropShapes& shapes) {
  const std::string path = generator.path_of("count");
  cost.add_bodies(count, path);
  cost.add_points(std::int64_t{count} * (shapes.boxes ? box_vertices : shapes.vertices[1]), path);
}

/// Random bodies, randomly turned, in layers that fall one after the other; the body's position is
/// the middle of the lowest layer.
std::vector<NamedBody> drop(SceneReader& generator, const Context& context) {
  int count = 100;
  std::vector<int> columns = {8, 8};
  Vec3 spacing = Vec3::Constant(Real(1.2));
  std::uint32_t seed = 1;
  DropShapes shapes;
  generator.need("count", count, 1, most_in_a_row);
  generator.need("columns", columns, 1, 1000);
  generator.need("spacing", spacing, Range::Positive);
  generator.need("seed", seed);
  generator.read("shapes", shapes.boxes, Names<bool>{{"hulls", false}, {"boxes", true}});
  if (!shapes.boxes) {
    generator.read("vertices", shapes.vertices, 4, 1000);
    if (shapes.vertices[0] > shapes.vertices[1]) {
      generator.refuse("vertices", "the smaller number first", "[16, 32]");
    }
  }
  generator.read("smallest", shapes.smallest, Range::Positive);
  generator.read("largest", shapes.largest, Range::Positive);
  if ((shapes.smallest.array() > shapes.largest.array()).any()) {
    if (generator.has("smallest")) {
      generator.refuse("smallest", "no more than \"largest\" along each axis", "[0.3, 0.3, 0.3]");
    }
    generator.refuse("largest", "no less than \"smallest\" along each axis", "[0.5, 0.5, 0.5]");
  }
  generator.require("body", R"({"position": [0, 0, 2]})");
  SceneReader body = generator.object("body", "{}");
  if (body.has("orientation")) {
    throw SceneFault(
        body.path_of("orientation"),
        "expected no orientation: the bodies of a drop are turned at random; remove it");
  }
  Copies copies(read_body_without_shape(body));
  body.refuse_other_keys();
  add_cost(generator, context.cost, count, shapes);

  SceneRandom random(seed);
  const int layer_size = columns[0] * columns[1];
  for (int i = 0; i < count; ++i) {
    const int column = i % columns[0];
    const int row = i % layer_size / columns[0];
    const int layer = i / layer_size;
    const Vec3 place(from_middle(column, columns[0]), from_middle(row, columns[1]), Real(layer));
    NamedBody& added = copies.add(spacing.cwiseProduct(place));
    added.def.shape = random_shape(generator, shapes, random);
    added.def.pose.orientation = random.orientation();
  }
  return copies.take();
}

using Generate = std::vector<NamedBody> (*)(SceneReader& generator, const Context& context);
const Names<Generate> generator_kinds = {
    {"grid", grid},       {"stack", stack}, {"wall", wall},
    {"pyramid", pyramid}, {"line", line},   {"drop", drop},
};

}  // namespace

std::vector<NamedBody> generate_bodies(SceneReader generator, const SceneShapes& shapes,
                                       SceneCost& cost) {
  Generate generate = grid;
  generator.need("kind", generate, generator_kinds);
  std::vector<NamedBody> bodies = generate(generator, {shapes, cost});
  generator.refuse_other_keys();
  return bodies;
}

}  // namespace cs550
