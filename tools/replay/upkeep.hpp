// Upkeep: keeps the strips of one mesh while it changes. Every way of keeping strips implements this interface
// (ways.hpp lists them); replays, walks, benchmarks and the paper's report use nothing else.
//
// Single operations are virtual and report what they did. The loops are for timing: one dispatch for all operations,
// and no reports.
#pragma once

#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "lod/progressive_mesh.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/operations/absorb.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/search/keeper.hpp"

namespace restrip::tools {

/// The record number of an operation that plays no record of a progressive mesh.
inline constexpr std::size_t no_record = static_cast<std::size_t>(-1);

class Upkeep {
 public:
  using Halfedge = StripMesh::Halfedge;
  using Where = VertexSplit<Halfedge>;

  Upkeep() = default;
  Upkeep(const Upkeep&) = delete;
  Upkeep& operator=(const Upkeep&) = delete;
  virtual ~Upkeep() = default;

  [[nodiscard]] virtual const StripMesh& mesh() const = 0;

  /// Preconditions and results as in operations.hpp; `strips` and `isolated` count the whole mesh. `record`: the number
  /// of the record being played, or no_record; precomputed strips need it.
  virtual Rewrite<Halfedge> split(const Where& where, Vertex v_t, std::size_t record) = 0;
  virtual Rewrite<Halfedge> collapse(Halfedge chord, std::size_t record) = 0;
  virtual Rewrite<Halfedge> flip(Halfedge h) = 0;
  /// What the way does to all strips between two operations, usually nothing. Call it after each single operation; the
  /// loops do so themselves.
  virtual Repair between() = 0;

  /// Plays split records in order, finding the spokes by their vertices. `first` is the number of the first record.
  virtual void play_up(std::span<const Record> records, std::size_t first) = 0;
  /// Collapses them again, the last one first.
  virtual void play_down(std::span<const Record> records, std::size_t first) = 0;

  /// The mesh or its colours have been changed from outside, to that level of the progressive mesh: reads it again.
  virtual void restart(std::size_t level) = 0;
  /// A fault in the data kept for the mesh; empty if none is found.
  [[nodiscard]] virtual std::string fault() const = 0;
  /// The outcomes of all rule lookups; zero if no rule is used.
  [[nodiscard]] virtual RuleCounts rule_counts() const = 0;
};

/// For operations that do not report what they did: counts strips and isolated triangles in and around the patch before
/// and after. `elsewhere`: dual edges outside the patch whose colour changes, named as they are after a split and
/// before a collapse. `operation` does it and returns its halfedge. Linear in both, up to a logarithm.
class Witness {
 public:
  using Halfedge = StripMesh::Halfedge;
  using Edges = std::span<const Halfedge>;

  template <class Operation>
  Rewrite<Halfedge> split(const StripMesh& mesh, const VertexSplit<Halfedge>& where, Edges elsewhere,
                          Operation&& operation) {
    fan_triangles(mesh, where.spokes == VertexSplit<Halfedge>::Spokes::right_only ? where.right : where.left, patch_);
    const std::size_t valence = patch_.size();
    const Count before = count(mesh, elsewhere);
    const Halfedge chord = operation();
    edge_triangles(mesh, chord, patch_);
    return reported(chord, valence, before, count(mesh, elsewhere));
  }
  template <class Operation>
  Rewrite<Halfedge> collapse(const StripMesh& mesh, Halfedge chord, Edges elsewhere, Operation&& operation) {
    edge_triangles(mesh, chord, patch_);
    const Count before = count(mesh, elsewhere);
    const Halfedge spoke = operation();
    fan_triangles(mesh, spoke, patch_);
    const std::size_t valence = patch_.size();
    return reported(spoke, valence, before, count(mesh, elsewhere));
  }
  template <class Operation>
  Rewrite<Halfedge> flip(const StripMesh& mesh, Halfedge h, Operation&& operation) {
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
  static Rewrite<Halfedge> reported(Halfedge h, std::size_t valence, const Count& before, const Count& after) {
    return {h, static_cast<std::uint32_t>(valence), after.strips - before.strips, after.isolated - before.isolated};
  }

  std::vector<Triangle> patch_;
};

/// What operations on a mesh need not define.
struct PlainOperations {
  Repair between() { return {}; }
  void restart(std::size_t /*level*/) {}
  [[nodiscard]] std::string fault() const { return {}; }
  [[nodiscard]] RuleCounts rule_counts() const { return {}; }
};

/// An upkeep by a class of operations on a mesh, which is derived from PlainOperations and has
///   split(where, v_t, record), collapse(chord, record), flip(h): each returns a Rewrite or a Halfedge only. For a
///   Halfedge, a witness reports the rest. If the Rewrite is incomplete, split_and_report and collapse_and_report are
///   called instead.
/// and, where they differ, between(), restart(level), fault() and rule_counts().
template <class Operations>
class UpkeepBy final : public Upkeep {
 public:
  template <class... Arguments>
  explicit UpkeepBy(StripMesh& mesh, Arguments&&... arguments)
      : mesh_(&mesh), operations_(mesh, std::forward<Arguments>(arguments)...) {}

  [[nodiscard]] const StripMesh& mesh() const override { return *mesh_; }

  Rewrite<Halfedge> split(const Where& where, Vertex v_t, std::size_t record) override {
    if constexpr (requires { operations_.split_and_report(where, v_t, record); }) {
      return operations_.split_and_report(where, v_t, record);
    } else if constexpr (reports) {
      return operations_.split(where, v_t, record);
    } else {
      return witness_.split(*mesh_, where, {}, [&] { return operations_.split(where, v_t, record); });
    }
  }
  Rewrite<Halfedge> collapse(Halfedge chord, std::size_t record) override {
    if constexpr (requires { operations_.collapse_and_report(chord, record); }) {
      return operations_.collapse_and_report(chord, record);
    } else if constexpr (reports) {
      return operations_.collapse(chord, record);
    } else {
      return witness_.collapse(*mesh_, chord, {}, [&] { return operations_.collapse(chord, record); });
    }
  }
  Rewrite<Halfedge> flip(Halfedge h) override {
    if constexpr (reports) {
      return operations_.flip(h);
    } else {
      return witness_.flip(*mesh_, h, [&] { return operations_.flip(h); });
    }
  }
  Repair between() override { return operations_.between(); }

  void play_up(std::span<const Record> records, std::size_t first) override {
    for (const Record& record : records) {
      operations_.split(spokes_of(*mesh_, record), record.v_t, first++);
      UpkeepBy::between();
    }
  }
  void play_down(std::span<const Record> records, std::size_t first) override {
    for (std::size_t i = records.size(); i-- > 0;) {
      operations_.collapse(mesh_->spoke(records[i].v_s, records[i].v_t), first + i);
      UpkeepBy::between();
    }
  }

  void restart(std::size_t level) override { operations_.restart(level); }
  [[nodiscard]] std::string fault() const override { return operations_.fault(); }
  [[nodiscard]] RuleCounts rule_counts() const override { return operations_.rule_counts(); }

 private:
  static constexpr bool reports =
      std::same_as<decltype(std::declval<Operations&>().flip(Halfedge{})), Rewrite<Halfedge>>;

  StripMesh* mesh_;
  Operations operations_;
  Witness witness_;
};

}  // namespace restrip::tools
