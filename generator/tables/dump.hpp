// The frozen CSV of docs/reference/verifiers.md, "Rules as CSV", and the same format for later families.
#pragma once

#include <cstdio>
#include <string>

#include "operations/description.hpp"

namespace restrip::generator {

/// One row for each valid configuration, ordered by position, then colours before, then ports; all decimal.
/// dump_columns() lists the columns; k is ignored if a family has only one position.
void dump(const Description& family, unsigned k, std::FILE* out);

/// A line for each family: its name and its columns.
[[nodiscard]] std::string dump_columns();

}  // namespace restrip::generator
