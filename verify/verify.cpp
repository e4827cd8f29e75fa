#include "verify.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "family_check.hpp"
#include "input.hpp"
#include "manifest.hpp"
#include "table_dump.hpp"

namespace restrip::verify {
namespace {

std::string certificate_path(const Family& family) { return "certificates/" + family.name + ".cert"; }

bool chosen(const Family& family, const Options& options) {
  return options.families.empty() ||
         std::find(options.families.begin(), options.families.end(), family.name) != options.families.end();
}

void check_manifest(const Options& options, const std::vector<ManifestLine>& manifest, const ClaimListener& listener) {
  const double start = thread_seconds();
  Failures failures;
  for (const std::string& fault : manifest_faults(options.tables_dir, manifest)) failures.add(fault);
  listener({"files", "the files are those of the MANIFEST", "SHA-256, sizes, no file unlisted", manifest.size(),
            thread_seconds() - start, failures.count, failures.first});
}

/// The manifest's row counts, for the certificates that were read.
void check_row_counts(const Options& options, const std::vector<ManifestLine>& manifest,
                      const std::vector<Certificate>& certificates, const std::vector<const Family*>& families,
                      const ClaimListener& listener) {
  Failures failures;
  for (std::size_t i = 0; i < families.size(); ++i) {
    const std::string path = certificate_path(*families[i]);
    const auto line =
        std::find_if(manifest.begin(), manifest.end(), [&](const ManifestLine& entry) { return entry.path == path; });
    if (line == manifest.end())
      failures.add(fmt::format("{}/MANIFEST: {} is not listed", options.tables_dir, path));
    else if (line->rows != certificates[i].rows)
      failures.add(fmt::format("{}/MANIFEST:{}: {} rows listed, {} found", options.tables_dir, line->line, line->rows,
                               certificates[i].rows));
  }
  listener({"files", "the certificates have as many rows as listed", "counted", families.size(), 0, failures.count,
            failures.first});
}

void check_dump(const Options& options, const std::vector<ExpectedTable>& expected, const ClaimListener& listener) {
  const double start = thread_seconds();
  const DumpComparison comparison = compare_dump_of(options.dump_command, expected);
  listener({"compiled tables", "they are the certificates", "their dump, every configuration", comparison.lines,
            thread_seconds() - start, comparison.difference.empty() ? 0U : 1U, comparison.difference});
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
  for (const std::string& name : options.families)
    if (std::none_of(all.begin(), all.end(), [&](const Family& family) { return family.name == name; }))
      throw InputError("--family", 0, fmt::format("there is no family \"{}\"", name));

  const std::vector<ManifestLine> manifest = read_manifest(options.tables_dir);
  check_manifest(options, manifest, listener);

  std::vector<const Family*> families;
  std::vector<Certificate> certificates;
  for (const Family& family : all) {
    if (!chosen(family, options)) continue;
    const std::string file = options.tables_dir + "/" + certificate_path(family);
    families.push_back(&family);
    certificates.push_back(parse_certificate(file, read_file(file), family));
    totals.rules += certificates.back().rows;
  }
  check_row_counts(options, manifest, certificates, families, listener);

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

  std::vector<ExpectedTable> expected;
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
  if (options.dump_command.empty()) return totals;
  for (const Family& family : all)
    for (const Section& section : family.sections)
      for (const Operation& operation : section.operations) expected.push_back({&operation, nullptr});
  for (ExpectedTable& table : expected)
    for (std::size_t i = 0; i < tasks.size(); ++i)
      if (tasks[i].operation == table.operation) table.answers = &checks[i].judgment.answers;
  check_dump(options, expected, listener);
  return totals;
}

}  // namespace restrip::verify
