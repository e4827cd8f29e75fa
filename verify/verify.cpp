#include "verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "certificate/manifest.hpp"
#include "common/counted.hpp"
#include "judge/family_report.hpp"
#include "judge/index_cost.hpp"
#include "judge/operation_header.hpp"
#include "judge/report.hpp"
#include "judge/table_dump.hpp"
#include "model/input.hpp"

namespace restrip::verify {
namespace {

/// Verifies the shipped families, or the families of an operation file.
class Verification {
 public:
  Verification(const Options& options, const ClaimListener& listener)
      : options_(options), listener_([this, &listener](const ClaimResult& result) {
          ++totals_.claims;
          totals_.failed += result.held() ? 0U : 1U;
          listener(result);
        }) {}

  Totals tables() {
    totals_.max_k = options_.max_k;
    families_ = all_families(options_.max_k);
    for (const std::string& name : options_.families) {
      const auto family =
          std::find_if(families_.begin(), families_.end(), [&](const Family& one) { return one.name == name; });
      if (family == families_.end()) throw InputError("--family", 0, fmt::format("unknown family \"{}\"", name));
      if (!family->has_table && options_.dump_command.empty())
        throw InputError(
            "--family", 0,
            fmt::format("\"{}\" has no certificate, because the automaton answers it; give --dump-command, "
                        "or verify a table of your own with --operation",
                        name));
    }
    if (!options_.headers_only) {
      check_manifest();
      for (const Family& family : families_)
        if (family.has_table && chosen(family.name)) read_rules(family, shipped(family.name));
      totals_.read.certificates = true;
      check_families();
    }
    if (options_.dump_command.empty()) return totals_;
    ExpectedDump expected = expected_dump();
    expected.with_digests = !options_.digest_commands.empty();
    const Digests digests =
        check_dump("shipped headers", "their dump", [&] { return compare_dump_of(options_.dump_command, expected); });
    totals_.read.of_headers.emplace_back("compiled tables");
    for (const std::string& command : options_.digest_commands) {  // look-ups in other languages
      const double start = thread_seconds();
      const DigestComparison found = compare_digests_of(command, digests);
      Failures failures = found.differences;
      if (!found.fault.empty()) failures.add(fmt::format("{}: {}", command, found.fault));
      if (found.positions == 0 && failures.count == 0) failures.add("nothing was compared");
      listener_({"other languages", "the answers equal the headers' answers", "digests, " + command, found.positions,
                 thread_seconds() - start, failures});
    }
    if (expected.with_digests) totals_.read.of_headers.emplace_back("digests of other languages");
    return totals_;
  }

  Totals operation() {
    const std::vector<Description> descriptions = parse_descriptions(options_.operation, options_.operation_text);
    families_ = families_of(descriptions, options_.max_k);
    if (families_.size() != 1)
      throw InputError(
          options_.operation, 0,
          fmt::format("describes operations of {} certificates; verify a file of one at a time", families_.size()));
    const Family& family = families_.front();
    if (!options_.header.empty() && descriptions.size() != 1)
      throw InputError("--header", 0,
                       "a header has the table of one operation or family, and this file describes more");
    if (!options_.certificate.empty()) read_rules(family, options_.certificate);
    totals_.read.certificates = !options_.certificate.empty();
    check_families();
    ExpectedDump expected = expected_dump();
    expected.states_isolated = false;
    const bool is_table = options_.header.empty() || check_header(descriptions.front(), expected);
    if (options_.dump_command.empty()) return totals_;
    totals_.read.of_headers.emplace_back("compiled tables");
    totals_.answers.clear();  // the same answers as in the header's text
    totals_.not_compared.clear();
    check_dump(family.name, "its dump", [&] {
      if (is_table) return compare_dump_of(options_.dump_command, expected);
      DumpComparison not_run;
      not_run.fault = "was not run, because the header is not the text of a table";
      return not_run;
    });
    return totals_;
  }

 private:
  bool chosen(const std::string& certificate) const {
    return options_.families.empty() ||
           std::find(options_.families.begin(), options_.families.end(), certificate) != options_.families.end();
  }
  bool judged(const Family& family) const {
    return chosen(family.name) && (family.has_table || !options_.operation.empty());
  }
  std::string shipped(const std::string& certificate) const {
    return fmt::format("{}/certificates/{}.cert", options_.tables_dir, certificate);
  }

  void check_manifest() const {
    const double start = thread_seconds();
    const std::string file = options_.tables_dir + "/MANIFEST";
    const std::string text = [&file] {
      try {
        return read_file(file);
      } catch (const files::FileError& fault) {
        throw files::FileError(
            fmt::format("{}. Without it the tables are incomplete; generate them again", fault.what()));
      }
    }();
    const std::vector<ManifestLine> manifest = parse_manifest(file, text);
    const auto report = [&](const char* claim, const char* method, const std::vector<std::string>& faults,
                            double seconds) {
      Failures failures;
      for (const std::string& fault : faults) failures.add(fault);
      listener_({"files", claim, method, manifest.size(), seconds, failures});
    };
    const std::vector<std::string> faults = manifest_faults(options_.tables_dir, manifest);
    report("the files match the MANIFEST", "SHA-256, sizes, no file unlisted", faults, thread_seconds() - start);
    report("the files have the listed numbers of rows", "counted", row_faults(options_.tables_dir, manifest), 0);
  }

  void read_rules(const Family& family, const std::string& file) {
    const Certificate& read = rules_[&family] = parse_certificate(file, read_file(file), family);
    totals_.rules += read.rows;
  }

  /// Null if no certificate was read.
  const Certificate* rules_of(const Family& family) const {
    const auto found = rules_.find(&family);
    return found == rules_.end() ? nullptr : &found->second;
  }

  /// Checks the chosen families. Without a certificate the configurations of a custom operation are counted.
  void check_families() {
    std::vector<PositionTask> tasks;
    for (const Family& family : families_)
      if (judged(family))
        for (const PositionTask& task : tasks_of(family, rules_of(family))) tasks.push_back(task);
    const std::vector<PositionCheck> checks = check_positions(tasks, std::max(1U, options_.threads));
    for (const PositionCheck& check : checks) {
      totals_.configurations += check.valid;
      totals_.graphs += check.graphs;
    }
    std::span<const PositionCheck> rest = checks;
    for (const Family& family : families_) {
      if (!judged(family)) continue;
      const std::size_t count = tasks_of(family, nullptr).size();
      if (const Certificate* rules = rules_of(family)) {
        report_family(family, *rules, rest.first(count), listener_);
        report_index_cost(family, *rules, std::max(1U, options_.threads), listener_);
        report_images(family, listener_);
      }
      rest = rest.subspan(count);
    }
  }

  /// The expected answers of the tables: the rows of the certificates that were read; otherwise the best
  /// answers, if chosen and searchable.
  ExpectedDump expected_dump() const {
    ExpectedDump expected;
    for (const Family& family : families_) {
      const Certificate* const rules = rules_of(family);
      const auto expect = [&](const Operation& operation, const SectionRows* rows) {
        const Against otherwise = chosen(family.name) && searched(operation) ? Against::own_patch : Against::nothing;
        expected.tables.push_back(
            {&operation, rows != nullptr ? Against::certificate : otherwise, rows, family.has_table});
      };
      for (std::size_t i = 0; i < family.sections.size(); ++i)
        for (const Operation& operation : family.sections[i].operations)
          expect(operation, rules == nullptr ? nullptr : &rules->sections[i]);
      for (const Operation& operation : family.unlisted) expect(operation, nullptr);
    }
    return expected;
  }

  /// Reports a claim for each way in which the answers of a dump program were compared; returns their digests.
  template <class Compare>
  Digests check_dump(const std::string& subject, const std::string& how_read, const Compare& compare) {
    const double start = thread_seconds();
    const DumpComparison comparison = compare();
    double seconds = thread_seconds() - start;
    const Compared& listed = comparison.of(Against::certificate);
    const Compared& unlisted = comparison.of(Against::own_patch);
    const auto report = [&](const AnswerCount& count, Failures failures, const char* claim, const char* method) {
      // A planned comparison fails if the dump could not be read.
      if (!comparison.fault.empty()) failures.add(comparison.fault);
      if (count.entries == 0 && failures.count == 0) return;
      listener_({subject, claim, fmt::format("{}, {}", method, counted(count.positions, "position")), count.entries,
                 std::exchange(seconds, 0), failures});
    };
    Failures differences = listed.differences;
    differences.add(listed.wrong);
    report(sum_of(listed.families), differences, "every answer is the certificate's row, in its positions",
           how_read.c_str());
    report(sum_of(unlisted.families), unlisted.wrong, "every answer is sound and best, in other positions",
           "definition");
    AnswerCount judged = sum_of(listed.families);
    judged += sum_of(unlisted.families);
    if (comparison.states_changes)
      report(judged, comparison.misstated, "every answer reports what it changes", "counted before and after");
    report(comparison.bounded, comparison.beyond, "no answer exceeds what the family claims", "maximum");
    for (const Compared* compared : {&listed, &unlisted})
      for (const auto& [family, count] : compared->families)
        if (compared->differences.count + compared->wrong.count == 0 && comparison.fault.empty())
          totals_.answers[family] += count;
    for (const auto& [family, count] : comparison.of(Against::nothing).families) totals_.not_compared[family] += count;
    return comparison.digests;
  }

  /// Checks the header of an operation, and judges the table in its text. Code in the header would be executed together
  /// with the dump program; returns false if it may contain any.
  bool check_header(const Description& description, const ExpectedDump& expected) {
    const double start = thread_seconds();
    const HeaderCheck header =
        check_operation_header(options_.header, read_file(options_.header), description, options_.max_k);
    listener_({description.name, "the header is exactly the text of a table", "line by line, all but its entries",
               header.lines, thread_seconds() - start, header.wrong});
    totals_.read.of_headers.emplace_back("header texts");
    if (header.wrong.count != 0) return false;
    check_dump(description.name, "the header's text", [&] { return compare_header(header, expected); });
    return true;
  }

  const Options& options_;
  Totals totals_;
  ClaimListener listener_;  ///< counts claims and passes them on
  std::vector<Family> families_;
  std::map<const Family*, Certificate> rules_;
};

}  // namespace

Totals verify_tables(const Options& options, const ClaimListener& listener) {
  return Verification(options, listener).tables();
}

Totals verify_operation(const Options& options, const ClaimListener& listener) {
  return Verification(options, listener).operation();
}

bool has_family(const Options& options) {
  const std::vector<Description> descriptions = parse_descriptions(options.operation, options.operation_text);
  return std::any_of(descriptions.begin(), descriptions.end(),
                     [](const Description& one) { return !one.numbers.empty(); });
}

std::string last_line_of(const Options& options, const Totals& totals) {
  std::string text =
      fmt::format("{}: {}: {}, {} judged", totals.failed == 0 ? "verified" : "NOT verified", options.operation,
                  counted(totals.configurations, "configuration"), counted(totals.graphs, "graph"));
  if (!options.certificate.empty()) text += ", " + counted(totals.rules, "rule");
  const std::uint64_t answers = sum_of(totals.answers).entries;
  if (answers != 0) text += fmt::format(", {} of the table", counted(answers, "answer"));
  const std::uint64_t more = sum_of(totals.not_compared).entries;
  if (more != 0) text += fmt::format(", {} more NOT compared", more);
  text += ", " + counted(totals.claims, "claim");
  if (totals.failed != 0) text += fmt::format(" of which {} failed", totals.failed);
  return text + fmt::format("; read: {}\n", text_of(totals.read));
}

}  // namespace restrip::verify
