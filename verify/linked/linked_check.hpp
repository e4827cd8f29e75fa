#pragma once
// All checks of one section of linked rules: points 1 to 4 of docs/reference/certificate.md, "Linked rules", for each
// list of alternatives, which are the conditions under which its first sound row is the best, whatever lies outside;
// and that it is the best, in every world.

#include <string>
#include <vector>

#include "judge/report.hpp"
#include "linked/linked_certificate.hpp"
#include "model/coloring.hpp"

namespace restrip::verify {

/// Ascending: a greater merit is preferred.
struct Merit {
  int solid = 0;
  int fewer_isolated = 0;  ///< minus the isolated triangles
  friend constexpr auto operator<=>(Merit, Merit) = default;
};

/// All ports stay solid.
struct Recoloring {
  Colors colors;
  Survey survey;
  Merit merit;
};

/// Of one list or several.
struct ListFailures {
  Failures present;
  Failures legal;
  Failures ordered;
  Failures uncovered;
  Failures complete;
};

/// All recolourings with these solid ports, by their inner mask.
std::vector<Recoloring> recolorings_of(const Side& after, Mask ports);

/// Adds the faults of the list of these ports. An illegal row fails only that claim and is otherwise ignored.
void check_list(const Side& after, const std::vector<Recoloring>& recolorings, Mask ports, List list,
                const std::string& file, ListFailures& failures);

/// The combined results of sections.
struct LinkedCheck {
  std::uint64_t recolorings = 0;  ///< over all ports
  std::uint64_t worlds = 0;       ///< (ports, world)
  ListFailures lists;
  Failures best;  ///< the first sound row is not the best in some world
  Failures claims;
  std::uint64_t sections = 0;
  std::uint64_t rows = 0;
  double listing_seconds = 0;  ///< processor time
  double world_seconds = 0;
};

/// Checks the lists of a section of a file and adds the results.
void check_linked(const Section& section, const SectionLists& lists, const std::string& file, LinkedCheck& check);

/// Reports the results of all sections, claim by claim.
void report_linked(const LinkedFamily& family, const LinkedCheck& sum, const ClaimListener& listener);

/// The lines, without newlines, that a dump of the compiled tables must have for this section: for each port mask its
/// list, with the pairings found on the graph, each with `places` ports.
std::vector<std::string> dump_of(const Section& section, const SectionLists& lists, unsigned places);

}  // namespace restrip::verify
