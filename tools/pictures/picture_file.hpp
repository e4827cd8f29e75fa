// Strips as a picture: SVG or PNG.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pictures/scene.hpp"

namespace restrip::tools {

struct Picture {
  std::string bytes;
  std::size_t strips = 0;  ///< whose colour is somewhere in the picture
};

/// One polygon for each face, far ones first, so that near ones cover them: right but where triangles of very different
/// size overlap. Lines are drawn with their triangles.
[[nodiscard]] Picture svg_of(const Scene& scene);

/// By a depth buffer, which decides for each pixel; 15 bytes a pixel while it draws. Without antialiasing: every pixel
/// has the colour of the background, of an edge, of the surface, or of a strip. Throws std::runtime_error where libpng
/// fails.
[[nodiscard]] Picture png_of(const Scene& scene);

/// The extensions of both.
[[nodiscard]] std::vector<std::string> picture_extensions();
/// The picture in the format of the extension, in lower case. Throws BadInput when it is neither.
[[nodiscard]] Picture picture_of(const Scene& scene, const std::string& extension);

}  // namespace restrip::tools
