// Reproduces the experiments of the paper: M. B. Porcu, N. Sanna, R. Scateni, "Rewriting rules for the dual graph of a
// stripified CLOD mesh". For each mesh: triangles per vertex (tables 1 and 2, plots 9 and 10), how many splits
// introduce an isolated triangle under the paper's rules and under ours, and the number of strips at each level of
// detail, compared with strips from scratch.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lod/simplify.hpp"
#include "meshes/mend.hpp"
#include "meshes/mesh_report.hpp"
#include "replay/replay.hpp"

namespace restrip::tools {

struct PaperOptions {
  SimplifyOptions simplify;
  std::size_t levels = 12;  ///< of detail, in geometric steps, including base and finest level; at least 2
};

/// A mesh in the tables of the paper.
struct PaperRow {
  std::string mesh;
  std::size_t triangles = 0;
  std::vector<std::size_t> triangles_per_vertex;  ///< [n]: vertices of n triangles
  std::optional<double> isolating_percent;  ///< splits that introduced an isolated triangle, if the paper gives it
};

/// The paper's row for a mesh of this size, if it has one.
[[nodiscard]] std::optional<PaperRow> paper_row(std::size_t triangles);

/// One pass from base to finest level under one way of keeping strips (ways.hpp).
struct PolicyRun {
  std::string name;
  std::string says;
  bool of_paper = false;
  std::size_t splits = 0;
  std::size_t isolating = 0;  ///< splits after which the patch had more isolated triangles than before
  std::vector<Level> levels;

  [[nodiscard]] double isolating_percent() const noexcept {
    return splits == 0 ? 0 : 100 * static_cast<double>(isolating) / static_cast<double>(splits);
  }
};

/// Strips from scratch at every level.
struct ScratchRun {
  std::string name;
  std::string says;
  std::vector<Level> levels;
};

struct PaperMesh {
  std::string name;
  std::size_t triangles = 0;
  MeshReport survey;
  std::optional<PaperRow> paper;
  std::size_t base_triangles = 0;
  std::vector<std::size_t> splits_by_valence;  ///< [k]: splits of a vertex of k triangles
  std::vector<PolicyRun> runs;                 ///< the paper's, then ours
  std::vector<ScratchRun> scratch;
  std::vector<std::string> faults;  ///< found by a check; empty if all is well
  Mended mended;                    ///< of its file, if it was read

  /// Whether the mesh equals the paper's row, if there is one.
  [[nodiscard]] bool equals_paper() const {
    return paper && paper->triangles_per_vertex == survey.triangles_per_vertex;
  }
};

/// One row of the valence table.
struct ValenceRow {
  std::size_t triangles = 0;  ///< per vertex
  std::size_t vertices = 0;
  double percent = 0;  ///< of the vertices that some triangle uses
  std::optional<std::size_t> paper;
};
/// From one triangle to the maximum of any vertex, here or in the paper.
[[nodiscard]] std::vector<ValenceRow> valence_rows(const PaperMesh& mesh);

/// A mesh that has been read, so that a bad file is found before hours of work.
struct PaperSubject {
  std::string name;
  Soup soup;
  std::optional<ProgressiveMesh> progressive;  ///< if the file was one
  Mended mended = {};
};
/// Throws BadInput, also if a progressive mesh is to be mended.
[[nodiscard]] PaperSubject read_subject(const std::filesystem::path& file, const MendingOptions& mending = {});

/// About two seconds per 10,000 triangles, mostly for baking and for strips from scratch.
[[nodiscard]] PaperMesh measure(const PaperSubject& subject, const PaperOptions& options);

}  // namespace restrip::tools
