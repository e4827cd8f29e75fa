// The patch of a vertex split as a drawing: triangles, and their dual edges on top. Places and strokes only; whoever
// draws them chooses the ink.
#pragma once

#include <vector>

#include "restrip/rules/rules.hpp"

namespace restrip::tools {

/// A square drawing in its own coordinates, 0 … size both ways, y downwards.
inline constexpr double drawing_size = 400;

struct Place {
  double x = 0;
  double y = 0;
};

struct PatchDrawing {
  struct Face {
    Place a;
    Place b;
    Place c;
    bool is_new = false;  ///< A or D
  };
  /// Half a dual edge: from a triangle's middle to the mesh edge that it crosses, or a port.
  struct Stroke {
    Place from;
    Place to;
    bool solid = false;
  };
  std::vector<Face> faces;
  std::vector<Stroke> strokes;
  std::vector<Place> nodes;  ///< the middles of the faces
};

/// The closed fan before a split, as triangles around a vertex.
[[nodiscard]] PatchDrawing fan_drawing(SplitPosition at, Word loop, Word ports);

/// The ring with chord after it, coloured `inner`: the two ends of the new edge, the triangles A and D between the
/// arcs.
[[nodiscard]] PatchDrawing split_drawing(SplitPosition at, Word inner, Word ports);

}  // namespace restrip::tools
