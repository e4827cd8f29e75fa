// test_adapter(): meshes that keep the contract pass, and every operation they offer was done many times; for a mesh
// that breaks one line of it, that line is reported. The broken meshes wrap a StripMesh in members with one fault.
#include "restrip/operations/test_adapter.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <string>

#include "../../support/half_edge_mesh.hpp"
#include "restrip/mesh/checks.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

TEST(TestAdapter, StripMeshKeepsTheContract) {
  unsigned seed = 1;
  for (StripMesh& mesh : sample::meshes()) {
    // Of the mesh in two components one is tested, and a third of its vertices are of valence two.
    const AdapterReport report = test_adapter(mesh, StripMesh::halfedge(0, 0), {150, seed++});
    EXPECT_TRUE(report.kept()) << describe(report.broken) << " (" << report.during << ", operation "
                               << report.operations << ")";
    EXPECT_EQ(report.operations, 150U);
  }
  for (StripMesh mesh : {sample::rectangle(5, 4), sample::torus(6, 5)}) {
    const AdapterReport report = test_adapter(mesh, StripMesh::halfedge(0, 0), {600, 7});
    EXPECT_TRUE(report.kept()) << describe(report.broken);
    EXPECT_GT(report.splits, 100U);
    EXPECT_GT(report.collapses, 40U);
    EXPECT_GT(report.flips, 40U);
  }
}

TEST(TestAdapter, TestsWhatAMeshHas) {
  for (const StripMesh& from : {sample::rectangle(6, 5), sample::torus(7, 5)}) {
    half_edge::OnlyFlips mesh(from);
    const AdapterReport report = test_adapter(mesh, mesh.halfedge(half_edge::first_triangle));
    EXPECT_TRUE(report.kept()) << describe(report.broken) << " (" << report.during << ")";
    EXPECT_GT(report.flips, 50U);
    EXPECT_EQ(report.splits + report.collapses, 0U);
  }
}

enum class Fault {
  none,
  opposite_turns_on,
  opposite_of_boundary_is_itself,
  next_stands_still,
  next_goes_astray,
  triangle_on_boundary,
  colors_differ,
  boundary_is_solid,
  set_one_side,
  set_two_edges,
  set_nothing,
  dead_handle,
  leaves_boundary_always,
  fan_step_mixes_up,
  strip_step_stops,
  one_triangle_number,
  vertex_numbers_of_sides,
  numbers_from_behind,
  another_halfedge,
  insert_solid_chord,
  insert_solid_spoke,
  insert_returns_back,
  insert_exchanges_spokes,
  insert_dashes_more,
  remove_returns_other_spoke,
  remove_returns_back,
  remove_merges_solid,
  remove_dashes_more,
  turn_returns_back,
  turn_dashes,
  turn_twice,
  turn_renames,
  fast_insert_returns_back
};

/// Sides of a mesh of ours, with a fault. `splits_fast` says whether it has the member that split() calls if it exists.
template <bool splits_fast>
class Faulty {
 public:
  using Halfedge = StripMesh::Halfedge;
  using Where = VertexSplit<Halfedge>;

  Faulty(StripMesh mesh, Fault fault) : mesh_(std::move(mesh)), fault_(fault) {}

  [[nodiscard]] Halfedge next(Halfedge h) const {
    if (fault_ == Fault::next_stands_still && is(h, 3, 1)) return h;
    if (fault_ == Fault::next_goes_astray && is(h, 3, 1)) return StripMesh::halfedge(9, 0);
    return named(StripMesh::next(named(h)));
  }
  [[nodiscard]] Halfedge opposite(Halfedge h) const {
    if (fault_ == Fault::opposite_turns_on && is(h, 3, 1)) return StripMesh::next(mesh_.opposite(h));
    if (fault_ == Fault::opposite_of_boundary_is_itself && StripMesh::on_boundary(h)) return h;
    return named(mesh_.opposite(named(h)));
  }
  [[nodiscard]] bool on_boundary(Halfedge h) const {
    return (fault_ == Fault::triangle_on_boundary && is(h, 3, 1)) || StripMesh::on_boundary(named(h));
  }
  [[nodiscard]] bool solid(Halfedge h) const {
    h = named(h);
    if (fault_ == Fault::colors_differ && is(h, 3, 1)) return !mesh_.solid(h);
    if (fault_ == Fault::boundary_is_solid && (StripMesh::on_boundary(h) || StripMesh::on_boundary(mesh_.opposite(h))))
      return true;
    if (fault_ == Fault::set_one_side && mesh_.solid(h) && h.id > mesh_.opposite(h).id) return !lonely_;
    return mesh_.solid(h);
  }
  void set_solid(Halfedge h, bool solid) {
    h = named(h);
    if (fault_ == Fault::set_nothing) return;
    lonely_ = true;
    mesh_.set_solid(h, solid);
    if (fault_ == Fault::set_two_edges && inside(StripMesh::next(h))) mesh_.set_solid(StripMesh::next(h), solid);
  }
  [[nodiscard]] bool alive(Halfedge h) const {
    return fault_ == Fault::dead_handle ? !is(h, 3, 1) : mesh_.alive(named(h));
  }
  [[nodiscard]] bool leaves_boundary(Halfedge h) const {
    return fault_ == Fault::leaves_boundary_always || mesh_.leaves_boundary(named(h));
  }
  [[nodiscard]] FanStep<Halfedge> fan_step(Halfedge h) const {
    const Halfedge second = next(h);
    const Halfedge third = next(second);
    if (fault_ == Fault::fan_step_mixes_up) return {solid(third), solid(second), opposite(third)};
    return {solid(second), solid(third), opposite(third)};
  }
  [[nodiscard]] StripStep<Halfedge> strip_step(Halfedge in) const {
    for (const Halfedge out : {next(in), next(next(in))})
      if (fault_ != Fault::strip_step_stops && solid(out)) return {true, opposite(out)};
    return {};
  }

  [[nodiscard]] std::uint32_t triangle(Halfedge h) const {
    return fault_ == Fault::one_triangle_number ? 0 : numbered(StripMesh::triangle(named(h)));
  }
  [[nodiscard]] Halfedge halfedge(std::uint32_t t) const { return named(StripMesh::halfedge(numbered(t), side_)); }
  [[nodiscard]] bool has_triangle(std::uint32_t t) const { return mesh_.has_triangle(numbered(t)); }
  [[nodiscard]] std::size_t triangle_bound() const { return mesh_.triangle_bound(); }
  [[nodiscard]] std::uint32_t from(Halfedge h) const {
    return fault_ == Fault::vertex_numbers_of_sides ? named(h).id : mesh_.from(named(h));
  }

  Halfedge insert_vertex(Where where) {
    if (fault_ == Fault::insert_exchanges_spokes && where.spokes == Where::Spokes::both)
      std::swap(where.left, where.right);
    const Halfedge chord = mesh_.insert_vertex(where);
    if (fault_ == Fault::insert_solid_chord) make_solid(chord);
    if (fault_ == Fault::insert_solid_spoke)
      make_solid(StripMesh::on_boundary(chord) ? StripMesh::next(mesh_.opposite(chord)) : StripMesh::next(chord));
    if (fault_ == Fault::insert_dashes_more) dash_far_from(chord);
    return fault_ == Fault::insert_returns_back ? mesh_.opposite(chord) : chord;
  }
  Halfedge insert_vertex(Halfedge left, Halfedge right, std::span<const Halfedge> moved) requires splits_fast {
    return mesh_.opposite(mesh_.insert_vertex(left, right, moved));
  }
  Halfedge remove_vertex(Halfedge chord) {
    const Halfedge spoke = mesh_.remove_vertex(chord);
    if (fault_ == Fault::remove_merges_solid) make_solid(spoke);
    if (fault_ == Fault::remove_dashes_more) dash_far_from(spoke);
    if (fault_ == Fault::remove_returns_back) return mesh_.opposite(spoke);
    if (fault_ == Fault::remove_returns_other_spoke)
      return StripMesh::on_boundary(spoke) ? turn_cw(mesh_, spoke) : turn_ccw(mesh_, spoke);
    return spoke;
  }
  Halfedge turn_edge(Halfedge h) {
    Halfedge turned = mesh_.turn_edge(named(h));
    if (fault_ == Fault::another_halfedge) side_ = (side_ + 1) % 3;
    if (fault_ == Fault::turn_dashes) mesh_.set_solid(turned, false);
    if (fault_ == Fault::turn_twice) turned = mesh_.turn_edge(turned);
    if (fault_ == Fault::turn_returns_back) return mesh_.opposite(turned);
    if (fault_ == Fault::turn_renames && !near(turned, 0) && !near(turned, 1)) renamed_ = !renamed_;
    return named(turned);
  }
  // The checks of a StripMesh, as far as they are asked of any mesh.
  friend Refusal check_split(const Faulty& mesh, const Where& where) { return check_split(mesh.mesh_, where); }
  friend Refusal check_collapse(const Faulty& mesh, Halfedge h) { return check_collapse(mesh.mesh_, mesh.named(h)); }
  friend Refusal check_flip(const Faulty& mesh, Halfedge h) { return check_flip(mesh.mesh_, mesh.named(h)); }

 private:
  static bool is(Halfedge h, Triangle t, unsigned side) { return h == StripMesh::halfedge(t, side); }
  /// The other way round too.
  [[nodiscard]] std::uint32_t numbered(std::uint32_t t) const {
    return fault_ == Fault::numbers_from_behind ? static_cast<std::uint32_t>(mesh_.triangle_bound()) - 1 - t : t;
  }
  [[nodiscard]] bool inside(Halfedge h) const {
    return !StripMesh::on_boundary(h) && !StripMesh::on_boundary(mesh_.opposite(h));
  }
  void make_solid(Halfedge h) {
    if (inside(h)) mesh_.set_solid(h, true);
  }
  [[nodiscard]] bool near(Halfedge h, Triangle t) const {
    for (const Halfedge g : {h, mesh_.opposite(h)})
      for (const Halfedge side : {g, StripMesh::next(g), StripMesh::next(StripMesh::next(g))}) {
        const Halfedge across = mesh_.opposite(side);
        if (StripMesh::triangle(side) == t || (!StripMesh::on_boundary(across) && StripMesh::triangle(across) == t))
          return true;
      }
    return false;
  }
  /// An edge that shares no vertex with the edge of h, nor with the triangles at it.
  void dash_far_from(Halfedge h) {
    std::set<Vertex> close{mesh_.from(h), mesh_.to(h)};
    for (const Vertex end : {mesh_.from(h), mesh_.to(h)})
      for_each_spoke(mesh_, end, [&](Halfedge g) { close.insert(mesh_.to(g)); });
    for (const Halfedge g : sample::sides_of(mesh_))
      if (mesh_.solid(g) && close.count(mesh_.from(g)) == 0 && close.count(mesh_.to(g)) == 0)
        return mesh_.set_solid(g, false);
  }
  /// Triangles 0 and 1 have exchanged their names.
  [[nodiscard]] Halfedge named(Halfedge h) const {
    if (!renamed_ || StripMesh::on_boundary(h) || StripMesh::triangle(h) > 1) return h;
    return StripMesh::halfedge(1 - StripMesh::triangle(h), StripMesh::side(h));
  }

  StripMesh mesh_;
  Fault fault_;
  unsigned side_ = 0;
  bool lonely_ = false;
  bool renamed_ = false;
};

template <bool splits_fast = false>
AdapterReport report_of(Fault fault, const StripMesh& start) {
  Faulty<splits_fast> mesh(start, fault);
  return test_adapter(mesh, StripMesh::halfedge(0, 0), {600, 3});
}

void expect_reported(Fault fault, Contract line, const std::string& during) {
  const AdapterReport report = report_of(fault, sample::rectangle(7, 6));
  EXPECT_EQ(describe(report.broken), std::string(describe(line))) << "fault " << static_cast<int>(fault);
  EXPECT_EQ(report.during, during) << "fault " << static_cast<int>(fault);
}

TEST(TestAdapter, ReportsTheBrokenLine) {
  const AdapterReport good = report_of(Fault::none, sample::rectangle(7, 6));
  ASSERT_TRUE(good.kept()) << describe(good.broken);
  const std::string first = "the mesh as it is given";
  expect_reported(Fault::opposite_turns_on, Contract::opposite_is_involution, first);
  expect_reported(Fault::opposite_of_boundary_is_itself, Contract::opposite_is_involution, first);
  expect_reported(Fault::next_stands_still, Contract::triangle_of_three, first);
  expect_reported(Fault::next_goes_astray, Contract::triangle_of_three, first);
  expect_reported(Fault::triangle_on_boundary, Contract::triangle_has_no_boundary, first);
  expect_reported(Fault::colors_differ, Contract::same_color_on_both_sides, first);
  expect_reported(Fault::boundary_is_solid, Contract::boundary_is_dashed, first);
  expect_reported(Fault::set_one_side, Contract::set_solid_sets, "set_solid");
  expect_reported(Fault::set_two_edges, Contract::set_solid_sets_one, "set_solid");
  expect_reported(Fault::set_nothing, Contract::set_solid_sets, "set_solid");
  expect_reported(Fault::dead_handle, Contract::alive_knows, first);
  expect_reported(Fault::leaves_boundary_always, Contract::leaves_boundary_knows, first);
  expect_reported(Fault::one_triangle_number, Contract::triangle_numbers, first);
  expect_reported(Fault::vertex_numbers_of_sides, Contract::vertex_numbers, first);
  expect_reported(Fault::numbers_from_behind, Contract::numbers_stay, "insert_vertex");
  expect_reported(Fault::another_halfedge, Contract::numbers_stay, "turn_edge");
  expect_reported(Fault::insert_solid_chord, Contract::new_edges_dashed, "insert_vertex");
  expect_reported(Fault::insert_solid_spoke, Contract::new_edges_dashed, "insert_vertex");
  expect_reported(Fault::insert_returns_back, Contract::chord_between_new_ends, "insert_vertex");
  expect_reported(Fault::insert_exchanges_spokes, Contract::chord_between_new_ends, "insert_vertex");
  expect_reported(Fault::insert_dashes_more, Contract::other_colors_stay, "insert_vertex");
  expect_reported(Fault::remove_returns_other_spoke, Contract::spoke_to_apex, "remove_vertex");
  expect_reported(Fault::remove_returns_back, Contract::spoke_to_apex, "remove_vertex");
  expect_reported(Fault::remove_merges_solid, Contract::merged_edges_dashed, "remove_vertex");
  expect_reported(Fault::remove_dashes_more, Contract::other_colors_stay, "remove_vertex");
  expect_reported(Fault::turn_returns_back, Contract::edge_turned, "turn_edge");
  expect_reported(Fault::turn_dashes, Contract::other_colors_stay, "turn_edge");
  expect_reported(Fault::turn_twice, Contract::edge_turned, "turn_edge");
  expect_reported(Fault::turn_renames, Contract::handles_stay, "turn_edge");
}

// These depend on colours that only some operation makes.
TEST(TestAdapter, ReportsFaultsThatShowLater) {
  EXPECT_EQ(report_of(Fault::fan_step_mixes_up, sample::torus(7, 6)).broken, Contract::fan_step_agrees);
  EXPECT_EQ(report_of(Fault::strip_step_stops, sample::torus(7, 6)).broken, Contract::strip_step_agrees);
  // split() alone calls this member.
  const AdapterReport report = report_of<true>(Fault::fast_insert_returns_back, sample::torus(7, 6));
  EXPECT_TRUE(report.broken == Contract::coloring_stays_valid || report.broken == Contract::report_is_true)
      << describe(report.broken);
  EXPECT_EQ(report.during, std::string("split"));
  EXPECT_GT(report.operations, 300U);
}

TEST(TestAdapter, EveryLineHasASentenceOfItsOwn) {
  std::set<std::string> sentences;
  for (int line = 0; line <= static_cast<int>(Contract::changes_named); ++line)
    EXPECT_TRUE(sentences.insert(describe(static_cast<Contract>(line))).second) << line;
  EXPECT_EQ(sentences.count("unknown"), 0U);
}

}  // namespace
}  // namespace restrip
