#include "operation_verdict.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "input.hpp"
#include "verify_operation.hpp"

namespace restrip::verify::operations::test {
namespace {

namespace fs = std::filesystem;

/// A file that goes away with the object.
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

const std::vector<std::string> corpus_operations = {
    "split-face", "merge-face", "bisect-costs", "bisect-boundary-matching", "merge-face-matching", "flip-forest"};

std::string corpus_path(const std::string& name, const std::string& extension) {
  return fmt::format("{}/operations/{}.{}", RESTRIP_CORPUS_DIR, name, extension);
}

OperationFile corpus_operation(const std::string& name) {
  const std::string path = corpus_path(name, "json");
  return parse_operation_file(path, read_file(path));
}

OperationVerdict verdict_on(const std::string& operation_path, const std::optional<std::string>& certificate,
                            const std::optional<std::string>& dump) {
  const PassingFile certificate_file("certificate", certificate.value_or(""));
  const PassingFile dump_file("dump", dump.value_or(""));
  OperationOptions options;
  options.operation = operation_path;
  if (certificate) options.certificate = certificate_file.path();
  if (dump) options.dump_command = "cat " + dump_file.path();
  OperationVerdict verdict;
  try {
    verify_operation(options, [&](const ClaimResult& result) {
      if (result.held()) return;
      verdict.exit_code = 1;
      ++verdict.failed;
      verdict.text += line_of(result);
    });
  } catch (const std::exception& error) {
    verdict.exit_code = 2;
    verdict.text += error.what();
  }
  return verdict;
}

}  // namespace restrip::verify::operations::test
