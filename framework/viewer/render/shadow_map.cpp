#include "viewer/render/shadow_map.hpp"

namespace cs550::viewer {

ShadowMap::ShadowMap(int side) : side_(side) {
  glBindTexture(GL_TEXTURE_2D, depth_.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, side, side, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
               nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  // Nothing outside of the map casts a shadow.
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  constexpr float far[] = {1, 1, 1, 1};
  glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, far);
  glBindFramebuffer(GL_FRAMEBUFFER, frame_.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.name(), 0);
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
}

Matrix4 ShadowMap::begin(const Vec3& light, const Vec3& center, Real radius) const {
  glBindFramebuffer(GL_FRAMEBUFFER, frame_.name());
  glViewport(0, 0, side_, side_);
  glClear(GL_DEPTH_BUFFER_BIT);
  const Vec3 across = any_perpendicular(light);
  Matrix4 matrix = Matrix4::Identity();
  matrix.block<1, 3>(0, 0) = across.transpose() / radius;
  matrix.block<1, 3>(1, 0) = light.cross(across).transpose() / radius;
  // Twice as deep, so that the ground beyond the ball is inside the map.
  matrix.block<1, 3>(2, 0) = -light.transpose() / (2 * radius);
  matrix.block<3, 1>(0, 3) = -matrix.block<3, 3>(0, 0) * center;
  return matrix;
}

void ShadowMap::bind(int unit) const {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, depth_.name());
}

}  // namespace cs550::viewer
