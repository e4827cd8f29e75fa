// What the files of a folder were made from, so that making them again from the same ends at once.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "common/output.hpp"

namespace restrip::generator {

/// The record restrip-digests.txt of a folder: for each file a line with the digest of what it was made from, the
/// digest of the file, and its path. Commands that write into the same folder share it. A record that cannot be read
/// has no files.
class MadeBefore {
 public:
  static constexpr const char* file_name = "restrip-digests.txt";

  /// `inputs`: texts that the files depend on, options included. The program itself is one more.
  MadeBefore(std::filesystem::path folder, const std::vector<std::string>& inputs);

  /// Whether all these files are there, as they were made from the same inputs. The record is then given the present
  /// time, for Make. O(bytes of the files).
  [[nodiscard]] bool has(const std::vector<std::filesystem::path>& files) const;

  /// The record with these files in it.
  [[nodiscard]] files::NamedBytes with(const std::vector<files::NamedBytes>& made) const;

  /// What a command says that has nothing to do.
  [[nodiscard]] std::string sentence() const;

 private:
  std::filesystem::path folder_;
  std::string inputs_;
  std::map<std::string, std::string> lines_;  ///< of the record: by path, its two digests
};

}  // namespace restrip::generator
