// Writes one level of detail to a file, with its strips.
#pragma once

#include <cstddef>
#include <span>

#include "lod/mesh_formats.hpp"
#include "replay/ways.hpp"

namespace restrip::tools {

struct LevelFile {
  WrittenStrips written;
  std::size_t triangles = 0;
  std::size_t strips = 0;
};

/// The mesh and its strips in a format that has strips. Vertices are numbered in the order in which the strips use
/// them; unused ones are left out. Throws what the format throws.
[[nodiscard]] LevelFile level_file(const StripMesh& mesh, std::span<const Point> points, const MeshFormat& format,
                                   const StripOptions& options, std::span<const Attribute> attributes = {});
/// The coarsest level with at least `triangles` triangles, or the finest level if all are smaller. Its strips are kept
/// from the base up as the plan says. Throws BadInput at a split that is not possible.
[[nodiscard]] StripMesh level_mesh(const Plan& plan, std::size_t triangles);

}  // namespace restrip::tools
