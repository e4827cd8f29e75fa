#include "pictures/picture_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "common/bad_input.hpp"

namespace restrip::tools {

std::vector<std::string> picture_extensions() { return {".svg", ".png"}; }

Picture picture_of(const Scene& scene, const std::string& extension) {
  if (extension == ".svg") return svg_of(scene);
  if (extension == ".png") return png_of(scene);
  throw BadInput(fmt::format("unknown extension '{}'; pictures are written as {}", extension,
                             fmt::join(picture_extensions(), ", ")));
}

}  // namespace restrip::tools
