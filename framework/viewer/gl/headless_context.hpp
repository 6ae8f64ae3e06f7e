#pragma once
/// @file headless_context.hpp
/// OpenGL without a visible window.

#include <cstdint>
#include <memory>

namespace cs550::viewer {

/// Keeps an OpenGL context current as long as it exists.
class GlContext {
 public:
  GlContext() = default;
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;
  virtual ~GlContext() = default;
};

/// How the context is created.
enum class HeadlessWay : std::uint8_t {
  Any,           ///< EGL, or a hidden window if EGL fails
  Egl,           ///< surfaceless: needs no screen
  HiddenWindow,  ///< needs a screen
};

/// An OpenGL 3.3 context for drawing pictures. At most one at a time.
class HeadlessContext {
 public:
  /// @throws std::runtime_error with what is missing and which packages to install
  explicit HeadlessContext(HeadlessWay way = HeadlessWay::Any);

 private:
  std::unique_ptr<GlContext> context_;
};

/// The two implementations. @throws std::runtime_error with what is missing
/// @{
std::unique_ptr<GlContext> open_egl();
std::unique_ptr<GlContext> open_hidden_window();
/// @}

}  // namespace cs550::viewer
