// Coloured patches as an SVG picture: triangles as nodes in the ring of their ports, and what is connected outside.
#pragma once

#include <string>
#include <vector>

#include "definition/definition.hpp"

namespace restrip::verify {

struct Panel {
  std::string title;
  const Side* side = nullptr;
  Colors colors;
  World world;        ///< drawn around the patch
  Colors marked;      ///< edges and ports in red
  bool only = false;  ///< other edges and ports may be solid or dashed: they are thin lines
};

/// Panels side by side, four in a row.
std::string picture_of(const std::vector<Panel>& panels);

}  // namespace restrip::verify
