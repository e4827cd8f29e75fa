// A patch given by its triangles: docs/reference/operation-file.md, "Triangles"; vertices with indices, "Families".
// Inner edges, ports and their order follow from them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "describe/formula.hpp"
#include "describe/operation.hpp"

namespace restrip::generator {

/// The content of a single operation's file.
struct NamedPatch {
  using Triangles = std::vector<std::array<std::string, 3>>;
  Triangles before;
  Triangles after;
  std::vector<std::array<std::string, 2>> boundary;
};

/// One triangle, or one for each value of an index.
struct TrianglePattern {
  std::array<IndexedName, 3> corners;
  std::optional<Stretch> index;  ///< its name and values
};

/// A side for all positions.
using TrianglePatterns = std::vector<TrianglePattern>;

/// A stretch of the outline, from a vertex to a vertex.
using StretchPattern = std::array<IndexedName, 2>;

/// The triangles at one position, named as in the file of a single operation: u[3] is u_3. If a side has too many
/// triangles, the result exceeds the limit by one. Throws std::runtime_error if an index is negative.
[[nodiscard]] NamedPatch named_at(const TrianglePatterns& before, const TrianglePatterns& after,
                                  const std::vector<StretchPattern>& boundary, const PositionNumbers& place);

/// A fault and its place: member "before", "after" or "boundary", and the index of its element, if it concerns one.
struct PatchFault : std::runtime_error {
  PatchFault(std::string in_member, int in_element, const std::string& what)
      : std::runtime_error(what), member(std::move(in_member)), element(in_element) {}
  std::string member;
  int element;  ///< -1: the whole member
};

/// Throws PatchFault if the triangles are not discs with the same outline.
[[nodiscard]] Patch surface_patch(const NamedPatch& named);

}  // namespace restrip::generator
