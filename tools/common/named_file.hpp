// A file named on the command line, and its format if the name does not show it: a pipe has no extension.
#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "common/reading.hpp"

namespace restrip::tools {

struct NamedFile {
  std::filesystem::path path;  ///< `-`: standard input, or output
  std::string format;          ///< an extension without the dot; empty: from the name

  NamedFile() = default;
  NamedFile(std::filesystem::path file, std::string as = {}) : path(std::move(file)), format(std::move(as)) {}

  [[nodiscard]] bool empty() const { return path.empty(); }
  /// For messages.
  [[nodiscard]] std::string string() const { return path.string(); }
  /// The extension of the format, in lower case with its dot; empty if unknown.
  [[nodiscard]] std::string extension() const { return format.empty() ? files::extension_of(path) : "." + format; }
};

}  // namespace restrip::tools
