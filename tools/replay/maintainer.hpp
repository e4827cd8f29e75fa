// Maintainer: keeps the strips of one mesh while it changes. methods.hpp lists the methods of doing so; replays, walks,
// benchmarks and the paper's report know this interface alone.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "lod/progressive_mesh.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/operations/absorb.hpp"
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

/// For operations that do not report what they did: counts strips and isolated triangles in and around the patch before
/// and after. `elsewhere`: dual edges outside the patch whose colour changes, named as they are after a split and
/// before a collapse. `operation` does it and returns its halfedge. Linear in both, up to a logarithm.
class Witness {
 public:
  using Halfedge = StripMesh::Halfedge;
  using Edges = std::span<const Halfedge>;

  template <class Operation>
  Rewrite split(const StripMesh& mesh, const VertexSplit& where, Edges elsewhere, Operation&& operation) {
    fan_triangles(mesh, where.spokes == VertexSplit::Spokes::right_only ? where.right : where.left, patch_);
    const std::size_t valence = patch_.size();
    const Count before = count(mesh, elsewhere);
    const Halfedge chord = operation();
    edge_triangles(mesh, chord, patch_);
    return reported(chord, valence, before, count(mesh, elsewhere));
  }
  template <class Operation>
  Rewrite collapse(const StripMesh& mesh, Halfedge chord, Edges elsewhere, Operation&& operation) {
    edge_triangles(mesh, chord, patch_);
    const Count before = count(mesh, elsewhere);
    const Halfedge spoke = operation();
    fan_triangles(mesh, spoke, patch_);
    const std::size_t valence = patch_.size();
    return reported(spoke, valence, before, count(mesh, elsewhere));
  }
  template <class Operation>
  Rewrite flip(const StripMesh& mesh, Halfedge h, Operation&& operation) {
    patch_.assign({StripMesh::triangle(h), StripMesh::triangle(mesh.opposite(h))});
    const Count before = count(mesh, {});
    const Halfedge turned = operation();
    patch_.assign({StripMesh::triangle(turned), StripMesh::triangle(mesh.opposite(turned))});
    return reported(turned, 4, before, count(mesh, {}));
  }

 private:
  struct Count {
    int strips = 0;  // up to a constant: triangles minus solid edges
    int isolated = 0;
  };
  Count count(const StripMesh& mesh, Edges elsewhere);
  static Rewrite reported(Halfedge h, std::size_t valence, const Count& before, const Count& after) {
    return {
        {after.strips - before.strips, 0, after.isolated - before.isolated}, h, static_cast<std::uint32_t>(valence)};
  }

  std::vector<Triangle> patch_;
};

/// A maintainer whose operations do not report what they did; a witness does.
class WitnessedMaintainer : public Maintainer {
 public:
  using Maintainer::Maintainer;
  Rewrite split(const Where& where, Vertex v_t, std::size_t /*record*/) final {
    return witness_.split(mesh_, where, {}, [&] { return do_split(where, v_t); });
  }
  Rewrite collapse(Halfedge chord, std::size_t /*record*/) final {
    return witness_.collapse(mesh_, chord, {}, [&] { return do_collapse(chord); });
  }
  Rewrite flip(Halfedge h) final {
    return witness_.flip(mesh_, h, [&] { return do_flip(h); });
  }

 private:
  /// Each returns the halfedge of its Rewrite.
  virtual Halfedge do_split(const Where& where, Vertex v_t) = 0;
  virtual Halfedge do_collapse(Halfedge chord) = 0;
  virtual Halfedge do_flip(Halfedge h) = 0;
  void split_silently(const Where& where, Vertex v_t, std::size_t /*record*/) final { do_split(where, v_t); }
  void collapse_silently(Halfedge chord, std::size_t /*record*/) final { do_collapse(chord); }

  Witness witness_;
};

}  // namespace restrip::tools
