// The stage `solve` of the generator's pipeline. A section has all rules of one position, or of all positions that
// share them. It is the unit of work for threads.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "common/progress.hpp"
#include "common/share.hpp"
#include "describe/description.hpp"
#include "describe/operation.hpp"
#include "solve/coloring.hpp"
#include "solve/symmetry.hpp"

namespace restrip::generator {

// Exhaustive search: the best sound recolouring for every key.

/// The colours after an operation.
struct Choice {
  Mask recoloring = 0;
  Mask kept = 0;          ///< ports that stay solid
  unsigned solid = 0;     ///< solid inner edges
  unsigned isolated = 0;  ///< isolated triangles; a port given up counts as one
};

/// By solid ports: the pairs that some valid recolouring joins. For other pairs it does not matter whether they were
/// joined.
[[nodiscard]] std::vector<PortPairs> relevant_pairs(const Operation& operation);

/// The values of the criteria, followed by the tie-break; smaller is better, compared lexicographically.
using CriterionValues = std::array<std::int64_t, most_criteria + 1>;

/// A valid recolouring.
struct Candidate : Choice {
  PortPairs joins;
  CriterionValues values{};
};

/// The valid recolourings of one port mask, best first. `colorings` are the legal colourings of the side after the
/// operation. The best for a key is the first that joins only previously joined pairs. Fans always have one: everything
/// dashed inside, and no port given up.
[[nodiscard]] std::vector<Candidate> candidates_for(const Operation& operation, const std::vector<Coloring>& colorings,
                                                    Mask ports);

/// A rule: the colours after.
struct Row : Choice {
  Key key;
  int witness = -1;  ///< index of the symmetry that maps it to the representative; -1 for the representative
};

/// What certificates claim about the configurations of one operation, in the words of docs/reference/certificate.md.
struct Claims {
  std::size_t configurations = 0;
  std::size_t valid = 0;
  std::size_t orbits = 0;
  std::size_t valid_orbits = 0;
  std::size_t costing = 0;
  int worst_strips = std::numeric_limits<int>::min();
  int worst_isolated = std::numeric_limits<int>::min();
};

/// Combines several positions: counts are added, worst cases are maximised.
[[nodiscard]] Claims sum(const std::vector<Claims>& parts);

/// A section to solve: its patches.
struct Patches {
  std::string certificate;  ///< "fan-collapse"
  Position position;        ///< family and valence, and the rest of the position unless all positions are served
  std::vector<PositionWithPatch> serves;  ///< the positions whose configurations these rules answer
};

/// The solution.
struct Section : Patches {
  std::vector<Row> rows;            ///< in ascending order of key
  std::vector<PatchMap> symmetry;   ///< the maps from copies to their representatives
  double symmetries = 1;            ///< the order of the symmetry group of the rows' operation
  std::vector<PortPairs> relevant;  ///< by solid ports: pairs that a recolouring could join
  std::vector<Claims> claims;       ///< for each position served
};

/// Calls work(i, watched) once for each section i, the largest valences first, which take longest. A terminal shows
/// `label` with the completed share; the work on an only section is watched instead.
template <class Any, class Work>
void share_sections(const std::vector<Any>& sections, unsigned threads, const char* label, Work&& work) {
  const bool only = sections.size() == 1;
  std::vector<std::size_t> places(sections.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  std::stable_sort(places.begin(), places.end(),
                   [&](std::size_t x, std::size_t y) { return sections[x].position.k > sections[y].position.k; });
  Progress progress(label, places.size(), only ? Watched::no : Watched::yes);
  share(places.size(), threads, [&](std::size_t i) {
    work(places[i], only ? Watched::yes : Watched::no);
    progress.step();
  });
}

/// The certificates of these descriptions, in writing order: at the index of the last description that shares each.
[[nodiscard]] std::vector<std::string> certificates_of(const std::vector<Description>& descriptions);

/// The sections of these certificates in order, for valences up to max_k (at most 13, so that a recolouring has 16
/// bits). Throws std::runtime_error, with place and remedy, if positions cannot share a section, or if one of a user is
/// too large for a table.
[[nodiscard]] std::vector<Patches> patches_of(const std::vector<Description>& descriptions, unsigned max_k);

/// Rows and claims, by exhaustive search, reduced by symmetry. Threads may solve different sections at the same time.
/// Throws std::runtime_error, naming operation and configuration, if a configuration has no sound recolouring.
[[nodiscard]] Section solve(Patches patches, Watched watched = Watched::no);

/// All sections in order; `threads` share the work, and the result does not depend on their number.
[[nodiscard]] std::vector<Section> solve_all(const std::vector<Patches>& patches, unsigned threads);

/// A position and the section whose rows answer its configurations.
struct AnsweredPosition {
  PositionWithPatch position;
  const Section* section = nullptr;
};

/// All positions of a description up to max_k, by the sections of its certificate. Positions that it does not list,
/// because they are images of others, are solved. The sections must outlive the answers.
struct Answers {
  std::vector<Section> images;
  std::vector<AnsweredPosition> positions;
};
[[nodiscard]] Answers answers_of(const Description& description, const std::vector<Section>& known, unsigned max_k);

/// The row that answers a valid configuration with these solid ports and joined pairs.
[[nodiscard]] const Row& row_of(const Section& section, Mask ports, const PortPairs& joined);

/// One valid configuration of a side, and the pairs that it joins.
struct Configuration {
  Mask before = 0;
  Mask ports = 0;
  Outcome outcome;
};

/// Calls visit for every valid configuration, in ascending order of (before, ports).
template <class Visit>
void for_each_valid(const Operation& operation, Visit&& visit) {
  const Side& before = operation.patch.before;
  for (const Coloring& coloring : legal_colorings(before, operation.constraint))
    for (Mask ports = 0; ports <= before.all_ports(); ++ports)
      if (const auto outcome = with_ports(coloring, ports)) visit(Configuration{coloring.inner, ports, *outcome});
}

/// The change in strips and isolated triangles when a row answers a configuration.
struct Change {
  int strips = 0;
  int isolated = 0;
};
[[nodiscard]] Change change_of(const Patch& patch, const Configuration& configuration, const Row& row);

}  // namespace restrip::generator
