// ReplayReport as text and as JSON.
//
// The JSON object:
//  - mesh: the file, or what was made
//  - triangles: at the finest level; base_triangles, wanted_base_triangles: at the base
//  - operations: vertex splits replayed
//  - operations_without_rule: of them refused (only a wrong progressive mesh has such)
//  - operations_isolating: of them introduced an isolated triangle
//  - operations_adding_strip: of them left more strips than before
//  - rules: {asked, taken, kept, improved}, of the way up and the way back: rules looked up; of them those whose
//    colours were written, and those with which colours passed on were as good and stayed; operations that a search
//    improved afterwards
//  - by_valence: {"k": splits of a fan of k triangles}
//  - levels: [{triangles, strips, isolated, swaps, indices}] from base to finest level, on the way up;
//    indices = triangles + 3 strips + swaps - 1, a first turn the wrong way counted as a swap
//  - levels_down: the same levels on the way back
//  - triangles_per_strip: at the finest level
//  - policy, cost, states, enough: how strips were kept; what was kept low: strips or indices
//  - most_strips: of all levels on the way up, every split counted
//  - baked: {flips_per_record, bytes_per_record, bake_seconds, levels_compared}; for baked strips
//  - cycles: [{cycle, base_strips, base_isolated, top_strips, top_isolated, isolating, adding_strip}], each a way down
//    and up; of more than 1024 the last one and every second, fourth … before it
//  - ns_per_operation, ns_per_operation_bare: a split with strips kept, and the same mesh update without (medians)
//  - ns_per_collapse, ns_per_collapse_bare: the same for the way down
//  - live_buffers: [{operations_per_update, bytes_per_operation, ns_per_update, ns_per_update_with_history, states}],
//    index buffers kept in step on the way up and down; ns_per_update: of an update after that many operations; states:
//    [{at, triangles, indices, strip_indices, acmr, acmr_32}] at the base, at the finest level and at the base again.
//    The levels show the first buffer
//  - walk: {steps, seed, splits, collapses, flips, refused, isolating, flips_isolating, triangles, strips, isolated,
//    live_buffers, fault, fault_step}; when there was one
//  - left_out: {degenerate_triangles, non_manifold_vertices, large_vertices}, what no operation touches
//  - mended: {welded_vertices, vanished_triangles, turned_triangles}, when it was asked for
//  - left_out_content: what the file holds besides the mesh, if anything
//  - valid, faults: whether every check passed; which did not
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "lod/simplify.hpp"
#include "meshes/mend.hpp"
#include "replay/replay.hpp"
#include "replay/walk.hpp"

namespace restrip::tools {

/// The costs of baked strips.
struct BakedCosts {
  double flips_per_record = 0;
  double bytes_per_record = 0;  ///< of the file, vertex positions and connectivity included
  double seconds = 0;           ///< of baking; 0 if they were read from a file
};

/// What was replayed.
struct Subject {
  std::string name;
  std::size_t wanted_triangles = 0;  ///< of the base; 0 if the base was given
  LeftOut left_out;
  Mended mended;       ///< of the file, if it was read
  std::string policy;  ///< the way's name
  Search search;       ///< of the way
  Cost cost;           ///< the minimised cost
  std::optional<BakedCosts> baked;
};

[[nodiscard]] std::string as_text(const ReplayReport& report, const Subject& subject);
[[nodiscard]] std::string as_text(const WalkReport& walk);
[[nodiscard]] nlohmann::ordered_json as_json(const ReplayReport& report, const Subject& subject,
                                             const std::optional<WalkReport>& walk);

}  // namespace restrip::tools
