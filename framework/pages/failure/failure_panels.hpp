#pragma once
/// @file failure_panels.hpp
/// The drawings in the picture of a failing test. They are stored inside its SVG file, so that the
/// viewer can show the failing case from all sides.

#include <cereal/external/base64.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "pages/base/content_archive.hpp"
#include "serialisation/bytes.hpp"

namespace cs550::pages {

/// One drawing of the picture.
struct FailurePanel {
  Content content;                 ///< the drawing, and the plots of the picture
  Vec3 toward_eye = Vec3::Ones();  ///< the direction from which the picture shows it
};

template <class Archive>
void serialize(Archive& archive, FailurePanel& panel) {
  auto& [content, toward_eye] = panel;
  archive(content, toward_eye);
}

inline constexpr std::string_view panels_begin = "<metadata id=\"cs550-panels\">";
inline constexpr std::string_view panels_end = "</metadata>";

/// An SVG file with panels inside.
inline std::string with_panels(std::string svg, const std::vector<FailurePanel>& panels) {
  const std::string bytes = serialisation::to_bytes(panels);
  std::string element(panels_begin);
  element +=
      cereal::base64::encode(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  element += panels_end;
  element += '\n';
  return svg.insert(svg.rfind("</svg>"), element);
}

/// The panels inside an SVG file; none if it has none.
/// @throws cereal::Exception if they are damaged
inline std::vector<FailurePanel> panels_in(const std::string& svg) {
  const std::size_t begin = svg.find(panels_begin);
  const std::size_t end = svg.find(panels_end, begin);
  if (begin == std::string::npos || end == std::string::npos) return {};
  const std::size_t first = begin + panels_begin.size();
  return serialisation::from_bytes<std::vector<FailurePanel>>(
      cereal::base64::decode(svg.substr(first, end - first)));
}

}  // namespace cs550::pages
