#include "viewer/picture.hpp"

#include <stb/stb_image_write.h>

#include <algorithm>
#include <stdexcept>

namespace cs550::viewer {

namespace fs = std::filesystem;

namespace {

constexpr int channels = 3;

/// OpenGL's rows go upwards, a file's downwards.
void flip(Picture& picture) {
  const auto row = static_cast<std::ptrdiff_t>(channels) * picture.size.width;
  for (int top = 0, bottom = picture.size.height - 1; top < bottom; ++top, --bottom) {
    const auto upper = picture.pixels.begin() + top * row;
    std::swap_ranges(upper, upper + row, picture.pixels.begin() + bottom * row);
  }
}

}  // namespace

Picture read_picture(const Canvas& canvas) {
  Picture picture{canvas.size(), {}};
  picture.pixels.resize(static_cast<std::size_t>(channels) *
                        static_cast<std::size_t>(canvas.size().width) *
                        static_cast<std::size_t>(canvas.size().height));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, canvas.result());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, canvas.size().width, canvas.size().height, GL_RGB, GL_UNSIGNED_BYTE,
               picture.pixels.data());
  flip(picture);
  return picture;
}

void write_png(const Picture& picture, const fs::path& file) {
  std::error_code ignored;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), ignored);
  const fs::path draft = file.string() + ".draft";
  const int written =
      stbi_write_png(draft.c_str(), picture.size.width, picture.size.height, channels,
                     picture.pixels.data(), channels * picture.size.width);
  std::error_code failure;
  if (written != 0) fs::rename(draft, file, failure);
  if (written == 0 || failure) {
    fs::remove(draft, ignored);
    throw std::runtime_error("cannot write " + file.string() +
                             ": is its folder there and writable?");
  }
}

}  // namespace cs550::viewer
