#pragma once
// The certificates of the automata from top to bottom.

#include <string>

#include "operation.hpp"
#include "report.hpp"

namespace restrip::verify {

struct AutomatonOptions {
  std::string tables_dir = "tables";
  bool strips = true;                   ///< look at automaton.cert
  bool indices = true;                  ///< look at index-automaton.cert
  unsigned tables_max_k = largest_fan;  ///< the largest fans of the other certificates, which are compared
  unsigned max_k = 10;                  ///< the largest fans that are searched for the automaton of fewest strips
  unsigned every = 1;                   ///< of the fans with k > 8 only every n-th place
  unsigned index_max_k = 6;             ///< the largest fans that are searched for the index automaton
  unsigned index_every = 1;             ///< of the pairs of its arcs, and of its fans with k > 5, only every n-th
};

struct AutomatonTotals {
  std::uint64_t claims = 0;
  std::uint64_t failed = 0;
  std::uint64_t classes = 0;
  std::uint64_t rows = 0;
  std::uint64_t kinds = 0;  ///< of arcs, told apart by what is best for each case, ports and class
};

/// Checks both certificates; calls the listener for each claim. InputError when a file cannot be read.
AutomatonTotals verify_automaton(const AutomatonOptions& options, const ClaimListener& listener);

}  // namespace restrip::verify
