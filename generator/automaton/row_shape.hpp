// Families whose side after is a row of triangles, and where the row lies among their ports: docs/automaton.md,
// "Families of your own".
#pragma once

#include <vector>

#include "operations/description.hpp"

namespace restrip::generator {

/// Whether two triangles share an inner edge.
[[nodiscard]] bool are_neighbours(const Side& side, unsigned one, unsigned other);

/// Whether these triangles, each of which must be one of the side, are different and each shares an inner edge with the
/// next.
[[nodiscard]] bool is_row(const Side& side, const std::vector<unsigned>& triangles);

/// Each triangle of a row has a port, in the cyclic order of the ports.
struct RowShape {
  bool front = false;     ///< the first triangle has another port, before its own
  bool back = false;      ///< the last triangle has another port, behind its own
  unsigned first = 0;     ///< the number of the row's first port; or
  bool from_end = false;  ///< the number of ports less `first`, where it is not 0
};

/// That of a family at all its positions with a first number of at most eight. Throws std::runtime_error with the
/// reason if there is none, or if before the operation ports are joined that do not follow each other in the row,
/// cyclically.
[[nodiscard]] RowShape row_shape_of(const Description& family);

}  // namespace restrip::generator
