#pragma once
// Judges the choices of the linked look-up, as printed by a program (docs/reference/verifiers.md, "Dump of linked
// rules"): for every configuration in every position, a tree of questions about the outside. Certificates are not used.
// The choice at a leaf is compared with all recolourings, in all outsides that agree with the answers on the way to the
// leaf.

#include <cstdio>
#include <string>

#include "judge/report.hpp"
#include "model/family.hpp"

namespace restrip::verify {

struct LinkedDumpCheck {
  std::uint64_t positions = 0;
  std::uint64_t configurations = 0;  ///< valid ones
  std::uint64_t leaves = 0;          ///< (valid configuration, possible path of answers)
  Failures wrong;
  std::string fault;  ///< why the dump could not be read to its end; otherwise empty
  bool holds() const { return wrong.count == 0 && fault.empty() && leaves != 0; }
};

/// Reads a dump to its end. Every position with k <= max_k must occur once, in ascending order, splits first.
LinkedDumpCheck check_linked_dump(std::FILE* stream, unsigned max_k);

/// Runs the program and checks its output; a failing program is a fault.
LinkedDumpCheck check_linked_dump_of(const std::string& program, unsigned max_k);

}  // namespace restrip::verify
