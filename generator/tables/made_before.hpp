// Records the inputs of the files of a folder, so that repeating a command with the same inputs ends at once.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "common/output.hpp"

namespace restrip::generator {

/// The record restrip-digests.txt of a folder: for each file a line with the digest of its inputs, the digest of the
/// file, and its path. Commands that write into the same folder share it. An unreadable record counts as empty.
class MadeBefore {
 public:
  static constexpr const char* file_name = "restrip-digests.txt";

  /// `inputs`: texts on which the files depend, including options. The program itself is a further input.
  MadeBefore(std::filesystem::path folder, const std::vector<std::string>& inputs);

  /// Whether all these files exist, unchanged since they were made from the same inputs. If so, the record gets the
  /// present time, for Make. O(bytes of the files).
  [[nodiscard]] bool has(const std::vector<std::filesystem::path>& files) const;

  /// The record with these files added.
  [[nodiscard]] files::NamedBytes with(const std::vector<files::NamedBytes>& made) const;

  /// The message of a command that has nothing to do.
  [[nodiscard]] std::string sentence() const;

 private:
  std::filesystem::path folder_;
  std::string inputs_;
  std::map<std::string, std::string> lines_;  ///< of the record: the two digests by path
};

}  // namespace restrip::generator
