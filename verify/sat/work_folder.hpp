#pragma once
// Where formulas and proofs are written. They appear under their names only when they are whole and checked; otherwise
// nothing is left behind.

#include <filesystem>
#include <string>

#include "files/output.hpp"

namespace restrip::verify::sat {

class WorkFolder {
 public:
  /// Temporary; inside `kept` when that is not empty, which is made if need be. Throws std::runtime_error when it
  /// cannot be made.
  explicit WorkFolder(const std::string& kept);
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  std::string path(const std::string& name) const { return (temporary_ / name).string(); }
  void write(const std::string& name, const std::string& bytes) const;
  /// Moves the file to where it is kept, synced, or removes it when nothing is.
  void finish(const std::string& name) const;

 private:
  std::filesystem::path kept_;
  files::MadeFolders made_;  ///< on the way to it; they go with this folder when nothing is in them
  std::filesystem::path temporary_;
};

}  // namespace restrip::verify::sat
