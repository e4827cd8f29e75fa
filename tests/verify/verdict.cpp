#include "verdict.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>

#include "judge/family_report.hpp"
#include "model/input.hpp"
#include "verify.hpp"

namespace restrip::verify::test {
namespace {

namespace fs = std::filesystem;

template <typename Check>
Verdict collected(const Check& check) {
  Verdict verdict;
  try {
    check([&](const ClaimResult& result) {
      if (result.held()) return;
      verdict.exit_code = 1;
      verdict.crimes[result.claim] = result.failures.count;
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

/// A file that is deleted with the object.
class PassingFile {
 public:
  PassingFile(const std::string& name, const std::string& text)
      : path_(fs::temp_directory_path() / fmt::format("restrip-operation-{}-{}", getpid(), name)) {
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~PassingFile() { fs::remove(path_); }
  PassingFile(const PassingFile&) = delete;
  PassingFile& operator=(const PassingFile&) = delete;
  std::string path() const { return path_.string(); }

 private:
  fs::path path_;
};

}  // namespace

Verdict verdict_of(const std::string& certificate_text, const Family& family) {
  return collected([&](const ClaimListener& listener) {
    const Certificate certificate = parse_certificate("table", certificate_text, family);
    const std::vector<PositionCheck> checks = check_positions(tasks_of(family, &certificate), 1);
    report_family(family, certificate, checks, listener);
  });
}

Verdict verdict_of(const NaiveTable& table) {
  return verdict_of(certificate_text(table.family, std::vector{table}),
                    one_section_family(table.family, table.position));
}

Verdict verdict_of(const fs::path& tables_dir) {
  Options options;
  options.tables_dir = tables_dir.string();
  options.max_k = corpus_max_k;
  options.threads = 1;
  return collected([&](const ClaimListener& listener) { verify_tables(options, listener); });
}

const std::vector<std::string> corpus_operations = {"split-face-own", "merge-face", "bisect-costs",
                                                    "bisect-boundary-matching", "merge-face-matching"};

std::string corpus_path(const std::string& name) {
  return fmt::format("{}/operations/{}.json", RESTRIP_CORPUS_DIR, name);
}

Operation corpus_operation(const std::string& name) {
  const std::string path = corpus_path(name);
  return parse_operation(path, read_file(path));
}

Verdict verdict_on(const std::string& operation_path, const std::optional<std::string>& certificate,
                   const std::optional<std::string>& dump) {
  const PassingFile certificate_file("certificate", certificate.value_or(""));
  const PassingFile dump_file("dump", dump.value_or(""));
  Options options;
  options.operation = operation_path;
  options.threads = 1;
  if (certificate) options.certificate = certificate_file.path();
  if (dump) options.dump_command = "cat " + dump_file.path();
  return collected([&](const ClaimListener& listener) {
    options.operation_text = read_file(operation_path);
    verify_operation(options, listener);
  });
}

Verdict verdict_on_text(const std::string& operation, const std::optional<std::string>& certificate,
                        const std::optional<std::string>& dump) {
  return verdict_on(PassingFile("operation", operation).path(), certificate, dump);
}

}  // namespace restrip::verify::test
