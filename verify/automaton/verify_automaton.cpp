#include "verify_automaton.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <vector>

#include "class_check.hpp"
#include "family_check.hpp"
#include "fan_check.hpp"
#include "input.hpp"
#include "quantity.hpp"
#include "turn_check.hpp"
#include "turn_fans.hpp"

namespace restrip::verify {

namespace {

/// Tells claims one after the other, each with the time since the one before.
class ClaimTeller {
 public:
  ClaimTeller(AutomatonTotals& totals, const ClaimListener& listener) : totals_(totals), listener_(listener) {}

  void tell(const std::string& family, const std::string& claim, const std::string& method, std::uint64_t cases,
            const Failures& failures) {
    ClaimResult result{family, claim, method, cases, thread_seconds() - start_, failures.count, failures.first};
    start_ = thread_seconds();
    if (cases == 0 && result.held()) {
      result.failures = 1;
      result.counterexample = "nothing was compared";
    }
    ++totals_.claims;
    totals_.failed += result.held() ? 0U : 1U;
    listener_(result);
  }
  void tell(const std::string& family, const std::vector<AutomatonClaim>& claims) {
    for (const AutomatonClaim& claim : claims) tell(family, claim.claim, claim.method, claim.cases, claim.failures);
  }
  void tell_fans(const std::string& family, const std::string& method, unsigned k, unsigned every,
                 const FanCheck& check) {
    tell(family, fmt::format("every answer with k = {} is sound and best", k),
         fmt::format("{}, {}{}", method, every == 1 ? "all " : "", quantity(check.places, "place")), check.keys,
         check.failures);
  }

 private:
  AutomatonTotals& totals_;
  const ClaimListener& listener_;
  double start_ = thread_seconds();
};

std::string certificate_of(const AutomatonOptions& options, const std::string& family) {
  return options.tables_dir + "/certificates/" + family + ".cert";
}

void verify_strips(const AutomatonOptions& options, AutomatonTotals& totals, ClaimTeller& teller) {
  const std::string path = certificate_of(options, "automaton");
  const AutomatonCertificate certificate = parse_automaton(path, read_file(path));
  totals.classes += certificate.classes.size();
  totals.rows += certificate.rows;
  const ClassCheck classes(certificate);
  totals.kinds += classes.arcs().size();
  teller.tell("automaton", classes.claims());
  // Answers are read through steps and meetings that belong together only if all of that holds.
  if (totals.failed != 0) return;

  for (const Family& family : all_families(options.tables_max_k)) {
    if (family.sections.front().operations.front().gives_ports_up) continue;
    const std::string file = certificate_of(options, family.name);
    const FanCheck check = check_against_rows(certificate, family, parse_certificate(file, read_file(file), family));
    teller.tell("automaton", fmt::format("worth what the rules of {} are", family.name),
                fmt::format("k <= {}, {}, {} the very rule", options.tables_max_k, quantity(check.places, "position"),
                            check.same),
                check.keys, check.failures);
  }
  for (unsigned k = 1; k <= options.max_k; ++k) {
    const unsigned every = k > largest_fan ? options.every : 1;
    teller.tell_fans("automaton", "all recolourings", k, every, check_against_search(certificate, k, every));
  }
}

void verify_indices(const AutomatonOptions& options, AutomatonTotals& totals, ClaimTeller& teller) {
  const std::string path = certificate_of(options, "index-automaton");
  const TurnCertificate certificate = parse_turn_automaton(path, read_file(path));
  totals.classes += certificate.classes.size();
  totals.rows += certificate.rows;
  const TurnCheck check(certificate, options.index_every);
  totals.kinds += check.arcs().size();
  const std::uint64_t failed_before = totals.failed;
  teller.tell("index-automaton", check.claims());
  if (totals.failed != failed_before) return;
  for (unsigned k = 1; k <= options.index_max_k; ++k) {
    const unsigned every = k > 5 ? options.index_every : 1;
    teller.tell_fans("index-automaton", "all recolourings, all turns behind ports", k, every,
                     check_turns_against_search(certificate, k, every));
  }
}

}  // namespace

AutomatonTotals verify_automaton(const AutomatonOptions& options, const ClaimListener& listener) {
  AutomatonTotals totals;
  ClaimTeller teller(totals, listener);
  if (options.strips) verify_strips(options, totals, teller);
  if (options.indices) verify_indices(options, totals, teller);
  return totals;
}

}  // namespace restrip::verify
