#pragma once
// Judges what the linked look-up picks, as a program prints it (docs/reference/verifiers.md, "Dump of linked rules"):
// for every configuration in every position a tree of questions about the outside. Nothing is taken from the
// certificates: what a leaf picks is held against all recolourings, beside all strips that may lie outside for all that
// the leaf knows.

#include <cstdio>
#include <string>

#include "judge/report.hpp"
#include "model/family.hpp"

namespace restrip::verify {

struct LinkedDumpCheck {
  std::uint64_t positions = 0;
  std::uint64_t configurations = 0;  ///< valid ones
  std::uint64_t leaves = 0;          ///< (valid configuration, path of answers that can be)
  Failures wrong;
  std::string fault;  ///< why the dump could not be read to its end; empty when it could
  bool holds() const { return wrong.count == 0 && fault.empty() && leaves != 0; }
};

/// Reads a dump to its end. Every position with k <= max_k must come once, in ascending order, splits first.
LinkedDumpCheck check_linked_dump(std::FILE* stream, unsigned max_k);

/// Runs the program and checks what it prints; a program that fails is a fault.
LinkedDumpCheck check_linked_dump_of(const std::string& program, unsigned max_k);

}  // namespace restrip::verify
