#include "viewer/render/solid_renderer.hpp"

#include <algorithm>
#include <string>
#include <tuple>

namespace cs550::viewer {
namespace {

constexpr int shadow_unit = 0;
constexpr int fine_shadow_side = 2048;   ///< pixels
constexpr int quick_shadow_side = 1024;  ///< pixels
const Vec3 light = Vec3(Real(-0.3), Real(-0.7), Real(1.15)).normalized();

constexpr const char* place_source = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 face_normal;
layout(location = 2) in float edge_height;
layout(location = 3) in vec3 place;
layout(location = 4) in vec4 turn;
layout(location = 5) in vec4 tint;
layout(location = 6) in float is_ground;

vec3 rotate(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }
)";

constexpr const char* vertex_source = R"(
uniform mat4 camera;
out vec3 world;
out float height;
flat out vec3 normal;
flat out vec4 paint;
flat out float ground;

void main() {
  world = place + rotate(turn, position);
  normal = rotate(turn, face_normal);
  height = edge_height;
  paint = tint;
  ground = is_ground;
  gl_Position = camera * vec4(world, 1.0);
}
)";

constexpr const char* shadow_vertex_source = R"(
uniform mat4 light_matrix;
void main() {
  gl_Position = light_matrix * vec4(place + rotate(turn, position), 1.0);
}
)";

constexpr const char* shadow_fragment_source = "void main() {}\n";

/// Directional light and hemispherical ambient light, in linear colour.
constexpr const char* fragment_source = R"(
uniform mat4 light_matrix;
uniform sampler2DShadow shadows;
uniform vec3 light;
uniform vec3 eye;
uniform vec3 focus;
uniform float focus_radius;
uniform float texel_metres;
uniform float canvas_height;

in vec3 world;
in float height;
flat in vec3 normal;
flat in vec4 paint;
flat in float ground;
out vec4 colour;

float open(vec3 place, vec2 offset) {
  return texture(shadows, vec3(place.xy + offset, place.z - 0.0005));
}

// The share of the light that arrives: an average over 3 x 3 samples of the map. If the four
// corners agree, they are enough.
float lit(float facing) {
  vec3 lifted = world + normal * texel_metres * (2.5 - 1.5 * facing);
  vec3 place = 0.5 + 0.5 * (light_matrix * vec4(lifted, 1.0)).xyz;
  if (is_quick) return open(place, vec2(0.0));
  vec2 texel = 1.7 / vec2(textureSize(shadows, 0));
  float corners = open(place, -texel) + open(place, texel) +
                  open(place, vec2(texel.x, -texel.y)) + open(place, vec2(-texel.x, texel.y));
  if (corners < 0.01) return 0.0;
  if (corners > 3.99) return 1.0;
  float sides = open(place, vec2(texel.x, 0.0)) + open(place, vec2(-texel.x, 0.0)) +
                open(place, vec2(0.0, texel.y)) + open(place, vec2(0.0, -texel.y));
  return (corners + 2.0 * sides + 4.0 * open(place, vec2(0.0))) / 16.0;
}

// The share of a pixel that an edge of the face covers. Faces of a few pixels show no edges.
float edge_cover() {
  float slope = max(length(vec2(dFdx(height), dFdy(height))), 1e-9);
  return (1.0 - smoothstep(0.4, 1.5, height / slope)) * smoothstep(2.0, 7.0, 1.0 / slope);
}

// Lines a metre apart on level ground.
float grid_cover() {
  vec2 width = fwidth(world.xy);
  vec2 away = abs(fract(world.xy - 0.5) - 0.5) / max(width, vec2(1e-9));
  vec2 line = (1.0 - smoothstep(0.3, 1.3, away)) * (1.0 - smoothstep(0.1, 0.35, width));
  return max(line.x, line.y) * smoothstep(0.9, 0.99, normal.z);
}

void main() {
  vec3 base = pow(paint.rgb, vec3(2.2));
  float facing = max(dot(normal, light), 0.0);
  float sun = facing > 0.0 ? facing * lit(facing) : 0.0;
  vec3 sky = mix(vec3(0.30, 0.285, 0.27), vec3(0.42, 0.45, 0.50), 0.5 + 0.5 * normal.z);
  vec3 towards = normalize(eye - world);
  float gleam = pow(max(dot(reflect(-light, normal), towards), 0.0), 24.0) * 0.06 * sun;
  vec3 shaded = base * (sky + vec3(0.66, 0.635, 0.59) * sun) + gleam;

  float cover = edge_cover();
  shaded = mix(shaded, base * 0.22, (ground > 0.5 ? 0.25 : 0.75) * cover);
  if (ground > 0.5) shaded = mix(shaded, shaded * 0.84, grid_cover());
  float far = smoothstep(2.5, 7.0, length(world.xy - focus.xy) / focus_radius);
  shaded = mix(shaded, backdrop(gl_FragCoord.y / canvas_height), far);
  colour = vec4(pow(shaded, vec3(1.0 / 2.2)), mix(paint.a, 1.0, cover * 0.8));
}
)";

std::string joined(const char* first, const char* second) { return std::string(first) + second; }

Shader solid_shader(RenderQuality quality) {
  const std::string is_quick = quality == RenderQuality::Quick ? "true" : "false";
  const std::string fragment =
      "const bool is_quick = " + is_quick + ";\n" + backdrop_source + fragment_source;
  return {"solid", joined(place_source, vertex_source).c_str(), fragment.c_str()};
}

void append(std::vector<float>& floats, const Solid& solid) {
  const Vec3& p = solid.pose.position;
  const Quat& q = solid.pose.orientation;
  const Rgba& c = solid.colour;
  floats.insert(floats.end(), {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w(), c.x(), c.y(), c.z(),
                               c.w(), solid.is_ground ? 1.0F : 0.0F});
}

}  // namespace

SolidRenderer::SolidRenderer()
    : shadow_shader_("shadow", joined(place_source, shadow_vertex_source).c_str(),
                     shadow_fragment_source),
      fine_{solid_shader(RenderQuality::Fine), ShadowMap(fine_shadow_side), false},
      quick_{solid_shader(RenderQuality::Quick), ShadowMap(quick_shadow_side), false} {}

const SolidMesh& SolidRenderer::on_card(const MeshPtr& mesh) {
  auto found = meshes_.find(mesh.get());
  if (found == meshes_.end()) {
    found = meshes_.emplace(mesh.get(), Cached{mesh, SolidMesh(*mesh), true}).first;
  }
  found->second.is_used = true;
  return found->second.on_card;
}

/// Solids that can be drawn together are neighbours. The nearest come first, because hidden pixels
/// are then not shaded. The ground is behind everything and comes last.
std::vector<const Solid*> SolidRenderer::drawing_order(const Projection& projection) const {
  struct Entry {
    bool is_ground;
    std::size_t mesh;
    Real depth;
    const Solid* solid;
  };
  std::map<const HalfEdgeMesh*, std::size_t> first_use;
  std::vector<Entry> entries;
  for (const Solid& solid : solids_) {
    if (!solid.mesh) continue;
    const auto mesh = first_use.emplace(solid.mesh.get(), first_use.size()).first;
    const Real depth = (solid.pose.position - projection.eye()).dot(projection.forward());
    entries.push_back({solid.is_ground, mesh->second, depth, &solid});
  }
  std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.is_ground, a.mesh, a.depth) < std::tie(b.is_ground, b.mesh, b.depth);
  });
  std::vector<const Solid*> order;
  order.reserve(entries.size());
  for (const Entry& entry : entries) order.push_back(entry.solid);
  return order;
}

void SolidRenderer::fill(const Projection& projection) {
  opaque_.clear();
  translucent_.clear();
  std::vector<float> floats;
  int place = 0;
  for (const Solid* solid : drawing_order(projection)) {
    const SolidMesh& mesh = on_card(solid->mesh);
    const Batch alone{&mesh, place++, 1, solid->pose.position, solid->is_ground};
    append(floats, *solid);
    if (solid->colour.w() < 1) {
      translucent_.push_back(alone);
    } else if (!opaque_.empty() && opaque_.back().mesh == &mesh &&
               opaque_.back().is_ground == solid->is_ground &&
               opaque_.back().first + opaque_.back().count == alone.first) {
      ++opaque_.back().count;
    } else {
      opaque_.push_back(alone);
    }
  }
  glBindBuffer(GL_ARRAY_BUFFER, instances_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(floats.size() * sizeof(float)),
               floats.data(), GL_STREAM_DRAW);
}

void SolidRenderer::throw_shadows(Look& look) {
  look_ = &look;
  if (look.are_shadows_drawn) return;
  look.are_shadows_drawn = true;
  light_matrix_ = look.shadows.begin(light, focus_.center, Real(1.3) * focus_.radius);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  shadow_shader_.use();
  shadow_shader_.set("light_matrix", light_matrix_);
  for (const Batch& batch : opaque_) {
    if (!batch.is_ground) batch.mesh->draw_outline(instances_, batch.first, batch.count);
  }
}

bool SolidRenderer::set(std::span<const Solid> solids, const Focus& focus) {
  if (focus == focus_ && std::equal(solids.begin(), solids.end(), solids_.begin(), solids_.end())) {
    return false;
  }
  solids_.assign(solids.begin(), solids.end());
  focus_ = focus;
  fine_.are_shadows_drawn = false;
  quick_.are_shadows_drawn = false;
  return true;
}

void SolidRenderer::begin(const Projection& projection, RenderQuality quality) {
  for (auto& [address, cached] : meshes_) cached.is_used = false;
  fill(projection);
  std::erase_if(meshes_, [](const auto& entry) { return !entry.second.is_used; });
  throw_shadows(quality == RenderQuality::Fine ? fine_ : quick_);
}

void SolidRenderer::use(const Projection& projection, Size canvas) const {
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  look_->shadows.bind(shadow_unit);
  const Shader& shader = look_->shader;
  shader.use();
  shader.set("camera", projection.matrix());
  shader.set("light_matrix", light_matrix_);
  shader.set("shadows", shadow_unit);
  shader.set("light", light);
  shader.set("eye", projection.eye());
  shader.set("focus", focus_.center);
  shader.set("focus_radius", focus_.radius);
  shader.set("texel_metres", Real(2.6) * focus_.radius / static_cast<Real>(look_->shadows.side()));
  shader.set("canvas_height", static_cast<float>(canvas.height));
}

void SolidRenderer::draw_opaque(const Projection& projection, Size canvas) const {
  use(projection, canvas);
  for (const Batch& batch : opaque_) batch.mesh->draw(instances_, batch.first, batch.count);
  glDisable(GL_CULL_FACE);
}

void SolidRenderer::draw_translucent(const Projection& projection, Size canvas) const {
  if (translucent_.empty()) return;
  std::vector<const Batch*> order;
  for (const Batch& batch : translucent_) order.push_back(&batch);
  const auto depth = [&](const Batch* batch) {
    return (batch->position - projection.eye()).dot(projection.forward());
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](const Batch* a, const Batch* b) { return depth(a) > depth(b); });
  use(projection, canvas);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glDepthMask(GL_FALSE);
  for (const Batch* batch : order) batch->mesh->draw(instances_, batch->first, batch->count);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
}

}  // namespace cs550::viewer
