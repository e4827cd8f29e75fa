// What may be changed about a mesh when it is read, and only when asked for: coincident vertices become one (--weld),
// and triangles are turned until neighbours agree (--orient). Strips cross an edge only where its two triangles share
// both vertices and agree in orientation.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "meshes/rounding.hpp"
#include "meshes/soup.hpp"

namespace restrip::tools {

struct MendingOptions {
  bool weld = false;
  bool orient = false;
};

/// What was changed.
struct Mended {
  MendingOptions asked;
  [[nodiscard]] bool any_asked() const noexcept { return asked.weld || asked.orient; }
  std::size_t welded_vertices = 0;     ///< became one with an earlier vertex
  std::size_t vanished_triangles = 0;  ///< had two corners that became one
  std::size_t turned_triangles = 0;
  /// What the file has and is not carried on (Soup::left_out_attributes).
  std::vector<std::string> left_out_attributes = {};
  Rounding rounding = {};  ///< by the format that is written
};

/// What is asked for is done. Throws BadInput where that leaves no triangle, and as orient() does. `name` is the file.
[[nodiscard]] Mended mend(Soup& soup, const std::string& name, const MendingOptions& options);

/// Throws BadInput when anything is asked for: a progressive mesh is taken as it is.
void refuse_mending(const std::string& file, const MendingOptions& options);

/// Vertices at exactly the same place become one, the first of them, if they agree in all attributes too; triangles of
/// which then two corners are the same vanish. The strips of the file stay. Linear time.
void weld(Soup& soup, Mended& mended);
/// Turns triangles until any two that alone share an edge agree, as few as possible: in each part of the mesh that is
/// connected by such edges, the smaller number. Strips of the file that were turned as a whole stay; another one
/// becomes one strip for each triangle. Throws BadInput, and leaves the soup as it is, where a part has no orientation
/// (a Moebius strip). `name` is the file. O(n log n).
void orient(Soup& soup, const std::string& name, Mended& mended);

/// How many vertices of some triangle lie where an earlier one does: those that weld() joins.
[[nodiscard]] std::size_t coincident_vertices(const Soup& soup);

/// How many of them weld() leaves, because they differ in attributes from each earlier one at their place.
[[nodiscard]] std::size_t vertices_at_seams(const Soup& soup);

/// One sentence for each thing done or left out, each with a line feed; empty when none exists.
[[nodiscard]] std::string as_text(const Mended& mended);
[[nodiscard]] nlohmann::ordered_json json_of(const Mended& mended);
/// Adds `mended`, when it was asked for, `left_out_attributes`, when there are some, and `rounded`, when that matters,
/// to a report.
void add_to(nlohmann::ordered_json& report, const Mended& mended);
/// Sentences that say that mending would help, each with a line feed.
[[nodiscard]] std::string hints(std::size_t coincident_vertices, std::size_t vertices_at_seams,
                                std::size_t inconsistent_edges);

}  // namespace restrip::tools
