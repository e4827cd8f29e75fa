#include "verify_automaton.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "class_check.hpp"
#include "family_check.hpp"
#include "fan_check.hpp"
#include "input.hpp"

namespace restrip::verify {

AutomatonTotals verify_automaton(const AutomatonOptions& options, const ClaimListener& user_listener) {
  AutomatonTotals totals;
  double start = thread_seconds();
  const auto tell = [&](const std::string& claim, const std::string& method, std::uint64_t cases,
                        const Failures& failures) {
    ClaimResult result{"automaton", claim, method, cases, thread_seconds() - start, failures.count, failures.first};
    start = thread_seconds();
    if (cases == 0 && result.held()) {
      result.failures = 1;
      result.counterexample = "nothing was compared";
    }
    ++totals.claims;
    totals.failed += result.held() ? 0U : 1U;
    user_listener(result);
  };
  const auto file_of = [&](const std::string& family) {
    return options.tables_dir + "/certificates/" + family + ".cert";
  };

  const std::string path = file_of("automaton");
  const AutomatonCertificate certificate = parse_automaton(path, read_file(path));
  totals.classes = certificate.classes.size();
  totals.rows = certificate.rows;
  const ClassCheck classes(certificate);
  totals.kinds = classes.arcs().size();
  for (const AutomatonClaim& claim : classes.claims()) tell(claim.claim, claim.method, claim.cases, claim.failures);
  // Answers are read through steps and meetings that belong together only if all of that holds.
  if (totals.failed != 0) return totals;

  for (const Family& family : all_families()) {
    if (family.sections.front().operations.front().gives_ports_up) continue;
    const std::string file = file_of(family.name);
    const FanCheck check = check_against_rows(certificate, family, parse_certificate(file, read_file(file), family));
    tell(fmt::format("worth what the rules of {} are", family.name),
         fmt::format("k <= 8, {} positions, {} the very rule", check.places, check.same), check.keys, check.failures);
  }
  for (unsigned k = 1; k <= options.max_k; ++k) {
    const unsigned every = k > largest_fan ? options.every : 1;
    const FanCheck check = check_against_search(certificate, k, every);
    tell(fmt::format("every answer with k = {} is sound and best", k),
         fmt::format("all recolourings, {}{} places", every == 1 ? "all " : "", check.places), check.keys,
         check.failures);
  }
  return totals;
}

}  // namespace restrip::verify
