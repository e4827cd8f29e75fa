// The report of `restrip paper`: one page of HTML that needs nothing else, and a CSV file behind each of its figures.
// No dates and no timings: the same bytes on every run.
#pragma once

#include <string>
#include <vector>

#include "files/output.hpp"
#include "paper/paper.hpp"
#include "paper/paper_rules.hpp"

namespace restrip::tools {

/// Each has a header line; masks are decimal, numbered as in docs/notation.md. Percentages have two digits.
///   positions.csv      k,a,b                          figure 6
///   rules-4.csv        a,loop,ports,inner,strips,isolated,orbit   figure 7, one line for each orbit
///   lonely-counts.csv  k,a,valid,lonely,rule_isolates,rule_adds_strip,orbits
///   lonely.csv         k,a,loop,ports,orbit,whole,isolated_if_whole,inner,strips,isolated   figure 8
[[nodiscard]] std::vector<files::NamedBytes> csv_files(const RuleFigures& figures);
///   valence.csv        mesh,triangles_per_vertex,vertices,percent,paper_vertices   tables 1 and 2, plots 9 and 10
///   isolating.csv      mesh,policy,splits,isolating,percent
///   strips.csv         mesh,policy,triangles,strips,isolated
[[nodiscard]] std::vector<files::NamedBytes> csv_files(const std::vector<PaperMesh>& meshes);

/// The page. `base` and `levels` are told, so that the report can be made again.
[[nodiscard]] std::string as_html(const RuleFigures& figures, const std::vector<PaperMesh>& meshes,
                                  const PaperOptions& options);

[[nodiscard]] std::string as_text(const std::vector<PaperMesh>& meshes);
[[nodiscard]] std::string as_json(const RuleFigures& figures, const std::vector<PaperMesh>& meshes);

}  // namespace restrip::tools
