// Reads and writes files of descriptions (docs/reference/operation-file.md): one description, or a list.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "operations/description.hpp"

namespace restrip::generator {

/// Limit for operation files, on either side; families must obey it when tables are made.
inline constexpr unsigned most_ports = 8;
inline constexpr unsigned most_nodes = 16;
/// Edges of one side, including ports.
inline constexpr unsigned most_edges_and_ports = 20;
inline constexpr std::size_t most_terms = 64;  ///< of a criterion

/// Who wrote a file. Names of restrip's own tables are reserved for restrip's families.
enum class Author { user, restrip };

/// Reads the file of a user; throws files::FileError.
[[nodiscard]] std::vector<Description> read_descriptions(const std::string& file);

/// The text of a user's file, of at most 1 MiB. Throws files::FileError.
[[nodiscard]] std::string read_description_text(const std::string& file);

/// Reads the text of a file; `file` is only used in errors.
[[nodiscard]] std::vector<Description> parse_descriptions(const std::string& file, const std::string& text,
                                                          Author author = Author::user);

/// The operation file of a family at one position, with the preference of its shipped rules; its name is "split-k4-a2",
/// or "flip-own". For another constraint than the family's, the file states no preference and so has the default, and
/// the name ends in the constraint.
[[nodiscard]] std::string operation_file_text(const Position& position, Constraint constraint = {});

}  // namespace restrip::generator
