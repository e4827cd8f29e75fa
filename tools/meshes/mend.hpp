// Mends a mesh on request when it is read: --weld merges coincident vertices, and --orient turns triangles until
// neighbours agree. Strips cross an edge only if its two triangles share both vertices and agree in orientation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "meshes/soup.hpp"

namespace restrip::tools {

struct MendingOptions {
  bool weld = false;
  bool orient = false;
};

/// What was changed.
struct Mended {
  MendingOptions asked;
  std::size_t welded_vertices = 0;     ///< merged into an earlier vertex
  std::size_t vanished_triangles = 0;  ///< had two corners that were merged
  std::size_t turned_triangles = 0;
  std::size_t closed_seams = 0;  ///< vertices merged by close_seams()
  /// Soup::left_out, and attributes that the output does not hold.
  std::vector<std::string> left_out = {};
  Rounding rounding = {};  ///< by the output format
};

/// Mends as requested. Throws BadInput if no triangle remains, and as orient() does. `name` is the file.
[[nodiscard]] Mended mend(Soup& soup, const std::string& name, const MendingOptions& options);

/// Throws BadInput if anything is requested: a progressive mesh is read unchanged.
void refuse_mending(const std::string& file, const MendingOptions& options);

/// Merges each vertex into the one that `first` names: itself, or an earlier one that names itself. Triangles that then
/// have two equal corners are removed and counted. The strips of the file are kept. Returns the number of vertices that
/// were merged into others. Linear time.
std::size_t merge_vertices(Soup& soup, std::vector<std::uint32_t> first, Mended& mended);
/// Merges vertices at exactly the same position into the first of them if they also agree in all attributes.
void weld(Soup& soup, Mended& mended);
/// Turns as few triangles as possible so that any two triangles that share a manifold edge agree: in each part
/// connected by such edges, the smaller group. A strip of the file is kept if it is turned as a whole; otherwise each
/// of its triangles becomes a strip. If a part cannot be oriented (a Moebius strip), throws BadInput and leaves the
/// soup unchanged. `name` is the file. O(n log n).
void orient(Soup& soup, const std::string& name, Mended& mended);

/// The number of used vertices that lie at the position of an earlier one and that weld() merges.
[[nodiscard]] std::size_t coincident_vertices(const Soup& soup);

/// The number of such vertices that weld() leaves, because they differ in attributes from each earlier one there.
[[nodiscard]] std::size_t vertices_at_seams(const Soup& soup);

/// One line for each thing done or left out; empty if nothing was.
[[nodiscard]] std::string as_text(const Mended& mended);
/// Adds `mended`, if mending was requested, `closed_seams` and `left_out_content`, if there are any, and `rounded`, if
/// it matters, to a report.
void add_to(nlohmann::ordered_json& report, const Mended& mended);

// Seams: edges at which a format repeats vertices, because normals or texture coordinates differ on their two sides.
// By index they are borders, but there is surface on both sides.

/// For each vertex, the first of the vertices that are one with it across seams: the border of a triangle that lies on
/// another edge, both ends at the same places, is a seam. Places are the same if their distance is at most a millionth
/// of the mesh's size and a thousandth of the shortest border there, since programs compute the two sides of a seam
/// separately. Two borders of triangles back to back, as a sheet with two sides has, are not a seam. O(n log n).
[[nodiscard]] std::vector<std::uint32_t> first_across_seams(const Soup& soup);

/// The vertices that are several at one place, in ascending order.
[[nodiscard]] std::vector<std::uint32_t> vertices_on_seams(const Soup& soup);

/// Merges the vertices of each seam into the first of them. Triangles that then have two equal corners are removed.
void close_seams(Soup& soup, Mended& mended);

}  // namespace restrip::tools
