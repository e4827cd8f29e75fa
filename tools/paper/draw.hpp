// Vector drawings: a mesh whose triangles are coloured by strip, and a rule as the fan before and after a split.
#pragma once

#include <string>
#include <vector>

#include "meshes/soup.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/rules/rules.hpp"

namespace restrip::tools {

// Each is a square drawing in its own coordinates (patch_drawing.hpp), without the <svg> around it.

/// The mesh seen from above and in front, far triangles first, each strip in a colour of its own.
[[nodiscard]] std::string draw_mesh(const StripMesh& mesh, const std::vector<Point>& points);

/// The closed fan before a split, as triangles around a vertex with their dual edges on top.
[[nodiscard]] std::string draw_fan(SplitPosition at, Word loop, Word ports);

/// What the rule makes of it: the two ends of the new edge, the triangles A and D between the arcs, and the dual edges.
[[nodiscard]] std::string draw_split(SplitPosition at, Word loop, Word ports);

/// Drawings side by side with captions: a whole SVG file that can be read on light and dark pages.
struct Panel {
  std::string drawing;
  std::string caption;
};
[[nodiscard]] std::string svg_of(const std::vector<Panel>& panels);

}  // namespace restrip::tools
