#include "verify_operation.hpp"

#include <fmt/format.h>

#include <ctime>
#include <optional>
#include <utility>

#include "certificate_judge.hpp"
#include "input.hpp"
#include "operation_dump.hpp"
#include "reason_check.hpp"

namespace restrip::verify::operations {
namespace {

/// Processor seconds since it was made or last asked.
class Stopwatch {
 public:
  double lap() {
    const std::clock_t now = std::clock();
    return static_cast<double>(now - std::exchange(start_, now)) / CLOCKS_PER_SEC;
  }

 private:
  std::clock_t start_ = std::clock();
};

class OperationReport {
 public:
  OperationReport(const OperationFile& operation, const ClaimListener& listener, Totals& totals)
      : operation_(operation), listener_(listener), totals_(totals) {}

  void claim(const std::string& claim, const std::string& method, std::uint64_t cases, const Failures& failures) {
    ++totals_.claims;
    totals_.failed += failures.count == 0 ? 0U : 1U;
    listener_({operation_.name, claim, method, cases, watch_.lap(), failures.count, failures.first});
  }

 private:
  const OperationFile& operation_;
  const ClaimListener& listener_;
  Totals& totals_;
  Stopwatch watch_;
};

/// What docs/operation-file.md says of keys, with the definitions in place of it.
std::uint64_t report_keys(const RuleJudge& judge, OperationReport& report, Totals& totals) {
  const KeyCheck keys = check_keys(judge);
  const std::uint64_t tested = judge.before().tested + judge.after().tested;
  report.claim("same key, same worlds that a configuration fits",
               fmt::format("{} colourings as graphs in worlds", tested), keys.valid, keys.wrong);
  report.claim("sound by the worlds when it joins only pairs of J",
               fmt::format("{} pairs of classes", judge.shortcuts()), judge.pairs(),
               {judge.wrong_shortcuts(), judge.wrong_shortcut()});
  totals.configurations = keys.valid;
  totals.pairs = judge.pairs();
  return keys.keys;
}

void report_rows(const OperationFile& operation, const RowCheck& rows, const OperationCertificate& certificate,
                 std::uint64_t pairs, OperationReport& report) {
  report.claim("every valid configuration has a row", "all configurations as graphs", rows.valid, rows.missing);
  report.claim("every row has a valid configuration", "all configurations as graphs", certificate.rows.size(),
               rows.extra);
  report.claim("no port is taken, none given up that must stay", "ports before and after compared", rows.with_row,
               rows.wrong_ports);
  report.claim("every row is sound", "every world that the configuration fits", rows.with_row, rows.unsound);
  for (std::size_t i = 0; i < operation.cost.size(); ++i) {
    std::string name = text_of(operation.cost[i]);
    if (name.size() > 24) name = fmt::format("of criterion {}", i + 1);
    report.claim(fmt::format("{} sound recolouring has less {}", i == 0 ? "no" : "as good, no", name),
                 i == 0 ? "all recolourings, sound by the worlds" : "the same search", pairs, rows.not_best[i]);
  }
}

void report_certificate(RuleJudge& judge, const OperationCertificate& certificate, std::uint64_t keys,
                        OperationReport& report) {
  const RowCheck rows = check_rows(judge, certificate);
  report_rows(judge.operation(), rows, certificate, judge.pairs(), report);
  if (may_have_reasons(judge.operation())) {
    const ReasonCheck reasons = check_rule_reasons(judge, certificate);
    report.claim("the reasons why nothing is better are reasons",
                 reasons.reasons == 0 ? "the certificate gives none"
                                      : fmt::format("sets by the worlds, {} cases at most", reasons.most_cases),
                 reasons.reasons, reasons.wrong);
  }
  const PatchSymmetries symmetries(judge.operation());
  report.claim("copies follow from rules by symmetry",
               fmt::format("{:.0f} symmetries by backtracking", symmetries.order()), certificate.rows.size(),
               wrong_copies(certificate, symmetries));
  const OrbitSizes orbits = count_orbits(judge, symmetries);
  report.claim("the stated numbers", "recounted; orbits by merging images", number_words.size(),
               wrong_numbers(certificate, rows, keys, orbits));
}

void report_dump(const OperationDumpCheck& dump, bool with_certificate, OperationReport& report, Totals& totals) {
  // What could not be read to its end does not hold.
  const auto with_fault = [&](Failures failures) {
    if (!dump.fault.empty()) failures.add(dump.fault);
    return failures;
  };
  report.claim("every answer of the table is sound and best", "its dump; worlds, all recolourings", dump.entries,
               with_fault(dump.wrong));
  if (with_certificate)
    report.claim("every answer is the certificate's row", "its dump", dump.answers, with_fault(dump.other_than_stated));
  if (dump.fault.empty() && dump.wrong.count == 0) totals.answers["operation"] = {1, dump.entries};
}

}  // namespace

Totals verify_operation(const OperationOptions& options, const ClaimListener& listener) {
  const OperationFile operation = parse_operation_file(options.operation, read_file(options.operation));
  std::optional<OperationCertificate> certificate;
  if (!options.certificate.empty())
    certificate = parse_operation_certificate(options.certificate, read_file(options.certificate), operation);
  Totals totals;
  totals.graph_only = !operation.on_a_mesh;
  OperationReport report(operation, listener, totals);
  RuleJudge judge(operation);
  const std::uint64_t keys = report_keys(judge, report, totals);
  if (certificate) {
    totals.rules = certificate->rows.size();
    report_certificate(judge, *certificate, keys, report);
  }
  if (!options.dump_command.empty())
    report_dump(check_operation_dump_of(options.dump_command, judge, certificate ? &*certificate : nullptr),
                certificate.has_value(), report, totals);
  return totals;
}

std::string last_line_of(const OperationOptions& options, const Totals& totals) {
  std::string text = totals.graph_only ? "graph only: not checked to be an operation on a mesh\n" : "";
  text += fmt::format("{}: {}: {} configurations, {} recolourings of them",
                      totals.failed == 0 ? "verified" : "NOT verified", options.operation, totals.configurations,
                      totals.pairs);
  if (!options.certificate.empty()) text += fmt::format(", {} rules", totals.rules);
  for (const auto& [what, answers] : totals.answers) text += fmt::format(", {} answers of the table", answers.entries);
  text += fmt::format(", {} claims", totals.claims);
  return text + (totals.failed == 0 ? "\n" : fmt::format(" of which {} failed\n", totals.failed));
}

}  // namespace restrip::verify::operations
