// The frozen CSV of docs/explanation/theory.md section 8, and its like for the families that came later.
#pragma once

#include <cstdio>
#include <string>

#include "operations/description.hpp"

namespace restrip::generator {

/// One row for each valid configuration, ordered by place, then colours before, then ports; all decimal. The columns
/// are those of dump_columns(); k is not used where a family has only one position.
void dump(const Description& family, unsigned k, std::FILE* out);

/// A line for each family: its name and its columns.
[[nodiscard]] std::string dump_columns();

}  // namespace restrip::generator
