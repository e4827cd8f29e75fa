// Batches give, byte for byte, the mesh that the same operations give one by one, whatever the order and the number of
// threads; and overlaps are found exactly.
//
// What is compared is the whole mesh (whole_mesh.hpp). What operations overlap is known here from the corners of all
// triangles, read one after the other, and from what an operation really writes when it is done alone.
#include "restrip/operations/batch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "restrip/output/strips.hpp"
#include "sample_meshes.hpp"
#include "whole_mesh.hpp"

namespace restrip {
namespace {

using Halfedge = StripMesh::Halfedge;
using Where = VertexSplit<Halfedge>;
using Spokes = Where::Spokes;

class Chooser {
 public:
  explicit Chooser(unsigned seed) : random(seed) {}

  std::uint32_t pick(std::size_t below) { return static_cast<std::uint32_t>(random() % below); }

  Halfedge any_halfedge(const StripMesh& mesh) {
    for (;;) {
      const Triangle t = pick(mesh.triangle_bound());
      if (!mesh.alive(t)) continue;
      const Halfedge h = StripMesh::halfedge(t, pick(3));
      return pick(4) == 0 ? mesh.opposite(h) : h;
    }
  }

  std::optional<SplitRequest> any_split(const StripMesh& mesh) {
    const Vertex v = mesh.from(any_halfedge(mesh));
    if (mesh.non_manifold(v)) return std::nullopt;
    const std::vector<Halfedge> spokes = sample::spokes_around(mesh, v);
    SplitRequest request;
    request.where = {spokes[pick(spokes.size())], spokes[pick(spokes.size())], Spokes::both};
    if (mesh.leaves_boundary(spokes[0]) && pick(3) == 0)
      request.where.spokes = pick(2) == 0 ? Spokes::left_only : Spokes::right_only;
    if (check_split(mesh, request.where) != Refusal::granted) return std::nullopt;
    return request;
  }

  std::optional<Halfedge> any_collapse(const StripMesh& mesh) {
    const Halfedge h = any_halfedge(mesh);
    return check_collapse(mesh, h) == Refusal::granted ? std::optional(h) : std::nullopt;
  }

  /// Random operations one by one: colours, free handles and valences of all kinds.
  void stir(StripMesh& mesh, std::size_t operations) {
    for (std::size_t n = 0; n < operations; ++n) {
      if (const auto where = any_split(mesh); where && pick(2) == 0)
        split(mesh, where->where);
      else if (const auto chord = any_collapse(mesh))
        collapse(mesh, *chord);
    }
  }

  template <class Request>
  std::vector<Request> disjoint(const StripMesh& mesh, std::size_t tries) {
    std::vector<Request> chosen;
    PatchClaims claims(mesh);
    for (std::size_t n = 0; n < tries; ++n)
      if (const auto request = any<Request>(mesh); request && !claims.claim(*request, chosen.size()))
        chosen.push_back(*request);
    return chosen;
  }

  template <class Request>
  std::optional<Request> any(const StripMesh& mesh) {
    if constexpr (std::is_same_v<Request, SplitRequest>)
      return any_split(mesh);
    else
      return any_collapse(mesh);
  }

  std::mt19937 random;
};

Rewrite<Halfedge> perform(StripMesh& mesh, const SplitRequest& request) {
  return split(mesh, request.where, request.new_vertex);
}
Rewrite<Halfedge> perform(StripMesh& mesh, Halfedge chord) { return collapse(mesh, chord); }

BatchReport batch(StripMesh& mesh, const std::vector<SplitRequest>& requests, const BatchOptions& options = {}) {
  return split_batch(mesh, requests, options);
}
BatchReport batch(StripMesh& mesh, const std::vector<Halfedge>& chords, const BatchOptions& options = {}) {
  return collapse_batch(mesh, chords, options);
}

/// One by one, but in the order given; handles are taken and given back in the order of the list.
void in_order(StripMesh& mesh, const std::vector<SplitRequest>& requests, const std::vector<std::size_t>& order) {
  std::vector<detail::TwoSteps::Room> rooms;
  for (const SplitRequest& request : requests)
    rooms.push_back(detail::TwoSteps::take(mesh, request.where.spokes, request.new_vertex));
  for (const std::size_t i : order) {
    detail::TwoSteps view(mesh, rooms[i]);
    split(view, requests[i].where);
  }
}
void in_order(StripMesh& mesh, const std::vector<Halfedge>& chords, const std::vector<std::size_t>& order) {
  std::vector<detail::TwoSteps::Room> freed(chords.size());
  for (const std::size_t i : order) {
    detail::TwoSteps view(mesh, freed[i]);
    collapse(view, chords[i]);
  }
  for (const auto& room : freed) detail::TwoSteps::give_back(mesh, room);
}

template <class Request>
void compare_all_ways(const StripMesh& start, const std::vector<Request>& requests, Chooser& chooser) {
  StripMesh expected = start;
  std::vector<Rewrite<Halfedge>> rewrites;
  std::int64_t strips = 0;
  std::int64_t isolated = 0;
  for (const Request& request : requests) {
    // Granted before, and still granted.
    ASSERT_EQ(detail::check_request(expected, request), Refusal::granted);
    rewrites.push_back(perform(expected, request));
    strips += rewrites.back().strips;
    isolated += rewrites.back().isolated;
  }
  ASSERT_TRUE(check_coloring(expected).valid);
  const Look wanted = look_at(expected);
  for (const unsigned threads : {1U, 2U, 3U, 8U, 0U}) {
    for (const bool checked : {false, true}) {
      StripMesh mesh = start;
      const BatchReport report = batch(mesh, requests, {threads, checked});
      ASSERT_TRUE(report.done()) << describe(report.fault);
      ASSERT_EQ(look_at(mesh), wanted) << threads << " threads";
      EXPECT_EQ(report.strips, strips);
      EXPECT_EQ(report.isolated, isolated);
      ASSERT_EQ(report.rewrites.size(), rewrites.size());
      for (std::size_t i = 0; i < rewrites.size(); ++i) {
        EXPECT_EQ(report.rewrites[i].halfedge, rewrites[i].halfedge);
        EXPECT_EQ(report.rewrites[i].valence, rewrites[i].valence);
        EXPECT_EQ(report.rewrites[i].strips, rewrites[i].strips);
      }
    }
  }
  std::vector<std::size_t> order(requests.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (int round = 0; round < 4; ++round) {
    StripMesh mesh = start;
    in_order(mesh, requests, order);
    ASSERT_EQ(look_at(mesh), wanted) << "order " << round;
    std::shuffle(order.begin(), order.end(), chooser.random);
  }
}

std::vector<std::pair<std::string, StripMesh>> large_meshes() {
  std::vector<std::pair<std::string, StripMesh>> all;
  all.emplace_back("sphere", sample::sphere(5));
  all.emplace_back("torus", sample::torus(70, 60));
  all.emplace_back("rectangle", sample::rectangle(70, 60));
  all.emplace_back("tube", sample::tube(70, 60));
  all.emplace_back("ribbon", sample::rectangle(2000, 1));
  return all;
}

TEST(Batch, LargeBatchesAreTheSameAsOneByOne) {
  Chooser chooser(1);
  for (auto& [name, mesh] : large_meshes()) {
    SCOPED_TRACE(name);
    chooser.stir(mesh, 3000);
    for (int round = 0; round < 3; ++round) {
      SCOPED_TRACE(round);
      const auto splits = chooser.disjoint<SplitRequest>(mesh, 6000);
      EXPECT_GT(splits.size(), 200U);
      compare_all_ways(mesh, splits, chooser);
      if (HasFatalFailure()) return;
      ASSERT_TRUE(batch(mesh, splits, {2, false}).done());
      const auto collapses = chooser.disjoint<Halfedge>(mesh, 6000);
      EXPECT_GT(collapses.size(), 100U);
      compare_all_ways(mesh, collapses, chooser);
      if (HasFatalFailure()) return;
      ASSERT_TRUE(batch(mesh, collapses, {2, false}).done());
    }
  }
}

TEST(Batch, SplitsWithNamedVertices) {
  Chooser chooser(2);
  StripMesh mesh = sample::rectangle(60, 60);
  chooser.stir(mesh, 2000);
  // Names from the free vertices and beyond the last one, shuffled: later they are in the free list twice.
  std::vector<SplitRequest> splits = chooser.disjoint<SplitRequest>(mesh, 4000);
  std::vector<Vertex> names;
  for (Vertex v = 0; names.size() < splits.size(); ++v)
    if (v >= mesh.vertex_bound() || mesh.spoke(v).id == none) names.push_back(v);
  std::shuffle(names.begin(), names.end(), chooser.random);
  for (std::size_t i = 0; i < splits.size(); ++i) splits[i].new_vertex = names[i];
  compare_all_ways(mesh, splits, chooser);
  const BatchReport up = batch(mesh, splits);
  ASSERT_TRUE(up.done());
  for (std::size_t i = 0; i < splits.size(); ++i) EXPECT_EQ(mesh.to(up.rewrites[i].halfedge), names[i]);
  std::vector<Halfedge> down;
  for (const auto& rewrite : up.rewrites) down.push_back(rewrite.halfedge);
  // The same patches, but two may share an apex now: the most that are compatible.
  std::vector<Halfedge> some;
  PatchClaims claims(mesh);
  for (const Halfedge chord : down)
    if (check_collapse(mesh, chord) == Refusal::granted && !claims.claim(chord, some.size())) some.push_back(chord);
  EXPECT_GT(some.size(), splits.size() / 4);
  compare_all_ways(mesh, some, chooser);
  ASSERT_TRUE(batch(mesh, some).done());
  // Vertices that are free and twice in the list are given once.
  compare_all_ways(mesh, chooser.disjoint<SplitRequest>(mesh, 6000), chooser);
}

TEST(Batch, FansOfAnySize) {
  Chooser chooser(3);
  for (const Vertex k : {9U, 17U, 40U, 63U, 64U, 65U, 300U}) {
    SCOPED_TRACE(k);
    StripMesh mesh = sample::double_cone(k);
    chooser.stir(mesh, 40);
    for (int round = 0; round < 20; ++round) {
      compare_all_ways(mesh, chooser.disjoint<SplitRequest>(mesh, 100), chooser);
      compare_all_ways(mesh, chooser.disjoint<Halfedge>(mesh, 100), chooser);
      if (HasFatalFailure()) return;
      chooser.stir(mesh, 3);
    }
  }
}

TEST(Batch, ManyLargeFansAtTheSameTime) {
  std::vector<sample::Corners> triangles;
  Vertex vertices = 0;
  for (Vertex k = 10; k < 100; ++k) {
    const StripMesh cone = sample::double_cone(k);
    for (Triangle t = 0; t < cone.triangle_bound(); ++t) {
      sample::Corners corners = cone.corners(t);
      for (Vertex& v : corners) v += vertices;
      triangles.push_back(corners);
    }
    vertices += k + 2;
  }
  Chooser chooser(7);
  StripMesh mesh = StripMesh::build(triangles, vertices);
  chooser.stir(mesh, 300);
  for (int round = 0; round < 5; ++round) {
    const auto splits = chooser.disjoint<SplitRequest>(mesh, 3000);
    EXPECT_GT(splits.size(), 90U);
    compare_all_ways(mesh, splits, chooser);
    if (HasFatalFailure()) return;
    ASSERT_TRUE(batch(mesh, splits, {3, false}).done());
    const auto collapses = chooser.disjoint<Halfedge>(mesh, 3000);
    EXPECT_GT(collapses.size(), 32U);
    compare_all_ways(mesh, collapses, chooser);
    if (HasFatalFailure()) return;
  }
}

/// Triangles and vertices as numbers of one set.
using Patch = std::set<std::pair<char, std::uint32_t>>;

void add_fan(const StripMesh& mesh, Vertex v, Patch& patch) {
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (const auto corners = mesh.corners(t); std::find(corners.begin(), corners.end(), v) != corners.end())
      patch.insert({'t', t});
}
bool has_directed_edge(const StripMesh& mesh, Vertex v, Vertex w) {
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    for (unsigned s = 0; s < 3; ++s)
      if (mesh.alive(t) && mesh.corners(t)[s] == v && mesh.corners(t)[(s + 1) % 3] == w) return true;
  return false;
}
Patch patch_of(const StripMesh& mesh, const SplitRequest& request) {
  Patch patch;
  const Vertex v_s = mesh.from(request.where.spokes == Spokes::right_only ? request.where.right : request.where.left);
  add_fan(mesh, v_s, patch);
  if (request.where.spokes != Spokes::right_only)
    if (const Vertex v_l = mesh.to(request.where.left); !has_directed_edge(mesh, v_s, v_l)) patch.insert({'v', v_l});
  if (request.where.spokes != Spokes::left_only)
    if (const Vertex v_r = mesh.to(request.where.right); !has_directed_edge(mesh, v_s, v_r)) patch.insert({'v', v_r});
  if (request.new_vertex != none) patch.insert({'v', request.new_vertex});
  return patch;
}
Patch patch_of(const StripMesh& mesh, Halfedge chord) {
  Patch patch;
  const Vertex v_s = mesh.from(chord);
  const Vertex v_t = mesh.to(chord);
  add_fan(mesh, v_s, patch);
  add_fan(mesh, v_t, patch);
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    const auto corners = mesh.corners(t);
    if (std::find(corners.begin(), corners.end(), v_s) == corners.end()) continue;
    if (std::find(corners.begin(), corners.end(), v_t) == corners.end()) continue;
    for (const Vertex v : corners)
      if (v != v_s && v != v_t) patch.insert({'v', v});
  }
  return patch;
}

/// The first request that overlaps an earlier one, and the first such earlier one.
struct Overlap {
  std::size_t first = 0;
  std::size_t second = 0;
  friend constexpr bool operator==(const Overlap&, const Overlap&) = default;
};

template <class Request>
std::optional<Overlap> overlap_of_claims(const StripMesh& mesh, const std::vector<Request>& requests) {
  PatchClaims claims(mesh);
  for (std::size_t i = 0; i < requests.size(); ++i)
    if (const auto earlier = claims.claim(requests[i], i)) return Overlap{*earlier, i};
  return std::nullopt;
}

template <class Request>
std::optional<Overlap> overlap_from_the_corners(const StripMesh& mesh, const std::vector<Request>& requests) {
  std::vector<Patch> patches;
  for (const Request& request : requests) patches.push_back(patch_of(mesh, request));
  for (std::size_t j = 0; j < requests.size(); ++j)
    for (std::size_t i = 0; i < j; ++i)
      for (const auto& item : patches[i])
        if (patches[j].contains(item)) return Overlap{i, j};
  return std::nullopt;
}

/// A bow tie: the open fans of two rectangles meet in one vertex where the mesh is not manifold.
StripMesh bow_tie() {
  auto triangles = sample::grid(4, 3, false, false, 1);
  for (auto corners : sample::grid(4, 3, false, false, 2)) {
    for (Vertex& v : corners) v = v == 0 ? 0 : v + 20;
    triangles.push_back(corners);
  }
  return StripMesh::build(triangles, 40);
}

std::vector<StripMesh> small_meshes() {
  std::vector<StripMesh> all = sample::meshes();
  all.push_back(bow_tie());
  return all;
}

template <class Request>
void compare_overlaps(StripMesh& mesh, Chooser& chooser, std::size_t& found, std::size_t& clean) {
  for (int round = 0; round < 60; ++round) {
    std::vector<Request> requests;
    const std::size_t count = 2 + chooser.pick(5);
    for (int tries = 0; tries < 100 && requests.size() < count; ++tries)
      if (const auto request = chooser.any<Request>(mesh)) requests.push_back(*request);
    const auto expected = overlap_from_the_corners(mesh, requests);
    ASSERT_EQ(overlap_of_claims(mesh, requests), expected);
    ++(expected ? found : clean);
    StripMesh copy = mesh;
    const BatchReport report = batch(copy, requests, {3, false});
    ASSERT_EQ(report.done(), !expected);
    if (!expected) continue;
    EXPECT_EQ(report.fault, BatchFault::overlap);
    EXPECT_EQ(report.other, expected->first);
    EXPECT_EQ(report.request, expected->second);
    ASSERT_EQ(look_at(copy), look_at(mesh)) << "a batch with a fault changed the mesh";
  }
}

TEST(Batch, OverlapsFollowFromTheCorners) {
  Chooser chooser(4);
  std::size_t found = 0;
  std::size_t clean = 0;
  for (StripMesh& mesh : small_meshes()) {
    for (int round = 0; round < 5; ++round) {
      compare_overlaps<SplitRequest>(mesh, chooser, found, clean);
      compare_overlaps<Halfedge>(mesh, chooser, found, clean);
      if (HasFatalFailure()) return;
      chooser.stir(mesh, 5);
    }
  }
  EXPECT_GT(found, 1000U);
  EXPECT_GT(clean, 300U);
}

TEST(Batch, BoundarySpokesThatMeetInNonManifoldMeshes) {
  // The fans share no triangle, but both splits would look at the first spoke of the middle of the bow tie: they are
  // refused, because it is not to be touched.
  const StripMesh mesh = bow_tie();
  ASSERT_TRUE(mesh.non_manifold(0));
  std::vector<SplitRequest> left;
  std::vector<SplitRequest> right;
  for (Vertex v = 1; v < mesh.vertex_bound(); ++v) {
    if (mesh.spoke(v).id == none) continue;
    const Halfedge inward = mesh.spoke(v, 0);
    if (inward.id == none || !StripMesh::on_boundary(inward)) continue;
    left.push_back({{inward, mesh.spoke(v), Spokes::both}, none});
    right.push_back({{mesh.spoke(v), inward, Spokes::both}, none});
  }
  ASSERT_EQ(left.size(), 2U);
  for (const auto& requests : {left, right, std::vector{left[0], right[1]}}) {
    StripMesh copy = mesh;
    const BatchReport report = batch(copy, requests);
    EXPECT_EQ(report.fault, BatchFault::refused);
    EXPECT_EQ(report.refusal, Refusal::non_manifold_vertex);
    EXPECT_EQ(look_at(copy), look_at(mesh));
  }
}

/// What an operation wrote that was there before.
Patch written(const StripMesh& before, const StripMesh& after) {
  Patch patch;
  for (const Triangle t : differing_triangles(before, after))
    if (before.alive(t)) patch.insert({'t', t});
  for (Vertex v = 0; v < before.vertex_bound(); ++v)
    if (!(before.spoke(v) == after.spoke(v))) patch.insert({'v', v});
  return patch;
}

/// Every pair that does not overlap: the order makes no difference, the second stays granted; and alone each writes
/// nothing outside its claim but the first spokes of the vertices whose whole fan it owns.
template <class Request>
void compare_pairs(const StripMesh& mesh, const std::vector<Request>& requests, std::size_t& pairs) {
  for (std::size_t i = 0; i < requests.size(); ++i) {
    StripMesh alone = mesh;
    perform(alone, requests[i]);
    const Patch claimed = patch_of(mesh, requests[i]);
    for (const auto& [kind, item] : written(mesh, alone)) {
      if (claimed.contains({kind, item})) continue;
      ASSERT_EQ(kind, 'v') << "triangle " << item << " was written and not claimed";
      for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
        if (const auto corners = mesh.corners(t); std::find(corners.begin(), corners.end(), item) != corners.end()) {
          EXPECT_TRUE(claimed.contains({'t', t})) << "the first spoke of " << item << " was written and not claimed";
        }
    }
    for (std::size_t j = i + 1; j < requests.size(); ++j) {
      const std::vector<Request> pair{requests[i], requests[j]};
      if (overlap_of_claims(mesh, pair)) continue;
      ++pairs;
      ASSERT_EQ(detail::check_request(alone, requests[j]), Refusal::granted);
      StripMesh one_by_one = alone;
      perform(one_by_one, requests[j]);
      StripMesh other_way = mesh;
      in_order(other_way, pair, {1, 0});
      ASSERT_EQ(look_at(other_way), look_at(one_by_one));
    }
  }
}

TEST(Batch, AllPairsOnSmallMeshes) {
  Chooser chooser(5);
  std::size_t splits = 0;
  std::size_t collapses = 0;
  for (StripMesh& mesh : small_meshes()) {
    for (int round = 0; round < 3; ++round) {
      std::vector<SplitRequest> requests;
      std::vector<Halfedge> chords;
      for (int n = 0; n < 60; ++n) {
        if (const auto request = chooser.any_split(mesh)) requests.push_back(*request);
        if (const auto chord = chooser.any_collapse(mesh)) chords.push_back(*chord);
      }
      compare_pairs(mesh, requests, splits);
      compare_pairs(mesh, chords, collapses);
      if (HasFatalFailure()) return;
      chooser.stir(mesh, 30);
    }
  }
  EXPECT_GT(splits, 5000U);
  EXPECT_GT(collapses, 2000U);
}

TEST(Batch, FaultsNameTheRequestAndChangeNothing) {
  Chooser chooser(6);
  StripMesh mesh = sample::torus(40, 40);
  chooser.stir(mesh, 200);
  const Look start = look_at(mesh);
  const auto good = chooser.disjoint<SplitRequest>(mesh, 2000);
  ASSERT_GT(good.size(), 100U);
  const auto expect = [&](const std::vector<SplitRequest>& requests, BatchFault fault, std::size_t request,
                          std::size_t other, Refusal refusal) {
    for (const unsigned threads : {1U, 3U}) {
      const BatchReport report = batch(mesh, requests, {threads, false});
      EXPECT_EQ(report.fault, fault);
      EXPECT_EQ(report.request, request);
      EXPECT_EQ(report.other, other);
      EXPECT_EQ(report.refusal, refusal);
      EXPECT_TRUE(report.rewrites.empty());
      EXPECT_EQ(look_at(mesh), start);
    }
  };
  auto requests = good;
  requests[13].where.right = requests[13].where.left;
  expect(requests, BatchFault::refused, 13, 13, Refusal::same_spoke);
  requests[7].where.left = {};
  expect(requests, BatchFault::refused, 7, 7, Refusal::no_such_edge);
  requests[5] = requests[2];
  expect(requests, BatchFault::overlap, 5, 2, Refusal::granted);
  requests = good;
  std::swap(requests[90], requests[40]);
  requests[95] = requests[40];
  requests[99] = requests[1];
  expect(requests, BatchFault::overlap, 95, 40, Refusal::granted);
  requests = good;
  requests[3].new_vertex = static_cast<Vertex>(mesh.vertex_bound());
  expect(requests, BatchFault::mixed_names, 3, 0, Refusal::granted);
  for (std::size_t i = 0; i < requests.size(); ++i)
    requests[i].new_vertex = static_cast<Vertex>(mesh.vertex_bound() + i);
  requests[9].new_vertex = requests[4].new_vertex;
  expect(requests, BatchFault::overlap, 9, 4, Refusal::granted);
  requests[8].new_vertex = mesh.from(requests[0].where.left);
  expect(requests, BatchFault::vertex_in_use, 8, 8, Refusal::granted);
  requests[7].new_vertex = none - 1;
  expect(requests, BatchFault::refused, 7, 7, Refusal::vertex_too_far);

  std::vector<Halfedge> chords = chooser.disjoint<Halfedge>(mesh, 500);
  ASSERT_GT(chords.size(), 10U);
  chords[6] = Halfedge{};
  const BatchReport report = batch(mesh, chords, {2, false});
  EXPECT_EQ(report.fault, BatchFault::refused);
  EXPECT_EQ(report.request, 6U);
  EXPECT_EQ(report.refusal, Refusal::no_such_edge);
  EXPECT_EQ(look_at(mesh), start);

  EXPECT_TRUE(batch(mesh, std::vector<SplitRequest>{}, {2, false}).done());
  EXPECT_TRUE(batch(mesh, std::vector<Halfedge>{}, {2, false}).done());
  EXPECT_EQ(look_at(mesh), start);
}

}  // namespace
}  // namespace restrip
