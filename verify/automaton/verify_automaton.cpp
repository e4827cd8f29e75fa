#include "automaton/verify_automaton.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <vector>

#include "automaton/automaton_digests.hpp"
#include "automaton/automaton_dump.hpp"
#include "automaton/class_check.hpp"
#include "automaton/fan_check.hpp"
#include "common/counted.hpp"
#include "judge/report.hpp"
#include "model/input.hpp"

namespace restrip::verify {

namespace {

/// Reports claims one after the other, each with the time since the previous one.
class ClaimReporter {
 public:
  ClaimReporter(AutomatonTotals& totals, const ClaimListener& listener) : totals_(totals), listener_(listener) {}

  void report(const std::string& claim, const std::string& method, std::uint64_t cases, const Failures& failures) {
    ClaimResult result{"automaton", claim, method, cases, thread_seconds() - start_, failures.count, failures.first};
    start_ = thread_seconds();
    if (cases == 0 && result.held()) {
      result.failures = 1;
      result.counterexample = "nothing was compared";
    }
    ++totals_.claims;
    totals_.failed += result.held() ? 0U : 1U;
    listener_(result);
  }

 private:
  AutomatonTotals& totals_;
  const ClaimListener& listener_;
  double start_ = thread_seconds();
};

std::string certificate_of(const AutomatonOptions& options, const std::string& family) {
  return options.tables_dir + "/certificates/" + family + ".cert";
}

void tell_classes(const AutomatonCertificate& certificate, AutomatonTotals& totals, ClaimReporter& reporter) {
  totals.read.certificates = true;
  totals.classes += certificate.classes.size();
  totals.rows += certificate.rows;
  const ClassCheck classes(certificate);
  totals.kinds += classes.arcs().size();
  for (const AutomatonClaim& claim : classes.claims())
    reporter.report(claim.claim, claim.method, claim.cases, claim.failures);
}

void tell_dump(AutomatonDumpCheck dump, unsigned max_k, AutomatonTotals& totals, ClaimReporter& reporter) {
  totals.read.of_headers.emplace_back("compiled automaton");
  if (!dump.fault.empty()) dump.wrong_numbers.add(dump.fault);
  reporter.report("every number of the header is the certificate's", "its dump", dump.numbers, dump.wrong_numbers);
  reporter.report("every answer of the header is the certificate's", fmt::format("k <= {}, digests of its dump", max_k),
                  dump.keys, dump.wrong_answers);
}

}  // namespace

AutomatonTotals verify_automaton(const AutomatonOptions& options, const ClaimListener& listener) {
  AutomatonTotals totals;
  ClaimReporter reporter(totals, listener);
  const std::string path = certificate_of(options, "automaton");
  const AutomatonCertificate certificate = parse_automaton(path, read_file(path));
  tell_classes(certificate, totals, reporter);
  // Steps and meetings are consistent only if all claims above hold; answers rely on that.
  if (totals.failed != 0) return totals;

  if (!options.dump_command.empty())
    tell_dump(check_automaton_dump_of(options.dump_command, certificate, options.tables_max_k), options.tables_max_k,
              totals, reporter);

  if (!options.digest_commands.empty()) {
    const Digests digests = automaton_digests(certificate, options.digest_max_k);
    for (const std::string& command : options.digest_commands) {
      totals.read.of_headers.emplace_back("digests of a look-up");
      DigestComparison found = compare_digests_of(command, digests);
      if (!found.fault.empty()) found.differences.add(found.fault);
      reporter.report("a look-up answers as the certificate does",
                      fmt::format("k <= {}, digests", options.digest_max_k), found.positions, found.differences);
    }
  }

  for (const Family& family : all_families(options.tables_max_k)) {
    if (family.sections.front().operations.front().may_give_up != 0) continue;
    const std::string file = certificate_of(options, family.name);
    const FanCheck check = check_against_rows(certificate, family, parse_certificate(file, read_file(file), family));
    reporter.report(fmt::format("worth what the rules of {} are", family.name),
                    fmt::format("k <= {}, {}, {} the very rule", options.tables_max_k,
                                counted(check.places, "position"), check.same),
                    check.keys, check.failures);
  }
  for (unsigned k = 1; k <= options.max_k; ++k) {
    const unsigned every = k > largest_fan ? options.every : 1;
    const FanCheck check = check_against_search(certificate, k, every);
    reporter.report(fmt::format("every answer with k = {} is sound and best", k),
                    fmt::format("all recolourings, {}{}", every == 1 ? "all " : "", counted(check.places, "place")),
                    check.keys, check.failures);
  }
  return totals;
}

}  // namespace restrip::verify
