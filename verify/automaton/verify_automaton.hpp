#pragma once
// The automaton's certificate from top to bottom.

#include <string>

#include "report.hpp"

namespace restrip::verify {

struct AutomatonOptions {
  std::string tables_dir = "tables";
  unsigned max_k = 10;  ///< the largest fans that are searched
  unsigned every = 1;   ///< of the fans with k > 8 only every n-th place
};

struct AutomatonTotals {
  std::uint64_t claims = 0;
  std::uint64_t failed = 0;
  std::uint64_t classes = 0;
  std::uint64_t rows = 0;
  std::uint64_t kinds = 0;  ///< of arcs, told apart by what is best for each case, ports and class
};

/// Checks everything; calls the listener for each claim. InputError when a file cannot be read.
AutomatonTotals verify_automaton(const AutomatonOptions& options, const ClaimListener& listener);

}  // namespace restrip::verify
