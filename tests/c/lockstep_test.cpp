// The C interface does what the library does: driven at random under every policy and cost, in step with a StripMesh
// and its keeper, a mesh has the same triangles, colours and index buffers after every operation, and the same
// refusals. What an operation tells is what counting finds, under the bare policy too, which the library does not have.
// A copy of the live buffer that receives only the ranges told draws the triangles of the mesh.
#include <algorithm>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <span>
#include <utility>

#include "handle.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/operations/refine.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/rules/rules.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/stripify.hpp"
#include "runtime/sample_meshes.hpp"

namespace restrip::c_test {
namespace {

using Halfedge = StripMesh::Halfedge;
using Corners = std::array<std::uint32_t, 3>;

constexpr restrip_cost fewest_indices = RESTRIP_FEWEST_INDICES;

struct Move {
  enum class Kind { split, collapse, flip, split_face, join_faces, bisect, merge } kind{};
  restrip_halfedge a = RESTRIP_NONE;
  restrip_halfedge b = RESTRIP_NONE;
};

/// Triangles around an interior vertex; 0 for others.
unsigned valence(const restrip_mesh* mesh, std::uint32_t v) {
  const restrip_halfedge first = restrip_mesh_spoke(mesh, v);
  unsigned n = 0;
  for (restrip_halfedge h = first; h != RESTRIP_NONE; ++n) {
    h = restrip_mesh_opposite(mesh, restrip_mesh_next(mesh, restrip_mesh_next(mesh, h)));
    if (h == first) return n + 1;
  }
  return 0;
}

/// Any halfedges: of the mesh mostly, and now and then any number.
Move draw(const restrip_mesh* mesh, std::mt19937& random) {
  const auto any = [&]() -> restrip_halfedge {
    if (random() % 16 == 0) return random() % 2 == 0 ? RESTRIP_NONE : static_cast<restrip_halfedge>(random());
    const auto h = static_cast<restrip_halfedge>(random() % restrip_mesh_triangle_bound(mesh) * 4 + random() % 3);
    return random() % 4 == 0 && restrip_mesh_opposite(mesh, h) != RESTRIP_NONE ? restrip_mesh_opposite(mesh, h) : h;
  };
  Move move{static_cast<Move::Kind>(random() % 7), any(), RESTRIP_NONE};
  if (move.kind == Move::Kind::join_faces || move.kind == Move::Kind::merge) {
    // Few vertices have so few triangles.
    const unsigned wanted = move.kind == Move::Kind::merge ? 4 : 3;
    for (int tries = 0; tries < 40 && valence(mesh, restrip_mesh_to(mesh, move.a)) != wanted; ++tries) move.a = any();
  }
  if (move.kind != Move::Kind::split) return move;
  move.b = move.a;  // another spoke of the same vertex
  for (auto turns = random() % 5; turns > 0; --turns) {
    const auto next = restrip_mesh_opposite(mesh, restrip_mesh_next(mesh, restrip_mesh_next(mesh, move.b)));
    if (next != RESTRIP_NONE) move.b = next;
  }
  if (random() % 6 == 0) (random() % 2 == 0 ? move.a : move.b) = RESTRIP_NONE;
  return move;
}

restrip_status apply(restrip_mesh* mesh, const Move& move, restrip_change* change) {
  switch (move.kind) {
    case Move::Kind::split:
      return restrip_mesh_split(mesh, move.a, move.b, RESTRIP_NONE, change);
    case Move::Kind::collapse:
      return restrip_mesh_collapse(mesh, move.a, change);
    case Move::Kind::flip:
      return restrip_mesh_flip(mesh, move.a, change);
    case Move::Kind::split_face:
      return restrip_mesh_split_face(mesh, move.a, change);
    case Move::Kind::join_faces:
      return restrip_mesh_join_faces(mesh, move.a, change);
    case Move::Kind::bisect:
      return restrip_mesh_bisect(mesh, move.a, change);
    case Move::Kind::merge:
      break;
  }
  return restrip_mesh_merge(mesh, move.a, change);
}
restrip_status ask(const restrip_mesh* mesh, const Move& move) {
  switch (move.kind) {
    case Move::Kind::split:
      return restrip_mesh_check_split(mesh, move.a, move.b, RESTRIP_NONE);
    case Move::Kind::collapse:
      return restrip_mesh_check_collapse(mesh, move.a);
    case Move::Kind::flip:
      return restrip_mesh_check_flip(mesh, move.a);
    case Move::Kind::split_face:
      return restrip_mesh_check_split_face(mesh, move.a);
    case Move::Kind::join_faces:
      return restrip_mesh_check_join_faces(mesh, move.a);
    case Move::Kind::bisect:
      return restrip_mesh_check_bisect(mesh, move.a);
    case Move::Kind::merge:
      break;
  }
  return restrip_mesh_check_merge(mesh, move.a);
}

Refusal refusal_of(const StripMesh& mesh, const Move& move) {
  const Halfedge h{move.a};
  switch (move.kind) {
    case Move::Kind::collapse:
      return check_collapse(mesh, h);
    case Move::Kind::flip:
      return check_flip(mesh, h);
    case Move::Kind::split_face:
      return check_split_face(mesh, h);
    case Move::Kind::join_faces:
      return check_join_faces(mesh, h);
    case Move::Kind::bisect:
      return check_bisect(mesh, h);
    default:
      return check_merge(mesh, h);
  }
}

/// The operations of refine.hpp, whose halfedge is the same under every policy and cost.
template <class Keeper>
Rewrite<Halfedge> refine(Keeper& keeper, const Move& move) {
  const Halfedge h{move.a};
  const auto by = [&](auto& subject, auto& mesh) {
    if (move.kind == Move::Kind::split_face) return std::pair{subject.split_face(h), split_face(mesh, h)};
    if (move.kind == Move::Kind::join_faces) return std::pair{subject.join_faces(h), join_faces(mesh, h)};
    if (move.kind == Move::Kind::bisect) return std::pair{subject.bisect(h), bisect(mesh, h)};
    return std::pair{subject.merge(h), merge(mesh, h)};
  };
  StripMesh copy = keeper.mesh();
  const auto [done, plain] = by(keeper, copy);
  EXPECT_EQ(done.halfedge, plain.halfedge);
  return done;
}

/// Does the move by the library. The codes 1 to 13 are the refusals in their order.
template <class Keeper>
std::pair<Refusal, Rewrite<Halfedge>> apply(Keeper& keeper, const Move& move) {
  using Spokes = VertexSplit<Halfedge>::Spokes;
  const StripMesh& mesh = keeper.mesh();
  if (move.kind == Move::Kind::split) {
    VertexSplit<Halfedge> where{{move.a}, {move.b}, Spokes::both};
    if (move.b == RESTRIP_NONE)
      where.spokes = Spokes::left_only;
    else if (move.a == RESTRIP_NONE)
      where.spokes = Spokes::right_only;
    const Refusal refusal = check_split(mesh, where);
    return {refusal, refusal == Refusal::granted ? keeper.split(where) : Rewrite<Halfedge>{}};
  }
  const Refusal refusal = refusal_of(mesh, move);
  if (refusal != Refusal::granted) return {refusal, {}};
  if (move.kind == Move::Kind::flip) return {refusal, keeper.flip({move.a})};
  return {refusal, move.kind == Move::Kind::collapse ? keeper.collapse({move.a}) : refine(keeper, move)};
}

std::vector<std::uint32_t> indices_of(const restrip_mesh* mesh) {
  std::size_t count = 0;
  EXPECT_EQ(restrip_mesh_strip_indices_u32(mesh, nullptr, 0, &count), RESTRIP_OK);
  std::vector<std::uint32_t> indices(count + 1);
  EXPECT_EQ(restrip_mesh_strip_indices_u32(mesh, indices.data(), indices.size(), &count), RESTRIP_OK);
  indices.resize(count);
  return indices;
}

struct Told {
  std::size_t done = 0;
  std::set<Move::Kind> kinds;  ///< of which some were done
  std::map<restrip_status, std::size_t> refused;
};

/// What every operation must show, whoever keeps the strips.
void play(restrip_mesh* mesh, std::mt19937& random, int operations, Told& told, const auto& beside) {
  restrip_coloring before = counted(mesh);
  for (int n = 0; n < operations && restrip_mesh_triangle_count(mesh) > 2; ++n) {
    Move move = draw(mesh, random);
    if (restrip_mesh_triangle_count(mesh) > 400 &&
        (move.kind == Move::Kind::split || move.kind == Move::Kind::split_face || move.kind == Move::Kind::bisect))
      move.kind = Move::Kind::collapse;
    const restrip_status expected = ask(mesh, move);
    restrip_change change{};
    const restrip_status status = apply(mesh, move, &change);
    ASSERT_EQ(status, expected);
    ASSERT_EQ(strip_count(mesh), before.strips + static_cast<std::size_t>(change.strips));
    if (status == RESTRIP_OK) {
      ++told.done;
      told.kinds.insert(move.kind);
      const restrip_coloring after = counted(mesh);
      ASSERT_EQ(after.strips, before.strips + static_cast<std::size_t>(change.strips));
      ASSERT_EQ(after.isolated, before.isolated + static_cast<std::size_t>(change.isolated));
    } else {
      ++told.refused[status];
    }
    beside(move, status, change);
    if (testing::Test::HasFatalFailure()) return;
    before = counted(mesh);  // `beside` may have improved the strips
  }
}

template <class Keeper>
void play_beside(restrip_mesh* mesh, Keeper& keeper, std::mt19937& random, Told& told) {
  int n = 0;
  play(mesh, random, 160, told, [&](const Move& move, restrip_status status, const restrip_change& change) {
    const auto [refusal, rewrite] = apply(keeper, move);
    ASSERT_EQ(status, static_cast<restrip_status>(refusal));
    ASSERT_EQ(std::string(restrip_describe(status)), describe(refusal));
    ASSERT_EQ(colors_of(mesh), colors_of(keeper.mesh()));
    if (status == RESTRIP_OK) {
      ASSERT_EQ(change.halfedge, rewrite.halfedge.id);
      ASSERT_EQ(change.valence, rewrite.valence);
      ASSERT_EQ(change.strips, rewrite.strips);
      ASSERT_EQ(change.isolated, rewrite.isolated);
    }
    if (++n % 40 != 0) return;
    std::size_t saved = 0;
    ASSERT_EQ(restrip_mesh_improve(mesh, 500, &saved), RESTRIP_OK);
    ASSERT_EQ(saved, keeper.improve(500));
    ASSERT_EQ(corners_of(mesh), corners_of(keeper.mesh()));
    ASSERT_EQ(indices_of(mesh), strip_indices(keeper.mesh()));
  });
}

TEST(CInterface, IsInStepWithTheLibrary) {
  std::mt19937 random(16);
  Told told;
  for (const StripMesh& start : sample::meshes())
    for (int policy = RESTRIP_POLICY_BARE; policy <= RESTRIP_POLICY_BEST; ++policy)
      for (const bool by_indices : {false, true}) {
        StripMesh mine = start;
        const Handle mesh = handle_of(start);
        const restrip_cost* cost = by_indices ? &fewest_indices : nullptr;
        std::size_t strips = 0;
        const int effort = policy % 2;
        ASSERT_EQ(restrip_mesh_stripify(mesh.get(), effort, cost, 0, &strips), RESTRIP_OK);
        ASSERT_EQ(strips, stripify(mine, static_cast<Effort>(effort), by_indices ? Cost::indices() : Cost::strips()));
        ASSERT_EQ(colors_of(mesh.get()), colors_of(mine));
        ASSERT_EQ(restrip_mesh_keep(mesh.get(), policy, cost), RESTRIP_OK);
        ASSERT_EQ(restrip_mesh_policy(mesh.get()), policy);
        Keeper keeper(mine, static_cast<Policy>(policy), by_indices ? Cost::indices() : Cost::strips());
        play_beside(mesh.get(), keeper, random, told);
        if (HasFatalFailure()) FAIL() << "policy " << policy;
      }
  EXPECT_GT(told.done, 2000U);
  EXPECT_EQ(told.kinds.size(), 7U);
  EXPECT_GE(told.refused.size(), 10U);  // that many ways to be refused were met
}

TEST(CInterface, BareOperationsTellWhatCountingFinds) {
  std::mt19937 random(17);
  Told told;
  for (const StripMesh& start : sample::meshes())
    for (int round = 0; round < 4; ++round) {
      StripMesh mine = start;
      const Handle mesh = handle_of(start);
      ASSERT_EQ(restrip_mesh_keep(mesh.get(), RESTRIP_POLICY_BARE, nullptr), RESTRIP_OK);
      ASSERT_EQ(restrip_mesh_stripify(mesh.get(), RESTRIP_EFFORT_FULL, nullptr, 0, nullptr), RESTRIP_OK);
      Keeper keeper(mine, Policy::local);
      play(mesh.get(), random, 120, told, [&](const Move& move, restrip_status status, const restrip_change& change) {
        const auto [refusal, rewrite] = apply(keeper, move);
        ASSERT_EQ(status, static_cast<restrip_status>(refusal));
        ASSERT_EQ(change.halfedge, status == RESTRIP_OK ? rewrite.halfedge.id : 0);
        ASSERT_EQ(corners_of(mesh.get()), corners_of(mine));
      });
      if (HasFatalFailure()) return;
    }
  EXPECT_GT(told.done, 300U);
  EXPECT_EQ(told.kinds.size(), 7U);
}

/// The triangles that indices draw, each from its smallest corner; a strip's in its turn.
std::vector<Corners> drawn(std::span<const std::uint32_t> indices, std::uint32_t restart, bool list) {
  std::vector<Corners> all;
  std::size_t from = 0;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] == restart) from = i + 1;
    if (indices[i] == restart || i < from + 2 || (list && i % 3 != 2)) continue;
    Corners c{indices[i - 2], indices[i - 1], indices[i]};
    if (!list && (i - from) % 2 != 0) std::swap(c[0], c[1]);
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;
    std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
    all.push_back(c);
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// What a device has: it is told of ranges, and of the length.
template <class Index>
class Device {
 public:
  void follow(restrip_mesh* mesh) {
    const restrip_range* ranges = nullptr;
    std::size_t count = 0;
    const void* indices = nullptr;
    std::size_t size = 0;
    ASSERT_EQ(restrip_live_update(mesh, &ranges, &count), RESTRIP_OK);
    ASSERT_EQ(restrip_live_indices(mesh, &indices, &size), RESTRIP_OK);
    const std::span<const Index> now(static_cast<const Index*>(indices), size);
    copy_.resize(size);
    for (const restrip_range& range : std::span(ranges, count)) {
      ASSERT_LE(range.first + range.count, size);
      std::copy_n(now.begin() + static_cast<std::ptrdiff_t>(range.first), range.count,
                  copy_.begin() + static_cast<std::ptrdiff_t>(range.first));
    }
  }
  [[nodiscard]] std::vector<Corners> drawn(bool list) const {
    return c_test::drawn(copy_, std::numeric_limits<Index>::max(), list);
  }

 private:
  std::vector<std::uint32_t> copy_;
};

template <class Index>
void follow_live_buffer(int form, bool list, std::mt19937& random) {
  const Handle mesh = handle_of(sample::tube(9, 12));
  const auto expect_drawn = [&](Device<Index>& device) {
    device.follow(mesh.get());
    std::vector<Corners> all;
    for (Corners c : corners_of(mesh.get())) {
      if (c[0] == RESTRIP_NONE) continue;
      std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
      all.push_back(c);
    }
    std::sort(all.begin(), all.end());
    ASSERT_EQ(device.drawn(list), all);
  };
  Device<Index> device;
  ASSERT_EQ(restrip_live_begin(mesh.get(), form), RESTRIP_OK);
  for (int round = 0; round < 12; ++round) {
    expect_drawn(device);
    if (round == 4) {
      ASSERT_EQ(restrip_mesh_stripify(mesh.get(), RESTRIP_EFFORT_FULL, nullptr, 0, nullptr), RESTRIP_OK);
    }
    if (round == 8) {
      ASSERT_EQ(restrip_mesh_keep(mesh.get(), RESTRIP_POLICY_QUICK, nullptr), RESTRIP_OK);
    }
    Told told;
    play(mesh.get(), random, 25, told, [](const Move&, restrip_status, const restrip_change&) {});
    if (testing::Test::HasFatalFailure()) return;
  }
  Device<Index> other;  // begun anew in the middle
  ASSERT_EQ(restrip_live_begin(mesh.get(), form), RESTRIP_OK);
  expect_drawn(other);
}

TEST(CInterface, RangesToldAreAllThatChanged) {
  std::mt19937 random(18);
  for (int round = 0; round < 3; ++round) {
    follow_live_buffer<std::uint32_t>(RESTRIP_STRIPS_U32, false, random);
    follow_live_buffer<std::uint16_t>(RESTRIP_STRIPS_U16, false, random);
    follow_live_buffer<std::uint32_t>(RESTRIP_LIST_U32, true, random);
    follow_live_buffer<std::uint16_t>(RESTRIP_LIST_U16, true, random);
  }
}

TEST(CInterface, BuffersOutDrawTheMesh) {
  const Handle mesh = handle_of(sample::sphere(2));
  ASSERT_EQ(restrip_mesh_stripify(mesh.get(), RESTRIP_EFFORT_FULL, &fewest_indices, 0, nullptr), RESTRIP_OK);
  std::vector<std::uint16_t> small(restrip_mesh_triangle_count(mesh.get()) * 4);
  std::size_t count = 0;
  ASSERT_EQ(restrip_mesh_strip_indices_u16(mesh.get(), small.data(), small.size(), &count), RESTRIP_OK);
  small.resize(count);
  EXPECT_EQ(drawn(std::vector<std::uint32_t>(small.begin(), small.end()), 0xFFFF, false),
            drawn(indices_of(mesh.get()), RESTRIP_NONE, false));
  std::vector<std::uint32_t> triangles(restrip_mesh_triangle_count(mesh.get()));
  std::vector<std::size_t> starts(strip_count(mesh.get()) + 1);
  ASSERT_EQ(restrip_mesh_strip_triangles(mesh.get(), triangles.data(), triangles.size(), &count), RESTRIP_OK);
  EXPECT_EQ(count, triangles.size());
  ASSERT_EQ(restrip_mesh_strip_starts(mesh.get(), starts.data(), starts.size(), &count), RESTRIP_OK);
  EXPECT_EQ(count, starts.size());
  ASSERT_EQ(starts.back(), triangles.size());
  // Consecutive triangles of a strip are joined by a solid dual edge, and no others are.
  for (std::size_t s = 0; s + 1 < starts.size(); ++s)
    for (std::size_t i = starts[s]; i < starts[s + 1]; ++i)
      for (std::uint32_t side = 0; side < 3; ++side) {
        const restrip_halfedge h = triangles[i] * 4 + side;
        const std::uint32_t beyond = restrip_mesh_triangle(mesh.get(), restrip_mesh_opposite(mesh.get(), h));
        const bool before = i > starts[s] && triangles[i - 1] == beyond;
        const bool after = i + 1 < starts[s + 1] && triangles[i + 1] == beyond;
        EXPECT_EQ(restrip_mesh_solid(mesh.get(), h) != 0, before || after);
      }
  std::sort(triangles.begin(), triangles.end());
  EXPECT_EQ(std::unique(triangles.begin(), triangles.end()), triangles.end());
}

/// Every place and every pair of masks, one bit too many included, against a rule of the library.
template <class Valid, class Look, class RuleOf>
std::size_t compare_rules(unsigned edges, unsigned ports, Valid&& expected_place, Look&& look, RuleOf&& rule_of) {
  std::size_t answered = 0;
  for (std::uint64_t colors = 0; colors < std::uint64_t{2} << edges; ++colors)
    for (std::uint64_t p = 0; p < std::uint64_t{2} << ports; ++p) {
      restrip_answer answer{};
      const restrip_status status = look(colors, p, &answer);
      if (!expected_place) {
        EXPECT_EQ(status, RESTRIP_BAD_ARGUMENT);
        return 0;
      }
      const Rule rule = rule_of(colors, p);
      EXPECT_EQ(status, rule.valid ? RESTRIP_OK : RESTRIP_BAD_COLORING);
      if (!rule.valid) continue;
      ++answered;
      EXPECT_EQ(answer.colors, rule.colors);
      EXPECT_EQ(answer.ports, p);
      EXPECT_EQ(answer.strips, rule.strips);
    }
  return answered;
}

TEST(CInterface, LookUpsAnswerAsTheRules) {
  std::size_t answered = 0;
  for (std::uint32_t k = 0; k <= 5; ++k)
    for (std::uint32_t i = 0; i <= k + 1; ++i) {
      const bool closed = k >= 3 && i >= 1 && i < k;
      const SplitPosition at{k, i};
      answered += compare_rules(
          k, k, closed, [&](auto c, auto p, auto* a) { return restrip_lookup_split(k, i, c, p, a); },
          [&](auto c, auto p) { return split_rule(at, c, p); });
      answered += compare_rules(
          k + 3, k, closed, [&](auto c, auto p, auto* a) { return restrip_lookup_collapse(k, i, c, p, a); },
          [&](auto c, auto p) { return collapse_rule(at, c, p); });
      const bool gap = k >= 1 && i <= k;
      answered += compare_rules(
          k, k, gap, [&](auto c, auto p, auto* a) { return restrip_lookup_boundary_split(k, i, c, p, a); },
          [&](auto c, auto p) {
            return boundary_split_rule({k, i}, c, p);
          });
      answered += compare_rules(
          k, k, gap, [&](auto c, auto p, auto* a) { return restrip_lookup_boundary_collapse(k, i, c, p, a); },
          [&](auto c, auto p) {
            return boundary_collapse_rule({k, i}, c, p);
          });
      for (std::uint32_t j = 0; j <= k + 1; ++j) {
        const bool gaps = k >= 1 && i < j && j <= k;
        answered += compare_rules(
            k, k, gaps, [&](auto c, auto p, auto* a) { return restrip_lookup_open_split(k, i, j, c, p, a); },
            [&](auto c, auto p) {
              return open_split_rule({k, i, j}, c, p);
            });
        answered += compare_rules(
            k + 2, k, gaps, [&](auto c, auto p, auto* a) { return restrip_lookup_open_collapse(k, i, j, c, p, a); },
            [&](auto c, auto p) {
              return open_collapse_rule({k, i, j}, c, p);
            });
      }
    }
  EXPECT_GT(answered, 10'000U);
  restrip_answer answer{};
  EXPECT_EQ(restrip_lookup_split(62, 3, 0, 0, &answer), RESTRIP_BAD_ARGUMENT);
  ASSERT_EQ(restrip_lookup_split(61, 3, 0, 0, &answer), RESTRIP_OK);
  EXPECT_EQ(answer.colors, split_rule({61, 3}, 0, 0).colors);
  EXPECT_EQ(restrip_lookup_flip(2, 0, &answer), RESTRIP_BAD_COLORING);
  EXPECT_EQ(restrip_lookup_flip(0, 16, &answer), RESTRIP_BAD_COLORING);
  for (unsigned inner = 0; inner < 2; ++inner)
    for (unsigned ports = 0; ports < 16; ++ports) {
      const FlipRule rule = flip_rule(inner != 0, ports);
      ASSERT_EQ(restrip_lookup_flip(inner, ports, &answer), rule.valid ? RESTRIP_OK : RESTRIP_BAD_COLORING);
      if (!rule.valid) continue;
      EXPECT_EQ(answer.colors, rule.inner ? 1U : 0U);
      EXPECT_EQ(answer.ports, rule.ports);
      EXPECT_EQ(answer.strips, rule.strips);
    }
}

}  // namespace
}  // namespace restrip::c_test
