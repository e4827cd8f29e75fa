// Output files that appear whole or not at all, and their digests.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace restrip::generator {

/// Writes every file (path relative to `directory` -> contents): all are first written beside their final names, then
/// renamed. Throws std::runtime_error naming the file and the remedy; then no file has changed.
void write_all(const std::filesystem::path& directory, const std::map<std::string, std::string>& files);

/// SHA-256 in lower-case hexadecimal.
[[nodiscard]] std::string sha256(const std::string& bytes);

}  // namespace restrip::generator
