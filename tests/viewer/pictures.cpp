#include "pictures.hpp"

#include <stb/stb_image.h>

#include <cmath>
#include <set>
#include <stdexcept>

namespace cs550::test {
namespace {

constexpr int channels = 3;

std::size_t pixel_count(const Picture& picture) { return picture.pixels.size() / channels; }

int channel(const Picture& picture, std::size_t pixel, std::size_t which) {
  return picture.pixels[channels * pixel + which];
}

}  // namespace

Picture read_png(const std::filesystem::path& file) {
  Picture picture;
  int stored_channels = 0;
  unsigned char* pixels = stbi_load(file.c_str(), &picture.size.width, &picture.size.height,
                                    &stored_channels, channels);
  if (pixels == nullptr) throw std::runtime_error(file.string() + " is not a picture");
  const auto count = std::size_t{channels} * picture.size.width * picture.size.height;
  picture.pixels.assign(pixels, pixels + count);
  stbi_image_free(pixels);
  return picture;
}

Picture halved(const Picture& picture) {
  Picture half{{picture.size.width / 2, picture.size.height / 2}, {}};
  const int row = channels * picture.size.width;
  for (int y = 0; y < half.size.height; ++y) {
    for (int x = 0; x < half.size.width * channels; ++x) {
      const int left = 2 * y * row + (x / channels) * 2 * channels + x % channels;
      int sum = 0;
      for (const int corner : {left, left + channels, left + row, left + row + channels}) {
        sum += picture.pixels[corner];
      }
      half.pixels.push_back(static_cast<std::uint8_t>(sum / 4));
    }
  }
  return half;
}

double share_that_differs(const Picture& a, const Picture& b) {
  constexpr double most = 0.02 * 255;
  if (!(a.size == b.size)) return 1;
  std::size_t different = 0;
  for (std::size_t pixel = 0; pixel < pixel_count(a); ++pixel) {
    bool differs = false;
    for (std::size_t which = 0; which < channels; ++which) {
      differs = differs || std::abs(channel(a, pixel, which) - channel(b, pixel, which)) > most;
    }
    if (differs) ++different;
  }
  return static_cast<double>(different) / static_cast<double>(pixel_count(a));
}

double share_of_colour(const Picture& picture, const std::array<int, 3>& colour) {
  constexpr int near = 31;
  std::size_t matching = 0;
  for (std::size_t pixel = 0; pixel < pixel_count(picture); ++pixel) {
    bool matches = true;
    for (std::size_t which = 0; which < channels; ++which) {
      matches = matches && std::abs(channel(picture, pixel, which) - colour[which]) <= near;
    }
    if (matches) ++matching;
  }
  return static_cast<double>(matching) / static_cast<double>(pixel_count(picture));
}

int colour_count(const Picture& picture) {
  std::set<int> colours;
  for (std::size_t pixel = 0; pixel < pixel_count(picture); ++pixel) {
    colours.insert(channel(picture, pixel, 0) / 16 * 256 + channel(picture, pixel, 1) / 16 * 16 +
                   channel(picture, pixel, 2) / 16);
  }
  return static_cast<int>(colours.size());
}

}  // namespace cs550::test
