#pragma once
// All checks of one section of linked rules.

#include "linked/list_check.hpp"

namespace restrip::verify {

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

/// One task: the lists of a section.
struct LinkedTask {
  const Section* section = nullptr;
  const SectionLists* lists = nullptr;
  std::string file;
};

/// Checks a section and adds the results.
void check_linked(const LinkedTask& task, LinkedCheck& check);

/// Reports the results of all sections, claim by claim.
void report_linked(const LinkedFamily& family, const LinkedCheck& sum, const ClaimListener& listener);

/// The lines, without newlines, that a dump of the compiled tables must have for this section: for each port mask its
/// list, with the pairings found on the graph, each with `places` ports.
std::vector<std::string> dump_of(const Section& section, const SectionLists& lists, unsigned places);

}  // namespace restrip::verify
