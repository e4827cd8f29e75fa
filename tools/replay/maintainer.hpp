// Maintainer: keeps the strips of one mesh while it changes. methods.hpp lists the methods of doing so; replays, walks,
// benchmarks and the paper's report know this interface alone.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "lod/progressive_mesh.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/search/keeper.hpp"

namespace restrip::tools {

/// The record number of an operation that plays no record of a progressive mesh.
inline constexpr std::size_t no_record = static_cast<std::size_t>(-1);

class Maintainer {
 public:
  using Halfedge = StripMesh::Halfedge;
  using Where = VertexSplit;

  explicit Maintainer(StripMesh& on) : mesh_(on) {}
  Maintainer(const Maintainer&) = delete;
  Maintainer& operator=(const Maintainer&) = delete;
  virtual ~Maintainer() = default;

  [[nodiscard]] const StripMesh& mesh() const noexcept { return mesh_; }

  /// Preconditions and results as in operations.hpp; `strips` and `isolated` count the whole mesh. `record`: the number
  /// of the record being played, or no_record; precomputed strips need it.
  virtual Rewrite split(const Where& where, Vertex v_t, std::size_t record) = 0;
  virtual Rewrite collapse(Halfedge chord, std::size_t record) = 0;
  virtual Rewrite flip(Halfedge h) = 0;
  /// What the method does to all strips between two operations. Call it after each of the operations above; play_up()
  /// and play_down() do so themselves.
  virtual ColoringChange between() { return {}; }

  /// Plays split records in order, finding the spokes by their vertices. `first` is the number of the first record. For
  /// timing: nothing is reported.
  void play_up(std::span<const Record> records, std::size_t first);
  /// Collapses them again, the last one first.
  void play_down(std::span<const Record> records, std::size_t first);

  /// The mesh or its colours have been changed from outside, to that level of the progressive mesh: reads it again.
  virtual void restart(std::size_t /*level*/) {}
  /// A fault in the data kept for the mesh; empty if none is found.
  [[nodiscard]] virtual std::string fault() const { return {}; }
  /// The outcomes of all rule lookups; zero if no rule is used.
  [[nodiscard]] virtual RuleCounts rule_counts() const { return {}; }

 protected:
  /// The same as split and collapse, if that costs less without the report.
  virtual void split_silently(const Where& where, Vertex v_t, std::size_t record) { split(where, v_t, record); }
  virtual void collapse_silently(Halfedge chord, std::size_t record) { collapse(chord, record); }

  StripMesh& mesh_;
};

}  // namespace restrip::tools
