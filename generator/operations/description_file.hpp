// Files of descriptions, as docs/reference/operation-file.md has them: one description, or a list of them, read and
// written.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "operations/description.hpp"

namespace restrip::generator {

/// No operation of a file has more, on either side; families are held to it when tables are made of them.
inline constexpr unsigned most_ports = 8;
inline constexpr unsigned most_nodes = 16;
/// Edges of one side, ports included.
inline constexpr unsigned most_edges_and_ports = 20;
inline constexpr std::size_t most_terms = 64;  ///< of a criterion

/// Who wrote a file. Names that restrip's own tables have are for restrip's own families alone.
enum class Author { user, restrip };

/// Reads the file of a user; std::runtime_error says file, line, and what was expected.
[[nodiscard]] std::vector<Description> read_descriptions(const std::string& file);

/// The text of a user's file, of at most 1 MiB. Throws files::FileError.
[[nodiscard]] std::string read_description_text(const std::string& file);

/// Reads the text of a file; `file` is only named in errors.
[[nodiscard]] std::vector<Description> parse_descriptions(const std::string& file, const std::string& text,
                                                          Author author = Author::user);

/// The operation file of a family at one position, with the preference of its shipped rules; named "split-k4-a2", or
/// "flip-own". Under another constraint than that of the family the preference is the usual one, which is none in the
/// file, and the constraint's word ends the name.
[[nodiscard]] std::string operation_file_text(const Position& position, Constraint constraint = {});

}  // namespace restrip::generator
