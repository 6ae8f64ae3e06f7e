#include "viewer/picture.hpp"

#include <stb/stb_image_write.h>

#include <algorithm>
#include <string>

#include "files/output_file.hpp"

namespace cs550::viewer {

namespace {

constexpr int channels = 3;

/// OpenGL stores the bottom row first, a PNG file the top row.
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
  picture.pixels.resize(std::size_t{channels} * canvas.size().width * canvas.size().height);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, canvas.result());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, canvas.size().width, canvas.size().height, GL_RGB, GL_UNSIGNED_BYTE,
               picture.pixels.data());
  flip(picture);
  return picture;
}

void write_png(const Picture& picture, const std::filesystem::path& file) {
  std::string bytes;
  const auto add = [](void* all, void* part, int count) {
    static_cast<std::string*>(all)->append(static_cast<const char*>(part),
                                           static_cast<std::size_t>(count));
  };
  stbi_write_png_to_func(add, &bytes, picture.size.width, picture.size.height, channels,
                         picture.pixels.data(), channels * picture.size.width);
  files::write_file(file, bytes);
}

}  // namespace cs550::viewer
