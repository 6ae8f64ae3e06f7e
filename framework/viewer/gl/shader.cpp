#include "viewer/gl/shader.hpp"

#include <stdexcept>
#include <string>

namespace cs550::viewer {
namespace {

constexpr int log_size = 4096;

[[noreturn]] void refuse(const char* name, const std::string& message) {
  throw std::runtime_error(std::string("the shader '") + name +
                           "' does not compile with this OpenGL driver: " + message);
}

GLuint compile(const char* name, GLenum kind, const char* source) {
  const char* lines[] = {"#version 330 core\n", source};
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 2, lines, nullptr);
  glCompileShader(shader);
  GLint good = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good == 0) {
    std::string log(log_size, '\0');
    glGetShaderInfoLog(shader, log_size, nullptr, log.data());
    refuse(name, log.c_str());
  }
  return shader;
}

}  // namespace

Shader::Shader(const char* name, const char* vertex, const char* fragment)
    : program_(glCreateProgram()) {
  const GLuint parts[] = {compile(name, GL_VERTEX_SHADER, vertex),
                          compile(name, GL_FRAGMENT_SHADER, fragment)};
  for (const GLuint part : parts) glAttachShader(program_, part);
  glLinkProgram(program_);
  for (const GLuint part : parts) glDeleteShader(part);
  GLint good = 0;
  glGetProgramiv(program_, GL_LINK_STATUS, &good);
  if (good == 0) {
    std::string log(log_size, '\0');
    glGetProgramInfoLog(program_, log_size, nullptr, log.data());
    refuse(name, log.c_str());
  }
}

Shader::~Shader() { glDeleteProgram(program_); }

void Shader::use() const { glUseProgram(program_); }

void Shader::set(const char* name, const Matrix4& value) const {
  glUniformMatrix4fv(glGetUniformLocation(program_, name), 1, GL_FALSE, value.data());
}
void Shader::set(const char* name, const Vec3& value) const {
  glUniform3fv(glGetUniformLocation(program_, name), 1, value.data());
}
void Shader::set(const char* name, const Vec2& value) const {
  glUniform2fv(glGetUniformLocation(program_, name), 1, value.data());
}
void Shader::set(const char* name, const Rgba& value) const {
  glUniform4fv(glGetUniformLocation(program_, name), 1, value.data());
}
void Shader::set(const char* name, float value) const {
  glUniform1f(glGetUniformLocation(program_, name), value);
}
void Shader::set(const char* name, int value) const {
  glUniform1i(glGetUniformLocation(program_, name), value);
}

}  // namespace cs550::viewer
