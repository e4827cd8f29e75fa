// The mesh to be replayed: read and simplified, or taken from a progressive or baked file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lod/bake.hpp"
#include "lod/mesh_files.hpp"
#include "lod/mesh_formats.hpp"
#include "lod/progressive_mesh.hpp"
#include "lod/simplify.hpp"
#include "meshes/mend.hpp"
#include "meshes/soup.hpp"
#include "replay/replay_text.hpp"

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

[[nodiscard]] Source simplified(std::string name, Soup soup, const SimplifyOptions& options);
/// Of a mesh that has been read from the file. Throws BadInput if a progressive mesh is to be simplified
/// (`options_given`) or mended.
[[nodiscard]] Source source_of(ReadMesh read, const NamedFile& file, const MendingOptions& mending,
                               const SimplifyOptions& options, bool options_given);

}  // namespace restrip::tools
