#include "verify_operation.hpp"

#include <fmt/format.h>

#include <ctime>
#include <optional>
#include <utility>

#include "certificate_judge.hpp"
#include "input.hpp"
#include "operation_dump.hpp"
#include "operation_header.hpp"
#include "quantity.hpp"
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
               quantity(tested, "colouring") + " as graphs in worlds", keys.valid, keys.wrong);
  report.claim("sound by the worlds when it joins only pairs of J", quantity(judge.shortcuts(), "pair") + " of classes",
               judge.pairs(), {judge.wrong_shortcuts(), judge.wrong_shortcut()});
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
                 reasons.reasons == 0
                     ? "the certificate gives none"
                     : fmt::format("sets by the worlds, {} at most", quantity(reasons.most_cases, "case")),
                 reasons.reasons, reasons.wrong);
  }
  const PatchSymmetries symmetries(judge.operation());
  report.claim(
      "copies follow from rules by symmetry",
      fmt::format("{:.0f} {} by backtracking", symmetries.order(), symmetries.order() == 1 ? "symmetry" : "symmetries"),
      certificate.rows.size(), wrong_copies(certificate, symmetries));
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
  OperationReport report(operation, listener, totals);
  RuleJudge judge(operation);
  const std::uint64_t keys = report_keys(judge, report, totals);
  if (certificate) {
    totals.rules = certificate->rows.size();
    report_certificate(judge, *certificate, keys, report);
  }
  // Who compiled the header runs what it says: code in it would be run here with the dump.
  bool is_table = true;
  if (!options.header.empty()) {
    const HeaderCheck header = check_operation_header(options.header, read_file(options.header), operation);
    is_table = header.wrong.count == 0;
    report.claim("the header is the text of a table and nothing else", "line by line, all but its numbers",
                 header.lines, header.wrong);
  }
  if (!options.dump_command.empty()) {
    OperationDumpCheck dump;
    if (is_table)
      dump = check_operation_dump_of(options.dump_command, judge, certificate ? &*certificate : nullptr);
    else
      dump.fault = "was not run, because the header is not that of a table";
    report_dump(dump, certificate.has_value(), report, totals);
  }
  return totals;
}

std::string last_line_of(const OperationOptions& options, const Totals& totals) {
  std::string text = fmt::format("{}: {}: {}, {} of {}", totals.failed == 0 ? "verified" : "NOT verified",
                                 options.operation, quantity(totals.configurations, "configuration"),
                                 quantity(totals.pairs, "recolouring"), totals.configurations == 1 ? "it" : "them");
  if (!options.certificate.empty()) text += ", " + quantity(totals.rules, "rule");
  for (const auto& [what, answers] : totals.answers)
    text += fmt::format(", {} of the table", quantity(answers.entries, "answer"));
  text += ", " + quantity(totals.claims, "claim");
  return text + (totals.failed == 0 ? "\n" : fmt::format(" of which {} failed\n", totals.failed));
}

}  // namespace restrip::verify::operations
