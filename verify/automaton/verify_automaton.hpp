#pragma once
// The complete verification of the automaton's certificate.

#include <string>

#include "automaton/automaton_digests.hpp"
#include "judge/report.hpp"
#include "model/family.hpp"

namespace restrip::verify {

struct AutomatonOptions {
  std::string tables_dir = "tables";
  std::string dump_command;                    ///< prints the compiled automaton; empty: not read
  std::vector<std::string> digest_commands;    ///< programs that print digests of the answers of look-ups
  unsigned digest_max_k = largest_digest_fan;  ///< the largest fans of digests
  unsigned tables_max_k = largest_fan;  ///< the largest fans of the other certificates, and of the answers of the dump
  unsigned max_k = 10;                  ///< the largest fans that are searched
  unsigned every = 1;                   ///< only every n-th place of the fans with k > 8 is searched
};

struct AutomatonTotals {
  std::uint64_t claims = 0;
  std::uint64_t failed = 0;
  std::uint64_t classes = 0;
  std::uint64_t rows = 0;
  Sources read;
  std::uint64_t kinds = 0;  ///< of arcs, distinguished by the best cost of each case, ports and class
};

/// Checks the certificate; calls the listener for each claim. Throws InputError if a file cannot be read.
AutomatonTotals verify_automaton(const AutomatonOptions& options, const ClaimListener& listener);

}  // namespace restrip::verify
