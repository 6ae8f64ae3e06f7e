#include "viewer/render/backdrop.hpp"

#include <string>

namespace cs550::viewer {

const char* const backdrop_source = R"(
vec3 backdrop(float height) {
  return mix(vec3(0.80, 0.83, 0.87), vec3(0.93, 0.945, 0.96), smoothstep(0.0, 0.9, height));
}
)";

namespace {

/// A triangle that covers the viewport.
constexpr const char* backdrop_vertex_source = R"(
void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 1.0, 1.0);
}
)";

constexpr const char* backdrop_fragment_source = R"(
uniform float canvas_height;
out vec4 colour;
void main() {
  colour = vec4(pow(backdrop(gl_FragCoord.y / canvas_height), vec3(1.0 / 2.2)), 1.0);
}
)";

}  // namespace

Backdrop::Backdrop()
    : shader_("backdrop", backdrop_vertex_source,
              (std::string(backdrop_source) + backdrop_fragment_source).c_str()) {}

void Backdrop::draw(float height_pixels) const {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  shader_.use();
  shader_.set("canvas_height", height_pixels);
  glBindVertexArray(empty_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDepthFunc(GL_LESS);
}

}  // namespace cs550::viewer
