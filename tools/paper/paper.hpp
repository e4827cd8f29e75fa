// Reproduces the experiments of the paper: M. B. Porcu, N. Sanna, R. Scateni, "Rewriting rules for the dual graph of a
// stripified CLOD mesh". For each mesh: triangles per vertex (tables 1 and 2, plots 9 and 10), how many splits
// introduce an isolated triangle under the paper's rules and under ours, and the number of strips at each level of
// detail, compared with strips from scratch.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lod/simplify.hpp"
#include "meshes/mend.hpp"
#include "meshes/mesh_report.hpp"
#include "replay/replay.hpp"
#include "replay/source.hpp"
#include "restrip/rules/rules.hpp"

namespace restrip::tools {

struct PaperOptions {
  SimplifyOptions simplify;
  std::size_t levels = 12;  ///< of detail, in geometric steps, including base and finest level; at least 2
};

/// A mesh in the tables of the paper.
struct PaperRow {
  std::string mesh;
  std::size_t triangles = 0;
  std::vector<std::size_t> triangles_per_vertex;  ///< [n]: vertices of n triangles
  std::optional<double> isolating_percent;  ///< splits that introduced an isolated triangle, if the paper gives it
};

/// The paper's row for a mesh of this size, if it has one.
[[nodiscard]] std::optional<PaperRow> paper_row(std::size_t triangles);

/// One pass from base to finest level under one way of keeping strips (methods.hpp), or with strips from scratch at
/// every level.
struct PolicyRun {
  std::string name;
  std::string says;
  bool of_paper = false;
  std::size_t splits = 0;     ///< 0 from scratch
  std::size_t isolating = 0;  ///< splits after which the patch had more isolated triangles than before
  std::vector<Level> levels = {};

  [[nodiscard]] double isolating_percent() const noexcept {
    return splits == 0 ? 0 : 100 * static_cast<double>(isolating) / static_cast<double>(splits);
  }
};

struct PaperMesh {
  std::string name;
  std::size_t triangles = 0;
  MeshReport survey;
  std::optional<PaperRow> paper;
  std::size_t base_triangles = 0;
  std::vector<std::size_t> splits_by_valence;  ///< [k]: splits of a vertex of k triangles
  std::vector<PolicyRun> runs;                 ///< the paper's, then ours
  std::vector<PolicyRun> scratch;
  std::vector<std::string> faults;  ///< found by a check; empty if all is well
  Mended mended;                    ///< of its file, if it was read

  /// Whether the mesh equals the paper's row, if there is one.
  [[nodiscard]] bool equals_paper() const {
    return paper && paper->triangles_per_vertex == survey.triangles_per_vertex;
  }
};

/// Counts strips at this number of levels. The subject needs the triangles of its finest level. About two seconds per
/// 10,000 triangles, mostly for baking and for strips from scratch.
[[nodiscard]] PaperMesh measure(const Source& subject, std::size_t levels = PaperOptions().levels);

// ---- figures 6, 7 and 8, computed from the shipped tables: where a vertex can be split, the rules of the 4-vertex,
// and where a triangle would stay isolated if no strip were cut

/// All split positions of closed fans of up to `most_k` triangles: floor(k / 2) for each k from 3.
[[nodiscard]] std::vector<SplitPosition> split_positions(std::size_t most_k);

/// A configuration and its rule, one per orbit under the symmetries that keep the split position: the mirror that swaps
/// the ends of each arc and, if the arcs are equal, the half turn.
struct RuleOfOrbit {
  SplitPosition at;
  Word loop = 0;
  Word ports = 0;
  Word inner = 0;  ///< the colours chosen by the rule
  int strips = 0;  ///< change in the number of strips
  int isolated = 0;
  std::size_t orbit = 1;  ///< number of configurations in the orbit
};

/// Every valid configuration, reduced; the representative is the lowest (loop, ports) of its orbit.
[[nodiscard]] std::vector<RuleOfOrbit> reduced_rules(SplitPosition at);

/// Orbits of the loop colours alone, as the paper's figure 7 counts them. It includes the fully solid loop, a cycle.
[[nodiscard]] std::size_t loop_orbits(SplitPosition at);

/// One rule for each orbit of loop colours: with a solid port at every triangle that can have one.
[[nodiscard]] std::vector<RuleOfOrbit> rules_with_full_ports(SplitPosition at);

/// The cost of keeping every passing strip whole (figure 8). A strip *passes* if it enters the patch by one port and
/// leaves it by another. To keep it whole, a recolouring joins the same pairs of ports as before: P' = P.
struct LonelyRule {
  RuleOfOrbit rule;  ///< the rule in the tables
  Word whole =
      0;  ///< the best recolouring that keeps the passing strips whole: fewest isolated, most solid edges, lowest
  int isolated_if_whole = 0;  ///< change in the number of isolated triangles under it: positive
};

struct LonelyCount {
  SplitPosition at;
  std::size_t valid = 0;         ///< configurations
  std::size_t lonely = 0;        ///< configurations that must isolate a triangle if P' = P
  std::size_t isolated = 0;      ///< lonely configurations in which the rule isolates one too
  std::size_t adding_strip = 0;  ///< lonely configurations in which the rule adds a strip
  std::vector<LonelyRule> orbits;
};

/// Tries every recolouring: four times the work for each further k.
[[nodiscard]] LonelyCount lonely_configurations(SplitPosition at);

/// All of figures 6, 7 and 8.
struct RuleFigures {
  std::vector<SplitPosition> positions;  ///< 15 to k = 8, 4 more for k = 9
  struct FourVertex {
    SplitPosition at;
    std::size_t loops = 0;             ///< orbits of loop colours
    std::vector<RuleOfOrbit> by_loop;  ///< one each, except for the cycle, with full ports
    std::vector<RuleOfOrbit> all;      ///< of valid configurations
  };
  std::vector<FourVertex> four;
  std::vector<LonelyCount> lonely;  ///< k = 3 … 8
};
[[nodiscard]] RuleFigures rule_figures();

// ---- the report as JSON, from which scripts/paper_page.py makes a page and a CSV file for each figure. Without dates
// and timings, so the bytes are the same on every run.

/// Everything that the page shows: {base, boundary, levels, table_max_k, split_positions, positions: [{k, a}],
/// four_vertex: [{a, loop_orbits, by_loop, all}], lonely: [{k, a, valid, lonely, rule_isolates, rule_adds_strip,
/// orbits}], meshes: [{mesh, triangles, base_triangles, used_vertices, paper, equals_paper, valence, splits_by_valence,
/// policies, scratch, faults, mended}]}; rules are {loop, ports, inner, strips, isolated, orbit}, levels {triangles,
/// strips, isolated}.
[[nodiscard]] nlohmann::ordered_json as_json(const RuleFigures& figures, const std::vector<PaperMesh>& meshes,
                                             const PaperOptions& options);
[[nodiscard]] std::string as_text(const std::vector<PaperMesh>& meshes);

}  // namespace restrip::tools
