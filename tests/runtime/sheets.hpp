// Lists of triangles with edges of more than two triangles: two-sided sheets, books, boxes that share an edge.
#pragma once

#include <vector>

#include "sample_meshes.hpp"

namespace restrip::sample {

using Triangles = std::vector<Corners>;

/// `columns` times `rows` squares on vertices that `at` numbers.
template <class At>
Triangles sheet(Vertex columns, Vertex rows, At&& at) {
  Triangles made;
  for (Vertex x = 0; x < columns; ++x)
    for (Vertex y = 0; y < rows; ++y) {
      made.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      made.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  return made;
}
/// The list, and every triangle again with the opposite winding.
inline Triangles with_backs(Triangles list) {
  for (std::size_t t = 0, size = list.size(); t < size; ++t) list.push_back({list[t][1], list[t][0], list[t][2]});
  return list;
}
/// Sheets that share the column 0; with three pages, three sheets on one edge.
inline Triangles book(Vertex pages) {
  Triangles all;
  for (Vertex p = 0; p < pages; ++p) {
    const Triangles page = sheet(9, 12, [p](Vertex x, Vertex y) { return x == 0 ? y : 13 * (9 * p + x) + y; });
    all.insert(all.end(), page.begin(), page.end());
  }
  return all;
}
/// A band with half a turn: its ends are joined with opposite windings.
inline Triangles band(Vertex length) {
  Triangles made;
  for (Vertex x = 0; x < length; ++x) {
    const bool turned = x + 1 == length;
    const Vertex a = 2 * x;
    const Vertex b = turned ? 1 : 2 * x + 2;
    const Vertex c = turned ? 0 : 2 * x + 3;
    made.insert(made.end(), {{a, b, a + 1}, {a + 1, b, c}});
  }
  return made;
}
/// Boxes of 4 x 4 squares a side that all have one edge in common.
inline Triangles boxes(Vertex count) {
  constexpr Vertex n = 4;
  Triangles all;
  for (Vertex box = 0; box < count; ++box) {
    const auto at = [box](Vertex x, Vertex y, Vertex z) {
      return (x == 0 && y == 0 ? 0 : 125 * box) + x + 5 * y + 25 * z;
    };
    for (const Triangles& side : {sheet(n, n, [&](Vertex x, Vertex y) { return at(y, x, 0); }),
                                  sheet(n, n, [&](Vertex x, Vertex y) { return at(x, y, n); }),
                                  sheet(n, n, [&](Vertex x, Vertex y) { return at(x, 0, y); }),
                                  sheet(n, n, [&](Vertex x, Vertex y) { return at(y, n, x); }),
                                  sheet(n, n, [&](Vertex x, Vertex y) { return at(0, y, x); }),
                                  sheet(n, n, [&](Vertex x, Vertex y) { return at(n, x, y); })})
      all.insert(all.end(), side.begin(), side.end());
  }
  return all;
}

}  // namespace restrip::sample
