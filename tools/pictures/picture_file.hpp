// Draws strips as SVG or PNG.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pictures/scene.hpp"

namespace restrip::tools {

struct Picture {
  std::string bytes;
  std::size_t strips = 0;  ///< number of strips visible by colour
};

/// One polygon per face, far ones first, so that near ones cover them. Correct unless triangles of very different size
/// overlap. Lines are drawn with their triangles.
[[nodiscard]] Picture svg_of(const Scene& scene);

/// Uses a depth buffer; 15 bytes a pixel. Without antialiasing: every pixel has the colour of the background, of an
/// edge, of the surface, or of a strip. Throws std::runtime_error if libpng fails.
[[nodiscard]] Picture png_of(const Scene& scene);

/// The supported extensions.
[[nodiscard]] std::vector<std::string> picture_extensions();
/// The picture in the format of the extension (in lower case). Throws BadInput for other extensions.
[[nodiscard]] Picture picture_of(const Scene& scene, const std::string& extension);

}  // namespace restrip::tools
