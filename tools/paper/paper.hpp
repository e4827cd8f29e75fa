// The paper's experiments, done again: M. B. Porcu, N. Sanna, R. Scateni, "Rewriting rules for the dual graph of a
// stripified CLOD mesh". On each mesh: how many triangles its vertices have (tables 1 and 2, plots 9 and 10), in how
// many splits an isolated triangle appears under the paper's rules and under ours, and how many strips there are at
// each level of detail, against strips made from scratch.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lod/simplify.hpp"
#include "meshes/mend.hpp"
#include "meshes/mesh_report.hpp"
#include "replay/levels.hpp"

namespace restrip::tools {

struct PaperOptions {
  SimplifyOptions simplify;
  std::size_t levels = 12;  ///< of detail, in geometric steps, base and finest level among them; at least 2
};

/// A mesh of the paper, as its tables give it.
struct PaperRow {
  std::string mesh;
  std::size_t triangles = 0;
  std::vector<std::size_t> triangles_per_vertex;  ///< [n]: vertices of n triangles
  std::optional<double> isolating_percent;        ///< splits that introduced an isolated triangle, where it says so
};

/// The paper's row for a mesh of that many triangles, if it has one.
[[nodiscard]] std::optional<PaperRow> paper_row(std::size_t triangles);

/// One climb in one way of keeping strips (ways.hpp).
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
  std::vector<std::string> faults;  ///< what a check found; empty when all is well
  Mended mended;                    ///< of its file, when it was read

  /// The paper's row, if there is one, is the mesh's.
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
/// From one triangle to the most that a vertex has, here or in the paper.
[[nodiscard]] std::vector<ValenceRow> valence_rows(const PaperMesh& mesh);

/// A mesh that has been read, so that a bad file is found before hours of work.
struct PaperSubject {
  std::string name;
  Soup soup;
  std::optional<ProgressiveMesh> progressive;  ///< when the file was one
  Mended mended = {};
};
/// Throws BadInput, also for a progressive mesh that is to be mended.
[[nodiscard]] PaperSubject read_subject(const std::filesystem::path& file, const MendingOptions& mending = {});

/// About two seconds for each 10,000 triangles, most of it for baking and for strips from scratch.
[[nodiscard]] PaperMesh measure(const PaperSubject& subject, const PaperOptions& options);

}  // namespace restrip::tools
