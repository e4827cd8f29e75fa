#pragma once
// Claims about a section as a whole, once the rows have been judged.

#include "judgment.hpp"
#include "orbits.hpp"

namespace restrip::verify {

/// Every row's key belongs to a valid configuration of some operation of the section.
Failures extra_rows(const Section& section, const SectionRows& rows, const std::vector<bool>& used,
                    const std::string& file);

/// Every orbit of keys has its `rule` row at its smallest key, every other key is a `copy` whose symmetry keeps the
/// position and takes key and recolouring to those of the `rule` row.
Failures wrong_witnesses(const Section& section, const SectionRows& rows, const std::string& file);

/// The numbers that the section's claims state, as recomputed; the order is that of claim_words.
struct Recount {
  std::array<std::int64_t, claim_words.size()> numbers{};
  void add(const Judgment& judgment, const OrbitCounts& orbits);
};

Failures wrong_claims(const SectionRows& rows, const Recount& recount, const std::string& file);

}  // namespace restrip::verify
