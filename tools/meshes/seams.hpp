// Seams: edges at which a format repeats vertices, because normals or texture coordinates differ on their two sides.
// By index they are borders, but there is surface on both sides.
#pragma once

#include <cstdint>
#include <vector>

#include "meshes/mend.hpp"
#include "meshes/soup.hpp"

namespace restrip::tools {

/// For each vertex, the first of the vertices that are one with it across seams: the border of a triangle that lies on
/// another edge, both ends at the same places, is a seam. Places are the same if their distance is at most a millionth
/// of the mesh's size and a thousandth of the shortest border there, since programs compute the two sides of a seam
/// separately. Two borders of triangles back to back, as those of a sheet with two sides, are not a seam. O(n log n).
[[nodiscard]] std::vector<std::uint32_t> first_across_seams(const Soup& soup);

/// The vertices that are several at one place, in ascending order.
[[nodiscard]] std::vector<std::uint32_t> vertices_on_seams(const Soup& soup);

/// Merges the vertices of each seam into the first of them. Triangles that then have two equal corners are removed.
void close_seams(Soup& soup, Mended& mended);

}  // namespace restrip::tools
