#pragma once
// Everything that is checked of one section of linked rules.

#include "certificate/certificate.hpp"
#include "linked/list_check.hpp"

namespace restrip::verify {

/// What was found in sections, all together.
struct LinkedCheck {
  std::uint64_t recolorings = 0;     ///< of all ports
  std::uint64_t worlds = 0;          ///< (ports, matching outside)
  std::uint64_t beside = 0;          ///< (alternative, matching outside)
  std::uint64_t configurations = 0;  ///< valid ones before the operation, all positions
  bool searched = true;              ///< beside everything outside; beyond largest_fan only the lists are checked
  ListFailures lists;
  Failures condition;  ///< sound in the world, or not, other than the alternative's pairs say
  Failures best;       ///< beside some matching the first sound row is not the best
  Failures local;      ///< for what the colours alone tell, it is not as good as the local rule
  Failures claims;
  std::uint64_t sections = 0;
  std::uint64_t rows = 0;
  double listing_seconds = 0;  ///< processor time
  double beside_seconds = 0;
};

/// One piece of work: the lists of a section, and the rows of the local family for the same section.
struct LinkedTask {
  const Section* section = nullptr;
  const SectionLists* lists = nullptr;
  const SectionRows* local = nullptr;
  std::string file;
  std::string local_file;
};

/// Adds what is found there.
void check_linked(const LinkedTask& task, LinkedCheck& check);

/// Reports claim by claim what was found in all sections.
void report_linked(const LinkedFamily& family, const LinkedCheck& sum, const ClaimListener& listener);

/// The lines that a dump of the compiled tables must have for this section, without newlines: for each port mask its
/// list, with the pairings as they are found on the graph, of so many ports each.
std::vector<std::string> dump_of(const Section& section, const SectionLists& lists, unsigned places);

}  // namespace restrip::verify
