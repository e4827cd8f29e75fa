// In place of generator/tables/made_before.hpp: nothing was made before, and no record is kept.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "common/output.hpp"

namespace restrip::generator {

class MadeBefore {
 public:
  static constexpr const char* file_name = "restrip-digests.txt";
  MadeBefore(const std::filesystem::path& /*folder*/, const std::vector<std::string>& /*inputs*/) {}
  [[nodiscard]] bool has(const std::vector<std::filesystem::path>& /*files*/) const { return false; }
  [[nodiscard]] files::NamedBytes with(const std::vector<files::NamedBytes>& /*made*/) const { return {file_name, {}}; }
  [[nodiscard]] std::string sentence() const { return {}; }
};

}  // namespace restrip::generator
