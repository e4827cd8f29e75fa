#include "verdict.hpp"

#include <fmt/format.h>

#include "family_check.hpp"
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
      if (family.name == family_name && section.position == position) return {family.name, {section}};
  throw std::logic_error(fmt::format("no section {} in {}", position, family_name));
}

}  // namespace

Verdict verdict_of(const NaiveTable& table) {
  const Family family = one_section_family(table.family, table.position);
  return collected([&](const ClaimListener& listener) {
    const Certificate certificate = parse_certificate("table", certificate_text(table.family, {table}), family);
    std::vector<OperationTask> tasks;
    for (const Operation& operation : family.sections.front().operations)
      tasks.push_back({&family.sections.front(), &certificate.sections.front(), &operation, certificate.file});
    report_family(family, certificate, check_operations(tasks, true, 1, [](std::size_t) {}), true, listener);
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
