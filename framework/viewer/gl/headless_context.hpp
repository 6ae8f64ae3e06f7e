#pragma once
/// @file headless_context.hpp
/// OpenGL without a window that anybody sees.

#include <cstdint>
#include <memory>

namespace cs550::viewer {

/// Something that keeps OpenGL current until it goes away.
class GlContext {
 public:
  GlContext() = default;
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;
  virtual ~GlContext() = default;
};

/// How OpenGL is reached.
enum class HeadlessWay : std::uint8_t {
  Any,           ///< EGL; where it fails a hidden window
  Egl,           ///< without a screen (surfaceless)
  HiddenWindow,  ///< on a screen, but not shown
};

/// An OpenGL 3.3 context for pictures. At most one at a time.
class HeadlessContext {
 public:
  /// @throws std::runtime_error that says what is missing and names the packages to install
  explicit HeadlessContext(HeadlessWay way = HeadlessWay::Any);

 private:
  std::unique_ptr<GlContext> context_;
};

/// The two ways. @throws std::runtime_error that says what is missing
/// @{
std::unique_ptr<GlContext> open_egl();
std::unique_ptr<GlContext> open_hidden_window();
/// @}

}  // namespace cs550::viewer
