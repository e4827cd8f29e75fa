#include "verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "certificate/manifest.hpp"
#include "judge/family_report.hpp"
#include "judge/operation_header.hpp"
#include "judge/table_dump.hpp"
#include "linked/linked_dump.hpp"
#include "linked/linked_report.hpp"
#include "model/input.hpp"
#include "model/quantity.hpp"

namespace restrip::verify {
namespace {

std::string certificate_path(const std::string& family) { return "certificates/" + family + ".cert"; }

bool chosen(const std::string& family, const Options& options) {
  return options.families.empty() ||
         std::find(options.families.begin(), options.families.end(), family) != options.families.end();
}

/// The text of a family's certificate, with the name of its file.
struct CertificateFile {
  std::string path;
  std::string text;
};

CertificateFile certificate_of(const Options& options, const std::string& family) {
  const std::string path = options.tables_dir + "/" + certificate_path(family);
  return {path, read_file(path)};
}

void check_manifest(const Options& options, const ClaimListener& listener) {
  const double start = thread_seconds();
  const std::vector<ManifestLine> manifest = read_manifest(options.tables_dir);
  const auto report = [&](const char* claim, const char* method, const std::vector<std::string>& faults,
                          double seconds) {
    Failures failures;
    for (const std::string& fault : faults) failures.add(fault);
    listener({"files", claim, method, manifest.size(), seconds, failures.count, failures.first});
  };
  const std::vector<std::string> faults = manifest_faults(options.tables_dir, manifest);
  report("the files are those of the MANIFEST", "SHA-256, sizes, no file unlisted", faults, thread_seconds() - start);
  report("the files have as many rows as listed", "counted", row_faults(options.tables_dir, manifest), 0);
}

/// A linked family that was chosen, with the rows of its local family.
struct LinkedInput {
  const LinkedFamily* family = nullptr;
  LinkedCertificate certificate;
  Certificate local;
};

/// How many ports a pairing has in tables up to this k (docs/certificate.md, "Table dump").
unsigned pairing_places(unsigned max_k) { return max_k <= 8 ? 8 : 16; }

/// Checks and reports it; returns for each section what a dump must say.
std::vector<std::vector<std::string>> check_linked_family(const LinkedInput& input, unsigned max_k,
                                                          const ClaimListener& listener) {
  LinkedCheck check;
  std::vector<std::vector<std::string>> dump;
  for (std::size_t i = 0; i < input.family->local.sections.size(); ++i) {
    const Section& section = input.family->local.sections[i];
    check_linked(
        {&section, &input.certificate.sections[i], &input.local.sections[i], input.certificate.file, input.local.file},
        check);
    dump.push_back(dump_of(section, input.certificate.sections[i], pairing_places(max_k)));
  }
  report_linked(*input.family, check, listener);
  return dump;
}

/// Makes a claim of each way in which the answers of a dump program were compared.
template <class Compare>
void check_dump(const std::string& subject, const std::string& how_read, const Compare& compare,
                const ClaimListener& listener, Totals& totals) {
  const double start = thread_seconds();
  const DumpComparison comparison = compare();
  double seconds = thread_seconds() - start;
  const Compared& listed = comparison.of(Against::certificate);
  const Compared& unlisted = comparison.of(Against::own_patch);
  const auto report = [&](const AnswerCount& count, Failures failures, const char* claim, const char* method) {
    // What was to be compared and was not, because the dump could not be read, does not hold.
    if (!comparison.fault.empty()) failures.add(comparison.fault);
    if (count.entries == 0 && failures.count == 0) return;
    listener({subject, claim, fmt::format("{}, {}", method, quantity(count.positions, "position")), count.entries,
              std::exchange(seconds, 0), failures.count, failures.first});
  };
  AnswerCount judged = sum_of(listed.families);
  report(judged, listed.differences, "every answer is the certificate's row, in its positions", how_read.c_str());
  judged += sum_of(unlisted.families);
  Failures wrong = listed.wrong;
  wrong.add(unlisted.wrong);
  report(judged, wrong, "every answer is sound and best", "worlds, all recolourings");
  if (comparison.tells_changes) {
    Failures told = listed.told;
    told.add(unlisted.told);
    report(judged, told, "every answer tells what it changes", "counted before and after");
  }
  const Compared& lists = comparison.of_lists(Against::certificate);
  report(sum_of(lists.families), lists.differences, "their lists of alternatives are the certificates'",
         how_read.c_str());
  for (const Compared* compared : {&listed, &unlisted})
    for (const auto& [family, count] : compared->families)
      if (compared->differences.count + compared->wrong.count == 0 && comparison.fault.empty())
        totals.answers[family] += count;
  for (const Compared* compared : {&comparison.of(Against::nothing), &comparison.of_lists(Against::nothing)})
    for (const auto& [family, count] : compared->families) totals.not_compared[family] += count;
}

/// Compares digests of the answers of another look-up with those of the answers that were judged.
void check_digests(const std::string& command, const AnswerDigests& digests, const ClaimListener& listener) {
  const double start = thread_seconds();
  const DigestComparison found = compare_digests_of(command, digests.by_position());
  Failures failures = found.differences;
  if (!found.fault.empty()) failures.add(fmt::format("{}: {}", command, found.fault));
  if (found.positions == 0 && failures.count == 0) failures.add("nothing was compared");
  listener({"other languages", "the answers are those of the headers", "digests, " + command, found.positions,
            thread_seconds() - start, failures.count, failures.first});
}

/// Reads the header of an operation, and judges the table that its text says. Whoever compiled the header runs what it
/// says, so code in it would be run with the dump; false when there may be any.
bool check_header(const OperationOptions& options, const Description& description, const ExpectedDump& expected,
                  const ClaimListener& listener, Totals& totals) {
  const double start = thread_seconds();
  const HeaderCheck header =
      check_operation_header(options.header, read_file(options.header), description, options.max_k);
  listener({description.name, "the header is the text of a table and nothing else", "line by line, all but its entries",
            header.lines, thread_seconds() - start, header.wrong.count, header.wrong.first});
  totals.read.of_headers.emplace_back("header texts");
  if (header.wrong.count != 0) return false;
  check_dump(
      description.name, "the header's text", [&] { return compare_header(header, expected); }, listener, totals);
  return true;
}

/// Runs the dump program of linked rules and claims that what it picks is the best.
void check_linked_picks(const Options& options, const ClaimListener& listener, Totals& totals) {
  const double start = thread_seconds();
  const LinkedDumpCheck check = check_linked_dump_of(options.linked_dump_command, options.max_k);
  Failures failures = check.wrong;
  if (!check.fault.empty()) failures.add(check.fault);
  if (!check.holds() && failures.count == 0) failures.add("nothing was picked");
  listener(
      {"linked look-up", "the best for all that is known of the outside",
       fmt::format("{}, {}", quantity(check.configurations, "configuration"), quantity(check.positions, "position")),
       check.leaves, thread_seconds() - start, failures.count, failures.first});
  if (check.holds()) totals.answers["linked look-up"] = {check.positions, check.leaves};
}

void expect_judged(const Operation& operation, Against against, ExpectedDump& expected) {
  expected.tables.push_back({&operation, searched(operation) ? against : Against::nothing, nullptr});
}

/// The tables of the shipped headers: what they must say when there is no certificate.
ExpectedDump expected_without_certificates(const std::vector<Family>& families, const std::vector<LinkedFamily>& linked,
                                           const Options& options) {
  ExpectedDump expected;
  for (const Family& family : families) {
    const Against against = chosen(family.name, options) ? Against::own_patch : Against::nothing;
    for (const Section& section : family.sections)
      for (const Operation& operation : section.operations) expect_judged(operation, against, expected);
    for (const Operation& operation : family.unlisted) expect_judged(operation, against, expected);
  }
  for (const LinkedFamily& family : linked)
    for (const Section& section : family.local.sections)
      expected.lists.push_back({family.name, section.position, section.ports, nullptr});
  return expected;
}

void refuse_unknown_families(const Options& options, const std::vector<Family>& all,
                             const std::vector<LinkedFamily>& all_linked) {
  for (const std::string& name : options.families) {
    const auto is_called = [&](const auto& family) { return family.name == name; };
    if (std::none_of(all.begin(), all.end(), is_called) &&
        std::none_of(all_linked.begin(), all_linked.end(), is_called))
      throw InputError("--family", 0, fmt::format("there is no family \"{}\"", name));
  }
}

/// The certificates that were chosen.
struct Certificates {
  std::vector<const Family*> families;
  std::vector<Certificate> rules;  ///< one for each of them
  std::vector<LinkedInput> linked;
};

Certificates read_certificates(const Options& options, const std::vector<Family>& all,
                               const std::vector<LinkedFamily>& all_linked, Totals& totals) {
  Certificates read;
  for (const Family& family : all) {
    if (!chosen(family.name, options)) continue;
    const CertificateFile file = certificate_of(options, family.name);
    read.families.push_back(&family);
    read.rules.push_back(parse_certificate(file.path, file.text, family));
    totals.rules += read.rules.back().rows;
  }
  for (const LinkedFamily& family : all_linked) {
    if (!chosen(family.name, options)) continue;
    const CertificateFile file = certificate_of(options, family.name);
    const CertificateFile local = certificate_of(options, family.local.name);
    read.linked.push_back({&family, parse_linked_certificate(file.path, file.text, family),
                           parse_certificate(local.path, local.text, family.local)});
    totals.alternatives += read.linked.back().certificate.rows;
  }
  return read;
}

/// Checks the families, each with its certificate or with none.
void check_families(const std::vector<const Family*>& families, const std::vector<Certificate>& certificates,
                    bool second_formulation, unsigned threads, bool show_progress, const ClaimListener& listener,
                    Totals& totals) {
  const auto certificate_of_family = [&](std::size_t i) { return certificates.empty() ? nullptr : &certificates[i]; };
  std::vector<PositionTask> tasks;
  for (std::size_t i = 0; i < families.size(); ++i)
    for (const PositionTask& task : tasks_of(*families[i], certificate_of_family(i))) tasks.push_back(task);
  const std::size_t all = tasks.size();
  const auto progress = [&](std::size_t n) {
    if (show_progress) fmt::print(stderr, "\r{} of {} positions checked{}", n, all, n == all ? "\r\x1b[K" : "");
  };
  const std::vector<PositionCheck> checks = check_positions(tasks, second_formulation, std::max(1U, threads), progress);
  for (const PositionCheck& check : checks) {
    totals.configurations += check.valid;
    totals.pairs += check.pairs;
  }
  std::span<const PositionCheck> rest = checks;
  for (std::size_t i = 0; i < families.size(); ++i) {
    const std::size_t count = tasks_of(*families[i], nullptr).size();
    report_family(*families[i], certificate_of_family(i), rest.first(count), second_formulation, listener);
    rest = rest.subspan(count);
  }
}

/// What a dump must say of each section of the linked families that were checked.
using LinesOfSections = std::map<const Section*, std::vector<std::string>>;

LinesOfSections check_linked_families(const Certificates& read, unsigned max_k, const ClaimListener& listener) {
  LinesOfSections lines;
  for (const LinkedInput& input : read.linked) {
    std::vector<std::vector<std::string>> dump = check_linked_family(input, max_k, listener);
    for (std::size_t i = 0; i < dump.size(); ++i) lines[&input.family->local.sections[i]] = std::move(dump[i]);
  }
  return lines;
}

/// From now on the tables must answer with the certificate's rows, wherever there are any.
void expect_rows(ExpectedDump& expected, const Family& family, const Certificate& certificate) {
  for (const PositionTask& task : tasks_of(family, &certificate))
    for (ExpectedTable& table : expected.tables)
      if (table.operation == task.operation) table = {task.operation, Against::certificate, task.rows};
}

/// And with its lists.
void expect_lists(ExpectedDump& expected, const std::vector<LinkedFamily>& all_linked, const LinesOfSections& lines) {
  auto list = expected.lists.begin();
  for (const LinkedFamily& family : all_linked)
    for (const Section& section : family.local.sections) {
      if (lines.contains(&section)) list->lines = &lines.at(&section);
      ++list;
    }
}

/// The listener that counts what it hands on.
ClaimListener counting(Totals& totals, const ClaimListener& listener) {
  return [&totals, &listener](const ClaimResult& result) {
    ++totals.claims;
    totals.failed += result.held() ? 0U : 1U;
    listener(result);
  };
}

}  // namespace

Totals verify_tables(const Options& options, const ClaimListener& user_listener) {
  Totals totals;
  totals.max_k = options.max_k;
  const ClaimListener listener = counting(totals, user_listener);
  const std::vector<Family> all = all_families(options.max_k);
  const std::vector<LinkedFamily> all_linked = linked_families(options.max_k);
  refuse_unknown_families(options, all, all_linked);
  ExpectedDump expected = expected_without_certificates(all, all_linked, options);
  Certificates read;
  LinesOfSections lines;
  if (!options.headers_only) {
    check_manifest(options, listener);
    read = read_certificates(options, all, all_linked, totals);
    check_families(read.families, read.rules, options.second_formulation, options.threads, options.show_progress,
                   listener, totals);
    lines = check_linked_families(read, options.max_k, listener);
    totals.read.certificates = true;
    for (std::size_t i = 0; i < read.families.size(); ++i) expect_rows(expected, *read.families[i], read.rules[i]);
    expect_lists(expected, all_linked, lines);
  }
  if (!options.linked_dump_command.empty()) {
    check_linked_picks(options, listener, totals);
    totals.read.of_headers.emplace_back("compiled linked look-up");
  }
  if (!options.dump_command.empty()) {
    expected.with_digests = !options.digest_commands.empty();
    AnswerDigests digests;
    const auto compare = [&] {
      DumpComparison comparison = compare_dump_of(options.dump_command, expected);
      digests = comparison.digests;
      return comparison;
    };
    check_dump("shipped headers", "their dump", compare, listener, totals);
    totals.read.of_headers.emplace_back("compiled tables");
    for (const std::string& command : options.digest_commands) check_digests(command, digests, listener);
    if (expected.with_digests) totals.read.of_headers.emplace_back("digests of other languages");
  }
  return totals;
}

Totals verify_operation(const OperationOptions& options, const ClaimListener& user_listener) {
  Totals totals;
  const ClaimListener listener = counting(totals, user_listener);
  const std::vector<Description> descriptions = parse_descriptions(options.operation, read_file(options.operation));
  const std::vector<Family> families = families_of(descriptions, options.max_k);
  if (families.size() != 1)
    throw InputError(options.operation, 0,
                     fmt::format("expected the operations of one certificate, found those of {}", families.size()));
  const Family& family = families.front();
  for (const Section& section : family.sections)
    for (const Operation& operation : section.operations)
      totals.graph_only = totals.graph_only || !operation.on_a_mesh();
  if (!options.header.empty() && descriptions.size() != 1)
    throw InputError("--header", 0, "a header has the table of one operation or family, and this file describes more");
  std::vector<Certificate> certificates;
  if (!options.certificate.empty()) {
    certificates.push_back(parse_certificate(options.certificate, read_file(options.certificate), family));
    totals.rules = certificates.front().rows;
  }
  check_families({&family}, certificates, options.second_formulation, options.threads, false, listener, totals);
  const LinkedFamily linked{"linked-" + family.name, family};
  std::vector<std::vector<std::string>> lines(family.sections.size());
  const bool with_lists = !options.linked_certificate.empty();
  if (with_lists) {
    if (certificates.empty())
      throw InputError(options.linked_certificate, 0, "expected a certificate of rules beside it");
    const LinkedInput input{
        &linked, parse_linked_certificate(options.linked_certificate, read_file(options.linked_certificate), linked),
        certificates.front()};
    totals.alternatives = input.certificate.rows;
    lines = check_linked_family(input, options.max_k, listener);
  }
  totals.read.certificates = !options.certificate.empty();
  ExpectedDump expected;
  expected.tells_isolated = false;
  for (const Section& section : family.sections)
    for (const Operation& operation : section.operations) expect_judged(operation, Against::own_patch, expected);
  for (const Operation& operation : family.unlisted) expect_judged(operation, Against::own_patch, expected);
  if (!certificates.empty()) expect_rows(expected, family, certificates.front());
  const bool is_table =
      options.header.empty() || check_header(options, descriptions.front(), expected, listener, totals);
  if (options.dump_command.empty()) return totals;
  totals.read.of_headers.emplace_back("compiled tables");
  totals.answers.clear();  // those of the header's text are the same
  totals.not_compared.clear();
  const auto is_linked = [](const Description& one) { return one.linked; };
  if (options.header.empty() && std::any_of(descriptions.begin(), descriptions.end(), is_linked))
    for (std::size_t i = 0; i < family.sections.size(); ++i)
      expected.lists.push_back(
          {linked.name, family.sections[i].position, family.sections[i].ports, with_lists ? &lines[i] : nullptr});
  const auto compare = [&] {
    if (is_table) return compare_dump_of(options.dump_command, expected);
    DumpComparison not_run;
    not_run.fault = "was not run, because the header is not that of a table";
    return not_run;
  };
  check_dump(family.name, "its dump", compare, listener, totals);
  return totals;
}

bool has_family(const std::string& operation_file) {
  const std::vector<Description> descriptions = parse_descriptions(operation_file, read_file(operation_file));
  return std::any_of(descriptions.begin(), descriptions.end(),
                     [](const Description& one) { return !one.numbers.empty(); });
}

std::string last_line_of(const OperationOptions& options, const Totals& totals) {
  std::string text = totals.graph_only ? "graph only: not checked to be an operation on a mesh\n" : "";
  text += fmt::format("{}: {}: {}, {} of {}", totals.failed == 0 ? "verified" : "NOT verified", options.operation,
                      quantity(totals.configurations, "configuration"), quantity(totals.pairs, "recolouring"),
                      totals.configurations == 1 ? "it" : "them");
  if (!options.certificate.empty()) text += ", " + quantity(totals.rules, "rule");
  if (!options.linked_certificate.empty()) text += ", " + quantity(totals.alternatives, "alternative");
  const std::uint64_t answers = sum_of(totals.answers).entries;
  if (answers != 0) text += fmt::format(", {} of the table", quantity(answers, "answer"));
  const std::uint64_t more = sum_of(totals.not_compared).entries;
  if (more != 0) text += fmt::format(", {} more NOT compared", more);
  text += ", " + quantity(totals.claims, "claim");
  if (totals.failed != 0) text += fmt::format(" of which {} failed", totals.failed);
  return text + fmt::format("; read: {}\n", text_of(totals.read));
}

}  // namespace restrip::verify
