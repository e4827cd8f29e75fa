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
#include "quantity.hpp"
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
      failures.add(fmt::format("{}/MANIFEST:{}: {} listed, {} found", options.tables_dir, line->line,
                               quantity(line->rows, "row"), certificate.rows));
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

/// How many ports a pairing has in tables up to this k (docs/certificate.md, "Table dump").
unsigned pairing_places(unsigned max_k) { return max_k <= 8 ? 8 : 16; }

/// Checks and reports it; returns for each section what a dump must say.
std::vector<std::vector<std::string>> check_linked_family(const LinkedInput& input, unsigned max_k,
                                                          const ClaimListener& listener) {
  std::vector<LinkedCheck> checks;
  std::vector<std::vector<std::string>> dump;
  for (std::size_t i = 0; i < input.family->local.sections.size(); ++i) {
    const Section& section = input.family->local.sections[i];
    checks.push_back(check_linked({&section, &input.certificate.sections[i], &input.local.sections[i],
                                   input.certificate.file, input.local.file}));
    dump.push_back(dump_of(section, input.certificate.sections[i], pairing_places(max_k)));
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
    listener({"shipped headers", claim, fmt::format("{}, {}", method, quantity(sum.positions, "position")), sum.entries,
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
  std::vector<FamilyRows> found;
};

Certificates read_certificates(const Options& options, const std::vector<Family>& all,
                               const std::vector<LinkedFamily>& all_linked, Totals& totals) {
  Certificates read;
  for (const Family& family : all) {
    if (!chosen(family.name, options)) continue;
    const CertificateFile file = certificate_of(options, family.name);
    read.families.push_back(&family);
    read.rules.push_back(parse_certificate(file.path, file.text, family));
    read.found.push_back({family.name, read.rules.back().rows});
    totals.rules += read.rules.back().rows;
  }
  for (const LinkedFamily& family : all_linked) {
    if (!chosen(family.name, options)) continue;
    const CertificateFile file = certificate_of(options, family.name);
    const CertificateFile local = certificate_of(options, family.local.name);
    read.linked.push_back({&family, parse_linked_certificate(file.path, file.text, family),
                           parse_certificate(local.path, local.text, family.local)});
    read.found.push_back({family.name, read.linked.back().certificate.rows});
    totals.alternatives += read.linked.back().certificate.rows;
  }
  return read;
}

/// The operations of all families, and in the same order what their checks found.
struct Checked {
  std::vector<OperationTask> tasks;
  std::vector<OperationCheck> checks;
};

Checked check_families(const Options& options, const Certificates& read, const ClaimListener& listener,
                       Totals& totals) {
  Checked done;
  for (std::size_t i = 0; i < read.families.size(); ++i)
    for (std::size_t j = 0; j < read.families[i]->sections.size(); ++j)
      for (const Operation& operation : read.families[i]->sections[j].operations)
        done.tasks.push_back(
            {&read.families[i]->sections[j], &read.rules[i].sections[j], &operation, read.rules[i].file});
  const std::size_t all = done.tasks.size();
  const auto progress = [&](std::size_t n) {
    if (options.show_progress) fmt::print(stderr, "\r{} of {} positions checked{}", n, all, n == all ? "\r\x1b[K" : "");
  };
  done.checks = check_operations(done.tasks, options.second_formulation, std::max(1U, options.threads), progress);
  for (const OperationCheck& check : done.checks) {
    totals.configurations += check.judgment.valid;
    totals.pairs += check.judgment.pairs;
  }

  auto first = done.checks.begin();
  for (std::size_t i = 0; i < read.families.size(); ++i) {
    std::vector<OperationCheck> own;
    for (const Section& section : read.families[i]->sections)
      for ([[maybe_unused]] const Operation& operation : section.operations) own.push_back(std::move(*first++));
    report_family(*read.families[i], read.rules[i], own, options.second_formulation, listener);
    std::move(own.begin(), own.end(), first - static_cast<std::ptrdiff_t>(own.size()));
  }
  return done;
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

/// From now on the headers must answer with the certificates' rows and lists, wherever there are any.
void expect_certificates(ExpectedDump& expected, const Checked& done, const std::vector<LinkedFamily>& all_linked,
                         const LinesOfSections& lines) {
  for (ExpectedTable& table : expected.tables)
    for (std::size_t i = 0; i < done.tasks.size(); ++i)
      if (done.tasks[i].operation == table.operation)
        table = {table.operation, Against::certificate, &done.checks[i].judgment.answers};
  auto list = expected.lists.begin();
  for (const LinkedFamily& family : all_linked)
    for (const Section& section : family.local.sections) {
      if (lines.contains(&section)) list->lines = &lines.at(&section);
      ++list;
    }
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
  refuse_unknown_families(options, all, all_linked);
  ExpectedDump expected = expected_without_certificates(all, all_linked, options);
  Certificates read;
  Checked done;
  LinesOfSections lines;
  if (!options.headers_only) {
    const std::vector<ManifestLine> manifest = read_manifest(options.tables_dir);
    check_manifest(options, manifest, listener);
    read = read_certificates(options, all, all_linked, totals);
    check_row_counts(options, manifest, read.found, listener);
    done = check_families(options, read, listener, totals);
    lines = check_linked_families(read, options.max_k, listener);
    expect_certificates(expected, done, all_linked, lines);
  }
  if (!options.linked_dump_command.empty()) check_linked_picks(options, listener, totals);
  if (!options.dump_command.empty()) check_dump(options, expected, listener, totals);
  return totals;
}

}  // namespace restrip::verify
