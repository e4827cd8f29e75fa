// tables/MANIFEST: the list of table files with SHA-256, size and number of rules.
#pragma once

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

/// The lines of a manifest; `file` is named in errors. Throws files::FileError if it is malformed.
std::vector<ManifestLine> parse_manifest(const std::string& file, const std::string& text);

/// Compares the files below the folder with the list; one sentence per fault, empty if they match. MANIFEST itself and
/// files of CMake need no line. The families must equal the families of this program.
std::vector<std::string> manifest_faults(const std::string& tables_dir, const std::vector<ManifestLine>& lines);

/// Files whose number of rows differs from the list, one sentence each. The rows of a certificate are counted by its
/// last line, the rows of a header by its certificates; other files have none.
std::vector<std::string> row_faults(const std::string& tables_dir, const std::vector<ManifestLine>& lines);

}  // namespace restrip::verify
