// The triangles of a family, whose vertices have indices: docs/operation-file.md, "Families".
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "operations/formula.hpp"
#include "operations/triangles.hpp"

namespace restrip::generator {

/// One triangle, or one for each value of an index.
struct TrianglePattern {
  std::array<IndexedName, 3> corners;
  std::optional<Stretch> index;  ///< its name and values
};

/// A side for all positions.
using TrianglePatterns = std::vector<TrianglePattern>;

/// A stretch of the rim, from a vertex to a vertex.
using StretchPattern = std::array<IndexedName, 2>;

/// The triangles at one position, as the file of a single operation would name them: u[3] is u_3. Throws
/// std::runtime_error when an index is negative or there are more triangles than a side can have.
[[nodiscard]] NamedPatch named_at(const TrianglePatterns& before, const TrianglePatterns& after,
                                  const std::vector<StretchPattern>& boundary, const PositionNumbers& place);

}  // namespace restrip::generator
