#pragma once
// What the verifier says of an operation: its file, and a certificate and a dump as texts.

#include <optional>
#include <string>

#include "naive_operation.hpp"

namespace restrip::verify::operations::test {

struct OperationVerdict {
  int exit_code = 0;  ///< 0 every claim holds, 1 some claim fails, 2 bad input, as the program exits
  int failed = 0;     ///< claims that fail
  std::string text;   ///< failing claims with their first counterexamples, or the input error

  bool says(const std::string& expected) const { return text.find(expected) != std::string::npos; }
};

/// The operation files in tests/corpus/operations.
extern const std::vector<std::string> corpus_operations;
std::string corpus_path(const std::string& name, const std::string& extension);
OperationFile corpus_operation(const std::string& name);

/// The verdict on files on disk.
OperationVerdict verdict_on(const std::string& operation_path, const std::optional<std::string>& certificate,
                            const std::optional<std::string>& dump);

}  // namespace restrip::verify::operations::test
