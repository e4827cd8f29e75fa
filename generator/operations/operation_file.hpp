// Operation files: an operation of the user's own, as docs/operation-file.md describes it.
#pragma once

#include <cstddef>
#include <string>

#include "operation.hpp"

namespace restrip::generator {

struct NamedOperation {
  std::string name;
  std::string about;
  Operation operation;
};

/// No operation has more, on either side.
inline constexpr unsigned most_ports = 8;
inline constexpr unsigned most_nodes = 16;
/// Edges of one side, ports included.
inline constexpr unsigned most_edges_and_ports = 20;
inline constexpr std::size_t most_terms = 64;  ///< of a criterion

/// Reads the file; std::runtime_error says file, line, and what was expected.
[[nodiscard]] NamedOperation read_operation(const std::string& file);

/// Reads the text of a file; `file` is only named in errors.
[[nodiscard]] NamedOperation parse_operation(const std::string& file, const std::string& text);

}  // namespace restrip::generator
