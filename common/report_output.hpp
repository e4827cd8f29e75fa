// The destination of the report of a command, the same for every command: text on standard output, or on standard error
// if another output of the command is standard output; with `--json FILE` also JSON to the file; with `--json -` JSON
// on standard output instead of the text.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/output.hpp"

namespace restrip::files {

class ReportOutput {
 public:
  /// `json`: the argument of the option, empty if it was not given. Tests the file before the work; it must end in
  /// .json and not be an input. Throws what files::Output throws.
  explicit ReportOutput(const std::string& json, std::vector<std::filesystem::path> inputs = {});

  /// Whether standard output is only for JSON, so that intermediate lines are not printed.
  [[nodiscard]] bool replaces_text() const noexcept { return to_stdout_; }

  /// Both end with a line feed, or are empty.
  void print(std::string_view text, std::string_view json) const;

 private:
  bool to_stdout_;
  std::optional<Output> file_;
  std::shared_ptr<const Claim> claim_;  // on standard output
};

/// The exit code of a program: `code`, or 2 with a message if standard output could not be written, which a buffer or a
/// full disk may hide until the end. For the end of every main(), also after --help.
[[nodiscard]] int exit_code(std::string_view program, int code);

}  // namespace restrip::files
