#pragma once
// Everything that is checked of one section of linked rules.

#include "linked/list_check.hpp"

namespace restrip::verify {

/// What was found in sections, all together.
struct LinkedCheck {
  std::uint64_t recolorings = 0;  ///< of all ports
  std::uint64_t worlds = 0;       ///< (ports, world)
  ListFailures lists;
  Failures best;  ///< in some world the first sound row is not the best
  Failures claims;
  std::uint64_t sections = 0;
  std::uint64_t rows = 0;
  double listing_seconds = 0;  ///< processor time
  double world_seconds = 0;
};

/// One piece of work: the lists of a section.
struct LinkedTask {
  const Section* section = nullptr;
  const SectionLists* lists = nullptr;
  std::string file;
};

/// Adds what is found there.
void check_linked(const LinkedTask& task, LinkedCheck& check);

/// Reports claim by claim what was found in all sections.
void report_linked(const LinkedFamily& family, const LinkedCheck& sum, const ClaimListener& listener);

/// The lines that a dump of the compiled tables must have for this section, without newlines: for each port mask its
/// list, with the pairings as they are found on the graph, of so many ports each.
std::vector<std::string> dump_of(const Section& section, const SectionLists& lists, unsigned places);

}  // namespace restrip::verify
