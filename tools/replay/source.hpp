// The mesh to be replayed: read and simplified, or taken from a progressive or baked file. And one level of it, as a
// file with its strips.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lod/bake.hpp"
#include "lod/mesh_files.hpp"
#include "lod/mesh_formats.hpp"
#include "lod/progressive_mesh.hpp"
#include "lod/simplify.hpp"
#include "meshes/mend.hpp"
#include "meshes/soup.hpp"
#include "replay/methods.hpp"
#include "replay/replay.hpp"

namespace restrip::tools {

/// A mesh ready to be replayed, with the triangles of its finest level (none if the file has only the splits).
struct Source {
  Subject subject;
  ProgressiveMesh mesh;
  std::vector<Corners> original;
  std::optional<BakedMesh> baked;  ///< if the file contains strips
};

/// The costs of the strips of a baked mesh.
[[nodiscard]] BakedCosts costs_of(const BakedMesh& baked, double seconds);

/// Closes the seams of the soup first. `mended`: what was changed before.
[[nodiscard]] Source simplified(std::string name, Soup soup, const SimplifyOptions& options, Mended mended = {});
/// Of a mesh that has been read from the file. Throws BadInput if a progressive mesh is to be simplified
/// (`options_given`) or mended.
[[nodiscard]] Source source_of(ReadMesh read, const NamedFile& file, const MendingOptions& mending,
                               const SimplifyOptions& options, bool options_given);

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
/// from the base up by the method. Throws BadInput at a split that is not possible.
[[nodiscard]] StripMesh level_mesh(const PreparedMethod& prepared, std::size_t triangles);

}  // namespace restrip::tools
