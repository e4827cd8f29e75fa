// The files that a thread is about to write, whatever their names: none may be written twice, and none may be read,
// because it would be lost. Outputs claim their files before anything is read, so files found later (the buffers of a
// glTF) are protected as well.
#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <optional>
#include <string>

namespace restrip::files {

class Claim {
 public:
  /// `shown`: its name as the user wrote it. `file`: the target of its links. `descriptor`: -1, or the open file.
  /// Throws FileError when this thread has claimed the file already.
  Claim(std::string shown, std::filesystem::path file, int descriptor);
  ~Claim();
  Claim(const Claim&) = delete;
  Claim& operator=(const Claim&) = delete;

  [[nodiscard]] const std::string& shown() const noexcept { return shown_; }

  /// The claim on this file, or null. Terminals and the like are never claimed: several may use them.
  [[nodiscard]] static const Claim* on(const struct stat& file);
  /// Whether standard output carries a file, so that text has to go elsewhere.
  [[nodiscard]] static bool on_standard_output();

 private:
  [[nodiscard]] std::optional<struct stat> status() const;
  [[nodiscard]] bool same_place(const Claim& other) const;

  std::string shown_;
  std::filesystem::path file_;
  int descriptor_;
};

}  // namespace restrip::files
