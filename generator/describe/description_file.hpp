// Reads files of descriptions (docs/reference/operation-file.md): one description, or a list.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "describe/description.hpp"

namespace restrip::generator {

inline constexpr std::size_t most_terms = 64;  ///< of a criterion

/// "expected at most 22 edges and ports together: a table has an entry for each of their colourings; found 12 and 12".
[[nodiscard]] std::string too_many_colors(const Side& side);

/// Reads the files of a user, of at most 1 MiB each. Throws files::FileError, or std::runtime_error if descriptions in
/// two files have the same name or certificate.
[[nodiscard]] std::vector<Description> read_descriptions(const std::vector<std::string>& files);

/// Reads the text of a file; `file` is only used in errors.
[[nodiscard]] std::vector<Description> parse_descriptions(const std::string& file, const std::string& text,
                                                          Author author = Author::user);

}  // namespace restrip::generator
