#pragma once
/// @file ink_shaders.hpp
/// GLSL of the InkRenderer. Every instance is a rectangle, and its fragment shader computes the
/// coverage of the shape, so that edges are smooth even with one sample per pixel.

namespace cs550::viewer::ink_shaders {

/// A line as a rectangle of constant width in pixels, clipped at the near plane. It is moved
/// slightly towards the eye, so that an edge is drawn in front of its own face.
inline constexpr const char* line_vertex = R"(
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 tint;
layout(location = 3) in vec4 style;  // width in pixels, dashed, arrow, rim in pixels

uniform mat4 camera;
uniform vec3 eye;
uniform vec3 forward;
uniform float nearest;
uniform vec2 canvas;

out vec2 along;  // pixels from the start and to the end
out float across;
flat out vec4 paint;
flat out vec4 shape;

vec3 lifted(vec3 point) { return eye + 0.996 * (point - eye); }

vec3 cut(vec3 point, vec3 other) {
  float depth = dot(point - eye, forward);
  float other_depth = dot(other - eye, forward);
  if (depth >= nearest || other_depth <= depth) return point;
  return mix(point, other, clamp((nearest - depth) / (other_depth - depth), 0.0, 1.0));
}

void main() {
  vec4 start = camera * vec4(lifted(cut(from, to)), 1.0);
  vec4 end = camera * vec4(lifted(cut(to, from)), 1.0);
  vec2 start_pixel = start.xy / start.w * canvas * 0.5;
  vec2 end_pixel = end.xy / end.w * canvas * 0.5;
  float span = length(end_pixel - start_pixel);
  vec2 direction = span > 1e-4 ? (end_pixel - start_pixel) / span : vec2(1.0, 0.0);
  vec2 side = vec2(-direction.y, direction.x);

  float reach = (style.z > 0.5 ? 1.5 * style.x + 3.0 : 0.5 * style.x) + 1.5 * style.w + 1.0;
  float cap = 0.5 * style.x + 2.5 * style.w;
  bool at_end = gl_VertexID >= 2;
  float lateral = (gl_VertexID % 2 == 0) ? -reach : reach;
  vec2 pixel = (at_end ? end_pixel + direction * cap : start_pixel - direction * cap) + side * lateral;
  vec4 corner = at_end ? end : start;
  gl_Position = vec4(pixel / (canvas * 0.5) * corner.w, corner.zw);
  if (start.w <= 0.0 || end.w <= 0.0) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  along = at_end ? vec2(span + cap, -cap) : vec2(-cap, span + cap);
  across = lateral;
  paint = tint;
  shape = style;
}
)";

inline constexpr const char* line_fragment = R"(
uniform float opacity;
in vec2 along;
in float across;
flat in vec4 paint;
flat in vec4 shape;
out vec4 colour;

float inside(float distance) { return 1.0 - smoothstep(-0.6, 0.6, distance); }

void main() {
  float half_width = 0.5 * shape.x + shape.w;
  float head = shape.z > 0.5 ? min(3.2 * shape.x + 5.0, along.x + along.y) : 0.0;
  // Round ends: the distance from the segment, which ends inside the arrowhead.
  float beyond = max(max(-along.x, head * 0.8 - along.y), 0.0);
  float cover = inside(length(vec2(beyond, across)) - half_width);
  if (shape.y > 0.5) cover *= inside(abs(mod(along.x, 11.0) - 3.5) - 3.5);
  if (head > 0.0) {
    float side = (abs(across) - 0.44 * along.y) * 0.915;  // distance from the slanted side
    cover = max(cover, inside(max(side, along.y - head) - shape.w));
  }
  if (cover <= 0.01) discard;
  colour = vec4(paint.rgb, paint.a * cover * opacity);
}
)";

inline constexpr const char* dot_vertex = R"(
layout(location = 0) in vec3 center;
layout(location = 1) in vec4 tint;
layout(location = 2) in float radius;

uniform mat4 camera;
uniform vec3 eye;
uniform vec2 canvas;

out vec2 place;
flat out vec4 paint;
flat out float size;

void main() {
  vec4 middle = camera * vec4(eye + 0.994 * (center - eye), 1.0);
  place = vec2(gl_VertexID % 2 == 0 ? -1.0 : 1.0, gl_VertexID < 2 ? -1.0 : 1.0) * (radius + 1.0);
  gl_Position = middle + vec4(place / (canvas * 0.5) * middle.w, 0.0, 0.0);
  paint = tint;
  size = radius;
}
)";

/// A disc with a thin light rim that separates it from the background.
inline constexpr const char* dot_fragment = R"(
uniform float opacity;
in vec2 place;
flat in vec4 paint;
flat in float size;
out vec4 colour;
void main() {
  float from_center = length(place);
  float cover = 1.0 - smoothstep(size - 0.6, size + 0.6, from_center);
  float rim = smoothstep(size - 1.9, size - 0.9, from_center);
  if (cover <= 0.01) discard;
  colour = vec4(mix(paint.rgb, vec3(1.0), rim * 0.85), paint.a * cover * opacity);
}
)";

inline constexpr const char* polygon_vertex = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 tint;
uniform mat4 camera;
uniform vec3 eye;
out vec3 world;
flat out vec4 paint;
void main() {
  world = eye + 0.998 * (position - eye);
  gl_Position = camera * vec4(world, 1.0);
  paint = tint;
}
)";

/// Slight directional shading, so that neighbouring faces can be distinguished.
inline constexpr const char* polygon_fragment = R"(
uniform vec3 eye;
in vec3 world;
flat in vec4 paint;
out vec4 colour;
void main() {
  vec3 normal = normalize(cross(dFdx(world), dFdy(world)));
  if (dot(normal, eye - world) < 0.0) normal = -normal;
  float light = 0.88 + 0.14 * dot(normal, normalize(vec3(-0.3, -0.7, 1.15)));
  colour = vec4(paint.rgb * light, paint.a);
}
)";

/// A square that faces the eye and encloses the outline of the ball.
inline constexpr const char* ball_vertex = R"(
layout(location = 0) in vec4 ball;  // center, radius
layout(location = 1) in vec4 tint;

uniform mat4 camera;
uniform vec3 eye;

out vec3 world;
flat out vec4 sphere;
flat out vec4 paint;

void main() {
  vec3 away = normalize(ball.xyz - eye);
  vec3 side = normalize(cross(away, vec3(0.0, 0.0, 1.0)));
  vec3 over = cross(side, away);
  vec2 corner = vec2(gl_VertexID % 2 == 0 ? -1.0 : 1.0, gl_VertexID < 2 ? -1.0 : 1.0);
  float far = length(ball.xyz - eye);
  float reach = ball.w * far / sqrt(max(far * far - ball.w * ball.w, 1e-6)) * 1.02;
  world = ball.xyz + reach * (corner.x * side + corner.y * over);
  sphere = ball;
  paint = tint;
  gl_Position = camera * vec4(world, 1.0);
}
)";

inline constexpr const char* ball_fragment = R"(
uniform mat4 camera;
uniform vec3 eye;
in vec3 world;
flat in vec4 sphere;
flat in vec4 paint;
out vec4 colour;
void main() {
  vec3 ray = normalize(world - eye);
  vec3 offset = eye - sphere.xyz;
  float b = dot(offset, ray);
  float discriminant = b * b - dot(offset, offset) + sphere.w * sphere.w;
  float edge = fwidth(discriminant);
  if (discriminant < -edge) discard;
  vec3 hit = eye + ray * (-b - sqrt(max(discriminant, 0.0)));
  vec3 normal = (hit - sphere.xyz) / sphere.w;
  float light = 0.84 + 0.16 * dot(normal, normalize(vec3(-0.3, -0.7, 1.15)));
  float rim = 1.0 - abs(dot(normal, ray));
  float cover = smoothstep(-edge, edge, discriminant);
  colour = vec4(paint.rgb * light, min(1.0, paint.a * (0.75 + 0.6 * rim * rim)) * cover);
  vec4 clip = camera * vec4(hit, 1.0);
  gl_FragDepth = 0.5 + 0.5 * clip.z / clip.w;
}
)";

}  // namespace cs550::viewer::ink_shaders
