#pragma once
// tables/MANIFEST: the list of the files of the tables with their SHA-256, sizes and numbers of rules.

#include <cstddef>
#include <string>
#include <vector>

namespace restrip::verify {

struct ManifestLine {
  std::string sha256;
  std::size_t bytes = 0;
  std::size_t rows = 0;
  std::string path;
  unsigned line = 0;
};

/// The lines of a manifest; `file` is named in errors. InputError when it is not well formed.
std::vector<ManifestLine> parse_manifest(const std::string& file, const std::string& text);
/// The lines of the folder's MANIFEST. InputError as well when it cannot be read.
std::vector<ManifestLine> read_manifest(const std::string& tables_dir);

/// What is wrong with the files below the folder, one sentence each, empty when they are exactly those listed.
/// MANIFEST itself and files of CMake need no line. Families that are there must be those that this program knows.
std::vector<std::string> manifest_faults(const std::string& tables_dir, const std::vector<ManifestLine>& lines);

/// The files that are there and listed with another number of rows than they have, one sentence each. A certificate has
/// as many as its last line says, a header as many as the certificates of which it was made, other files none.
std::vector<std::string> row_faults(const std::string& tables_dir, const std::vector<ManifestLine>& lines);

}  // namespace restrip::verify
