#include "verdict.hpp"

#include <fmt/format.h>

#include "family_check.hpp"
#include "linked_report.hpp"
#include "verify.hpp"

namespace restrip::verify::test {
namespace {

template <typename Check>
Verdict collected(const Check& check) {
  Verdict verdict;
  try {
    check([&](const ClaimResult& result) {
      if (result.held()) return;
      verdict.exit_code = 1;
      verdict.crimes[result.claim] = result.failures;
      verdict.text += line_of(result);
    });
  } catch (const std::exception& error) {
    verdict.exit_code = 2;
    verdict.text += error.what();
  }
  return verdict;
}

Family one_section_family(const std::string& family_name, const std::string& position) {
  static const std::vector<Family> families = all_families(largest_fan);
  for (const Family& family : families)
    for (const Section& section : family.sections)
      if (family.name == family_name && section.position == position) return {family.name, {section}, {}};
  throw std::logic_error(fmt::format("no section {} in {}", position, family_name));
}

}  // namespace

Verdict verdict_of(const std::string& certificate_text, const Family& family, bool second_formulation) {
  return collected([&](const ClaimListener& listener) {
    const Certificate certificate = parse_certificate("table", certificate_text, family);
    std::vector<OperationTask> tasks;
    for (std::size_t i = 0; i < family.sections.size(); ++i)
      for (const Operation& operation : family.sections[i].operations)
        tasks.push_back({&family.sections[i], &certificate.sections[i], &operation, certificate.file});
    const std::vector<OperationCheck> checks = check_operations(tasks, second_formulation, 1, [](std::size_t) {});
    report_family(family, certificate, checks, second_formulation, listener);
  });
}

Verdict verdict_of(const NaiveTable& table) {
  return verdict_of(certificate_text(table.family, std::vector{table}),
                    one_section_family(table.family, table.position), true);
}

Verdict verdict_of(const NaiveLists& lists, const NaiveTable& local) {
  return collected([&](const ClaimListener& listener) {
    const LinkedFamily family{lists.family, one_section_family(local.family, local.position)};
    const Certificate rules =
        parse_certificate("local", certificate_text(local.family, std::vector{local}), family.local);
    const LinkedCertificate certificate =
        parse_linked_certificate("table", certificate_text(lists.family, std::vector{lists}), family);
    report_linked(family,
                  {check_linked({&family.local.sections.front(), &certificate.sections.front(), &rules.sections.front(),
                                 certificate.file, rules.file})},
                  listener);
  });
}

Verdict verdict_of(const std::filesystem::path& tables_dir) {
  Options options;
  options.tables_dir = tables_dir.string();
  options.max_k = corpus_max_k;
  options.threads = 1;
  return collected([&](const ClaimListener& listener) { verify_tables(options, listener); });
}

}  // namespace restrip::verify::test
