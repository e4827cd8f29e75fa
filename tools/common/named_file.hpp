// A file as a command line names it, and its format where the name does not say it: a pipe has no extension.
#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "common/reading.hpp"

namespace restrip::tools {

struct NamedFile {
  std::filesystem::path path;  ///< `-`: standard input, or output
  std::string format;          ///< an extension without its point; empty: that of the name

  NamedFile() = default;
  NamedFile(std::filesystem::path file, std::string as = {}) : path(std::move(file)), format(std::move(as)) {}

  [[nodiscard]] bool empty() const { return path.empty(); }
  /// For messages.
  [[nodiscard]] std::string string() const { return path.string(); }
  /// Of the format, in lower case and with its point; empty when neither says it.
  [[nodiscard]] std::string extension() const { return format.empty() ? files::extension_of(path) : "." + format; }
};

}  // namespace restrip::tools
