#include "verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "family_check.hpp"
#include "input.hpp"
#include "linked_dump.hpp"
#include "linked_report.hpp"
#include "manifest.hpp"
#include "table_dump.hpp"

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

void check_manifest(const Options& options, const std::vector<ManifestLine>& manifest, const ClaimListener& listener) {
  const double start = thread_seconds();
  Failures failures;
  for (const std::string& fault : manifest_faults(options.tables_dir, manifest)) failures.add(fault);
  listener({"files", "the files are those of the MANIFEST", "SHA-256, sizes, no file unlisted", manifest.size(),
            thread_seconds() - start, failures.count, failures.first});
}

struct FamilyRows {
  std::string family;
  std::size_t rows;
};

/// The manifest's row counts, for the certificates that were read.
void check_row_counts(const Options& options, const std::vector<ManifestLine>& manifest,
                      const std::vector<FamilyRows>& found, const ClaimListener& listener) {
  Failures failures;
  for (const FamilyRows& certificate : found) {
    const std::string path = certificate_path(certificate.family);
    const auto line =
        std::find_if(manifest.begin(), manifest.end(), [&](const ManifestLine& entry) { return entry.path == path; });
    if (line == manifest.end())
      failures.add(fmt::format("{}/MANIFEST: {} is not listed", options.tables_dir, path));
    else if (line->rows != certificate.rows)
      failures.add(fmt::format("{}/MANIFEST:{}: {} rows listed, {} found", options.tables_dir, line->line, line->rows,
                               certificate.rows));
  }
  listener({"files", "the certificates have as many rows as listed", "counted", found.size(), 0, failures.count,
            failures.first});
}

/// A linked family that was chosen, with the rows of its local family.
struct LinkedInput {
  const LinkedFamily* family = nullptr;
  LinkedCertificate certificate;
  Certificate local;
};

/// Checks and reports it; returns for each section what a dump must say.
std::vector<std::vector<std::string>> check_linked_family(const LinkedInput& input, const ClaimListener& listener) {
  std::vector<LinkedCheck> checks;
  std::vector<std::vector<std::string>> dump;
  for (std::size_t i = 0; i < input.family->local.sections.size(); ++i) {
    const Section& section = input.family->local.sections[i];
    checks.push_back(check_linked({&section, &input.certificate.sections[i], &input.local.sections[i],
                                   input.certificate.file, input.local.file}));
    dump.push_back(dump_of(section, input.certificate.sections[i]));
  }
  report_linked(*input.family, checks, listener);
  return dump;
}

/// Runs the dump program, and makes a claim of each way in which its answers were compared.
void check_dump(const Options& options, const ExpectedDump& expected, const ClaimListener& listener, Totals& totals) {
  const double start = thread_seconds();
  const DumpComparison comparison = compare_dump_of(options.dump_command, expected);
  double seconds = thread_seconds() - start;
  const auto report = [&](const Compared& compared, const char* claim, const char* method) {
    // What was to be compared and was not, because the dump could not be read, does not hold.
    Failures failures = compared.differences;
    if (!comparison.fault.empty()) failures.add(comparison.fault);
    const Compared::Count sum = compared.sum();
    if (sum.entries == 0 && failures.count == 0) return;
    listener({"shipped headers", claim, fmt::format("{}, {} positions", method, sum.positions), sum.entries,
              std::exchange(seconds, 0), failures.count, failures.first});
  };
  report(comparison.of(Against::certificate), "in the certificates' positions they give its rules", "their dump");
  report(
      comparison.of(Against::own_patch),
      options.headers_only ? "every answer is sound and best" : "in all other positions every answer is sound and best",
      "all recolourings");
  report(comparison.of_lists(Against::certificate), "their lists of alternatives are the certificates'", "their dump");
  for (const Compared* compared : {&comparison.of(Against::certificate), &comparison.of(Against::own_patch)})
    for (const auto& [family, count] : compared->families) {
      if (compared->differences.count != 0 || !comparison.fault.empty()) continue;
      totals.answers[family].positions += count.positions;
      totals.answers[family].entries += count.entries;
    }
  for (const Compared* compared : {&comparison.of(Against::nothing), &comparison.of_lists(Against::nothing)})
    for (const auto& [family, count] : compared->families) {
      totals.not_compared[family].positions += count.positions;
      totals.not_compared[family].entries += count.entries;
    }
}

/// Runs the dump program of linked rules and claims that what it picks is the best.
void check_linked_picks(const Options& options, const ClaimListener& listener, Totals& totals) {
  const double start = thread_seconds();
  const LinkedDumpCheck check = check_linked_dump_of(options.linked_dump_command, options.max_k);
  Failures failures = check.wrong;
  if (!check.fault.empty()) failures.add(check.fault);
  if (!check.holds() && failures.count == 0) failures.add("nothing was picked");
  listener({"linked look-up", "the best for all that is known of the outside",
            fmt::format("{} configurations, {} positions", check.configurations, check.positions), check.leaves,
            thread_seconds() - start, failures.count, failures.first});
  if (check.holds()) totals.answers["linked look-up"] = {check.positions, check.leaves};
}

/// The tables of the shipped headers: what they must say when there is no certificate.
ExpectedDump expected_without_certificates(const std::vector<Family>& families, const std::vector<LinkedFamily>& linked,
                                           const Options& options) {
  ExpectedDump expected;
  for (const Family& family : families) {
    const Against against = chosen(family.name, options) ? Against::own_patch : Against::nothing;
    for (const Section& section : family.sections)
      for (const Operation& operation : section.operations) expected.tables.push_back({&operation, against, nullptr});
    for (const Operation& operation : family.unlisted) expected.tables.push_back({&operation, against, nullptr});
  }
  for (const LinkedFamily& family : linked)
    for (const Section& section : family.local.sections)
      expected.lists.push_back({family.name, section.position, section.ports, nullptr});
  return expected;
}

}  // namespace

Totals verify_tables(const Options& options, const ClaimListener& user_listener) {
  Totals totals;
  const ClaimListener listener = [&](const ClaimResult& result) {
    ++totals.claims;
    totals.failed += result.held() ? 0U : 1U;
    user_listener(result);
  };
  const std::vector<Family> all = all_families(options.max_k);
  const std::vector<LinkedFamily> all_linked = linked_families(options.max_k);
  const auto is_called = [](const std::string& name) {
    return [&](const auto& family) { return family.name == name; };
  };
  for (const std::string& name : options.families)
    if (std::none_of(all.begin(), all.end(), is_called(name)) &&
        std::none_of(all_linked.begin(), all_linked.end(), is_called(name)))
      throw InputError("--family", 0, fmt::format("there is no family \"{}\"", name));

  if (options.headers_only) {
    if (!options.dump_command.empty())
      check_dump(options, expected_without_certificates(all, all_linked, options), listener, totals);
    if (!options.linked_dump_command.empty()) check_linked_picks(options, listener, totals);
    return totals;
  }

  const std::vector<ManifestLine> manifest = read_manifest(options.tables_dir);
  check_manifest(options, manifest, listener);

  std::vector<const Family*> families;
  std::vector<Certificate> certificates;
  std::vector<FamilyRows> found;
  for (const Family& family : all) {
    if (!chosen(family.name, options)) continue;
    const CertificateFile file = certificate_of(options, family.name);
    families.push_back(&family);
    certificates.push_back(parse_certificate(file.path, file.text, family));
    found.push_back({family.name, certificates.back().rows});
    totals.rules += certificates.back().rows;
  }
  std::vector<LinkedInput> linked;
  for (const LinkedFamily& family : all_linked) {
    if (!chosen(family.name, options)) continue;
    const CertificateFile file = certificate_of(options, family.name);
    const CertificateFile local = certificate_of(options, family.local.name);
    linked.push_back({&family, parse_linked_certificate(file.path, file.text, family),
                      parse_certificate(local.path, local.text, family.local)});
    found.push_back({family.name, linked.back().certificate.rows});
    totals.alternatives += linked.back().certificate.rows;
  }
  check_row_counts(options, manifest, found, listener);

  std::vector<OperationTask> tasks;
  for (std::size_t i = 0; i < families.size(); ++i)
    for (std::size_t j = 0; j < families[i]->sections.size(); ++j)
      for (const Operation& operation : families[i]->sections[j].operations)
        tasks.push_back({&families[i]->sections[j], &certificates[i].sections[j], &operation, certificates[i].file});
  const auto progress = [&](std::size_t done) {
    if (options.show_progress)
      fmt::print(stderr, "\r{} of {} positions checked{}", done, tasks.size(), done == tasks.size() ? "\r\x1b[K" : "");
  };
  std::vector<OperationCheck> checks =
      check_operations(tasks, options.second_formulation, std::max(1U, options.threads), progress);

  auto first = checks.begin();
  for (std::size_t i = 0; i < families.size(); ++i) {
    std::vector<OperationCheck> own;
    for (const Section& section : families[i]->sections)
      for ([[maybe_unused]] const Operation& operation : section.operations) own.push_back(std::move(*first++));
    for (const OperationCheck& check : own) {
      totals.configurations += check.judgment.valid;
      totals.pairs += check.judgment.pairs;
    }
    report_family(*families[i], certificates[i], own, options.second_formulation, listener);
    std::move(own.begin(), own.end(), first - static_cast<std::ptrdiff_t>(own.size()));
  }
  std::map<const Section*, std::vector<std::string>> lists;
  for (const LinkedInput& input : linked) {
    std::vector<std::vector<std::string>> dump = check_linked_family(input, listener);
    for (std::size_t i = 0; i < dump.size(); ++i) lists[&input.family->local.sections[i]] = std::move(dump[i]);
  }
  if (!options.linked_dump_command.empty()) check_linked_picks(options, listener, totals);
  if (options.dump_command.empty()) return totals;
  ExpectedDump expected = expected_without_certificates(all, all_linked, options);
  for (ExpectedTable& table : expected.tables)
    for (std::size_t i = 0; i < tasks.size(); ++i)
      if (tasks[i].operation == table.operation)
        table = {table.operation, Against::certificate, &checks[i].judgment.answers};
  auto list = expected.lists.begin();
  for (const LinkedFamily& family : all_linked)
    for (const Section& section : family.local.sections) {
      if (lists.contains(&section)) list->lines = &lists.at(&section);
      ++list;
    }
  check_dump(options, expected, listener, totals);
  return totals;
}

}  // namespace restrip::verify
