// Whether two certificates, or two table dumps, have the same rules, or others that cost the same.
#pragma once

#include <string>
#include <vector>

namespace restrip::generator {

struct CompareOptions {
  std::string a;
  std::string b;
  std::vector<std::string> operations;  ///< operation files of others than the shipped families
  std::string json;                     ///< file for the report, "-" for standard output, or empty
};

/// Reports, and returns the exit code: 0 when the rules cost the same, otherwise 1. Throws std::exception where the
/// files do not have the same operation, where rules differ and no description has their operation, and where such a
/// rule is no sound recolouring.
[[nodiscard]] int compare(const CompareOptions& options);

}  // namespace restrip::generator
