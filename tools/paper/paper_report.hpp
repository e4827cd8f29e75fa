// Writes the report of `restrip paper`: a CSV file for each figure, and all of them together as JSON, from which
// scripts/paper_page.py makes a page. Without dates and timings, so the bytes are the same on every run.
#pragma once

#include <string>
#include <vector>

#include "common/output.hpp"
#include "paper/paper.hpp"
#include "paper/paper_rules.hpp"

namespace restrip::tools {

/// Each file has a header line; masks are decimal, numbered as in docs/reference/notation.md. Percentages have two
/// digits.
///   positions.csv      k,a,b                          figure 6
///   rules-4.csv        a,loop,ports,inner,strips,isolated,orbit   figure 7, one line for each orbit
///   lonely-counts.csv  k,a,valid,lonely,rule_isolates,rule_adds_strip,orbits
///   lonely.csv         k,a,loop,ports,orbit,whole,isolated_if_whole,inner,strips,isolated   figure 8
[[nodiscard]] std::vector<files::NamedBytes> csv_files(const RuleFigures& figures);
///   valence.csv        mesh,triangles_per_vertex,vertices,percent,paper_vertices   tables 1 and 2, plots 9 and 10
///   isolating.csv      mesh,policy,splits,isolating,percent
///   strips.csv         mesh,policy,triangles,strips,isolated
[[nodiscard]] std::vector<files::NamedBytes> csv_files(const std::vector<PaperMesh>& meshes);

/// Everything that the page shows: {base, boundary, levels, table_max_k, split_positions, positions: [{k, a}],
/// four_vertex: [{a, loop_orbits, by_loop, all}], lonely: [{k, a, valid, lonely, rule_isolates, rule_adds_strip,
/// orbits}], meshes: [{mesh, triangles, base_triangles, used_vertices, paper, equals_paper, valence, splits_by_valence,
/// policies, scratch, faults, mended}]}; rules are {loop, ports, inner, strips, isolated, orbit}, levels {triangles,
/// strips, isolated}.
[[nodiscard]] std::string as_json(const RuleFigures& figures, const std::vector<PaperMesh>& meshes,
                                  const PaperOptions& options);
[[nodiscard]] std::string as_text(const std::vector<PaperMesh>& meshes);

}  // namespace restrip::tools
