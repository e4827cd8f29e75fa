// The C interface does what the library does: driven at random under every policy and cost, in step with a StripMesh
// and its keeper, a mesh has the same triangles, colours and index buffers after every operation, and the same
// refusals. The reported change is what counting finds. A copy of the live buffer that receives only the reported
// ranges draws the triangles of the mesh, in every form and width.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
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
#include "restrip/search/policy.hpp"
#include "restrip/search/stripify.hpp"
#include "runtime/form_reader.hpp"
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

/// Any halfedges: mostly of the mesh, occasionally any number.
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

/// The operations that take one halfedge: all but the split, in the order of their kinds.
struct AtHalfedge {
  restrip_status (*apply)(restrip_mesh*, restrip_halfedge, restrip_change*);
  Refusal (*refusal)(const StripMesh&, Halfedge);
};
constexpr std::array<AtHalfedge, 6> at_halfedge{{
    {restrip_mesh_collapse, check_collapse},
    {restrip_mesh_flip, check_flip},
    {restrip_mesh_split_face, [](const StripMesh& m, Halfedge h) { return check_apply(m, split_face_at(m, h)); }},
    {restrip_mesh_join_faces, [](const StripMesh& m, Halfedge h) { return check_apply(m, join_faces_at(m, h)); }},
    {restrip_mesh_bisect, [](const StripMesh& m, Halfedge h) { return check_apply(m, bisect_at(m, h)); }},
    {restrip_mesh_merge, [](const StripMesh& m, Halfedge h) { return check_apply(m, merge_at(m, h)); }},
}};
const AtHalfedge& row_of(const Move& move) { return at_halfedge.at(static_cast<std::size_t>(move.kind) - 1); }

restrip_status apply(restrip_mesh* mesh, const Move& move, restrip_change* change) {
  if (move.kind == Move::Kind::split) return restrip_mesh_split(mesh, move.a, move.b, RESTRIP_NONE, change);
  return row_of(move).apply(mesh, move.a, change);
}
restrip_status ask_at(const restrip_mesh* mesh, std::int32_t operation, restrip_halfedge h) {
  restrip_status status = RESTRIP_UNEXPECTED;
  EXPECT_EQ(restrip_mesh_check_each(mesh, operation, 1, &h, &status), RESTRIP_OK);
  return status;
}
restrip_status ask(const restrip_mesh* mesh, const Move& move) {
  if (move.kind == Move::Kind::split) return restrip_mesh_check_split(mesh, move.a, move.b, RESTRIP_NONE);
  return ask_at(mesh, static_cast<std::int32_t>(move.kind) - 1, move.a);
}

/// The operations of refine.hpp, whose halfedge is the same under every policy and cost.
template <class Keeper>
Rewrite refine(Keeper& keeper, const Move& move) {
  const Halfedge h{move.a};
  const auto at = move.kind == Move::Kind::split_face   ? split_face_at(keeper.mesh(), h)
                  : move.kind == Move::Kind::join_faces ? join_faces_at(keeper.mesh(), h)
                  : move.kind == Move::Kind::bisect     ? bisect_at(keeper.mesh(), h)
                                                        : merge_at(keeper.mesh(), h);
  StripMesh copy = keeper.mesh();
  const Rewrite plain = apply(copy, at.table, at.where);
  const Rewrite done = keeper.apply(at.table, at.where);
  EXPECT_EQ(done.halfedge, plain.halfedge);
  return done;
}

/// Does the move by the library. The codes 1 to 13 are the refusals in their order.
template <class Keeper>
std::pair<Refusal, Rewrite> apply(Keeper& keeper, const Move& move) {
  using Spokes = VertexSplit::Spokes;
  const StripMesh& mesh = keeper.mesh();
  if (move.kind == Move::Kind::split) {
    VertexSplit where{{move.a}, {move.b}, Spokes::both};
    if (move.b == RESTRIP_NONE)
      where.spokes = Spokes::left_only;
    else if (move.a == RESTRIP_NONE)
      where.spokes = Spokes::right_only;
    const Refusal refusal = check_split(mesh, where);
    return {refusal, refusal == Refusal::granted ? keeper.split(where) : Rewrite{}};
  }
  const Refusal refusal = row_of(move).refusal(mesh, {move.a});
  if (refusal != Refusal::granted) return {refusal, {}};
  if (move.kind == Move::Kind::flip) return {refusal, keeper.flip({move.a})};
  return {refusal, move.kind == Move::Kind::collapse ? keeper.collapse({move.a}) : refine(keeper, move)};
}

struct Tally {
  std::size_t done = 0;
  std::set<Move::Kind> kinds;  ///< of which some were done
  std::map<restrip_status, std::size_t> refused;
};

/// Properties of every operation, under every policy.
void play(restrip_mesh* mesh, std::mt19937& random, int operations, Tally& reported, const auto& after_each) {
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
      ++reported.done;
      reported.kinds.insert(move.kind);
      const restrip_coloring after = counted(mesh);
      ASSERT_EQ(after.strips, before.strips + static_cast<std::size_t>(change.strips));
      ASSERT_EQ(after.isolated, before.isolated + static_cast<std::size_t>(change.isolated));
    } else {
      ++reported.refused[status];
    }
    after_each(move, status, change);
    if (testing::Test::HasFatalFailure()) return;
    before = counted(mesh);  // `after_each` may have improved the strips
  }
}

void play(restrip_mesh* mesh, std::mt19937& random, int operations) {
  Tally reported;
  play(mesh, random, operations, reported, [](const Move&, restrip_status, const restrip_change&) {});
}

template <class Keeper>
void play_beside(restrip_mesh* mesh, Keeper& keeper, std::mt19937& random, Tally& reported) {
  int n = 0;
  play(mesh, random, 160, reported, [&](const Move& move, restrip_status status, const restrip_change& change) {
    const auto [refusal, rewrite] = apply(keeper, move);
    ASSERT_EQ(status == RESTRIP_OK, refusal == Refusal::granted);
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
    ASSERT_EQ(strips_of(mesh), strip_indices(keeper.mesh()));
  });
}

TEST(CInterface, IsInStepWithTheLibrary) {
  std::mt19937 random(16);
  Tally reported;
  for (const StripMesh& start : sample::meshes())
    for (int policy = RESTRIP_POLICY_BARE; policy < static_cast<int>(policies.size()); ++policy)
      for (const bool by_indices : {false, true}) {
        StripMesh mine = start;
        const Handle mesh = handle_of(start);
        const restrip_cost* cost = by_indices ? nullptr : &fewest_strips;
        std::size_t strips = 0;
        const int effort = policy % 2;
        ASSERT_EQ(restrip_mesh_stripify(mesh.get(), effort, cost, 0, &strips), RESTRIP_OK);
        ASSERT_EQ(strips, stripify(mine, static_cast<Effort>(effort), by_indices ? Cost::indices() : Cost::strips()));
        ASSERT_EQ(colors_of(mesh.get()), colors_of(mine));
        ASSERT_EQ(restrip_mesh_keep(mesh.get(), policy, cost), RESTRIP_OK);
        ASSERT_EQ(restrip_mesh_policy(mesh.get()), policy);
        Keeper keeper(mine, static_cast<Policy>(policy), by_indices ? Cost::indices() : Cost::strips());
        play_beside(mesh.get(), keeper, random, reported);
        if (HasFatalFailure()) FAIL() << "policy " << policy;
      }
  EXPECT_GT(reported.done, 2000U);
  EXPECT_EQ(reported.kinds.size(), 7U);
  EXPECT_GE(reported.refused.size(), 10U);  // the number of different refusals
}

form_reader::Triangles sorted_triangles(const restrip_mesh* mesh) {
  std::vector<Corners> all = corners_of(mesh);
  std::erase_if(all, [](const Corners& c) { return c[0] == RESTRIP_NONE; });
  return sample::sorted(std::move(all));
}

/// Copies the ranges to a buffer on a device.
void upload(const void* indices, std::span<const restrip_range> ranges, std::size_t width,
            std::vector<std::byte>& device) {
  for (const restrip_range& range : ranges) {
    ASSERT_LE((range.first + range.count) * width, device.size());
    std::copy_n(static_cast<const std::byte*>(indices) + range.first * width, range.count * width,
                device.begin() + static_cast<std::ptrdiff_t>(range.first * width));
  }
}

form_reader::Triangles read_view(const void* indices, std::size_t bytes, const restrip_buffer_view& view) {
  const auto width = static_cast<std::size_t>(view.index_bits) / 8;
  form_reader::Reader reader({static_cast<const std::byte*>(indices), bytes}, width);
  for (const restrip_range& draw : std::span(view.draws, view.draw_count)) {
    if (view.form == RESTRIP_FORM_LIST)
      reader.list(draw.first, draw.count);
    else
      reader.strip(draw.first, draw.count, view.form == RESTRIP_FORM_RESTART);
  }
  return std::move(reader).triangles();
}

/// All observable state of a mesh and its buffer.
struct Sight {
  std::vector<Corners> corners;
  std::vector<std::uint8_t> colors;
  std::size_t strips;
  explicit Sight(restrip_mesh* mesh) : corners(corners_of(mesh)), colors(colors_of(mesh)), strips(strip_count(mesh)) {}
  bool operator==(const Sight&) const = default;
};

/// A frame of everything that changes a mesh. Returns what was reported.
std::vector<std::int64_t> frame(restrip_mesh* mesh, std::mt19937& random) {
  std::vector<std::int64_t> reported;
  for (auto n = 1 + random() % 9; n > 0; --n) {
    restrip_change change{};
    const restrip_status status = apply(mesh, draw(mesh, random), &change);
    reported.insert(reported.end(), {status, change.halfedge, change.strips, change.isolated});
  }
  std::size_t number = 0;
  if (random() % 3 == 0) {
    EXPECT_EQ(restrip_mesh_improve(mesh, random() % 2000, &number), RESTRIP_OK);
  }
  if (random() % 4 == 0) {
    EXPECT_EQ(restrip_mesh_stripify(mesh, random() % 2, nullptr, 0, nullptr), RESTRIP_OK);
  }
  updated(mesh);
  reported.push_back(static_cast<std::int64_t>(number));
  return reported;
}

/// Undo and saving restore triangles, colours and strips.
TEST(CInterface, UndoAndSavingRestoreTheMesh) {
  std::mt19937 random(41);
  for (int policy = RESTRIP_POLICY_BARE; policy <= RESTRIP_POLICY_FULL; ++policy)
    for (const restrip_cost* cost : {&fewest_strips, &fewest_indices}) {
      Handle mesh = handle_of(sample::tube(9, 12));
      {
        ASSERT_EQ(restrip_mesh_stripify(mesh.get(), RESTRIP_EFFORT_FAST, cost, 0, nullptr), RESTRIP_OK);
        ASSERT_EQ(restrip_mesh_keep(mesh.get(), policy, cost), RESTRIP_OK);
        ASSERT_EQ(begin_live(mesh.get(), policy % 3, 0, 1'000'000), RESTRIP_OK);
        updated(mesh.get());
      }
      for (int round = 0; round < 12; ++round) {
        restrip_mesh* const one = mesh.get();
        std::size_t before = 0;
        std::size_t undoable = 0;
        std::size_t redoable = 0;
        ASSERT_EQ(restrip_live_history_size(one, &before, &redoable), RESTRIP_OK);
        for (auto n = random() % 3; n > 0; --n) {
          const Sight start(one);
          std::uint32_t v = 0;  // a change, so that there is a frame
          while (restrip_mesh_bisect(one, restrip_mesh_spoke(one, v), nullptr) != RESTRIP_OK) ++v;
          frame(one, random);
          ASSERT_EQ(restrip_live_history_size(one, &undoable, &redoable), RESTRIP_OK);
          ASSERT_GT(undoable, before);
          const Sight end(one);
          const auto go = [&](restrip_status (*step)(restrip_mesh*, std::int32_t*), std::size_t frames) {
            std::int32_t done = 1;
            for (; frames > 0; --frames) ASSERT_EQ(step(one, &done), RESTRIP_OK);
            ASSERT_EQ(done, 1);
          };
          go(restrip_live_undo, undoable - before);
          ASSERT_EQ(Sight(one), start);
          ASSERT_EQ(restrip_live_history_size(one, &undoable, &redoable), RESTRIP_OK);
          ASSERT_EQ(undoable, before);
          go(restrip_live_redo, redoable);
          ASSERT_EQ(corners_of(one), end.corners);
          ASSERT_EQ(colors_of(one), end.colors);
          std::int32_t more = 1;
          ASSERT_EQ(restrip_live_redo(one, &more), RESTRIP_OK);
          ASSERT_EQ(more, 0);
          go(restrip_live_undo, redoable);
          ASSERT_EQ(Sight(one), start);
        }
        frame(one, random);
        if (round % 4 != 3) continue;
        const void* bytes = nullptr;
        std::size_t size = 0;
        restrip_mesh* loaded = nullptr;
        ASSERT_EQ(restrip_mesh_save(one, &bytes, &size), RESTRIP_OK);
        ASSERT_EQ(restrip_mesh_load(bytes, size, 1'000'000, nullptr, 0, &loaded), RESTRIP_OK);
        ASSERT_EQ(restrip_mesh_policy(loaded), policy);
        ASSERT_EQ(Sight(one), Sight(loaded));
        mesh.reset(loaded);
      }
    }
}

TEST(CInterface, DamagedSavesAreRefused) {
  const Handle mesh = handle_of(sample::octahedron());
  const void* bytes = nullptr;
  std::size_t size = 0;
  ASSERT_EQ(restrip_mesh_save(mesh.get(), &bytes, &size), RESTRIP_OK);
  std::string saved(static_cast<const char*>(bytes), size);
  restrip_mesh* loaded = mesh.get();
  char text[100];
  EXPECT_EQ(restrip_mesh_load(saved.data(), size - 1, 0, text, sizeof text, &loaded), RESTRIP_BAD_FILE);
  EXPECT_EQ(loaded, nullptr);
  EXPECT_NE(std::string(text).find("truncated"), std::string::npos);
  saved[size / 2] = static_cast<char>(saved[size / 2] ^ 1);
  EXPECT_EQ(restrip_mesh_load(saved.data(), size, 0, nullptr, 0, &loaded), RESTRIP_BAD_FILE);
  EXPECT_EQ(restrip_mesh_load("ply", 3, 0, text, sizeof text, &loaded), RESTRIP_BAD_FILE);
  EXPECT_NE(std::string(text).find("not a saved"), std::string::npos);
}

/// Settings of the layout reach the buffer: without tolerance it is shorter, and a small cache gives another order.
TEST(CInterface, LayoutsAreSettings) {
  const auto length = [](const restrip_layout* layout) {
    std::mt19937 random(43);
    const Handle mesh = handle_of(sample::torus(30, 30));
    EXPECT_EQ(restrip_mesh_stripify(mesh.get(), RESTRIP_EFFORT_FAST, nullptr, 0, nullptr), RESTRIP_OK);
    EXPECT_EQ(restrip_live_begin(mesh.get(), nullptr, layout, 0), RESTRIP_OK);
    for (int round = 0; round < 30; ++round) {
      updated(mesh.get());
      play(mesh.get(), random, 10);
    }
    updated(mesh.get());
    return live_view(mesh.get()).index_count;
  };
  const restrip_layout tight{0, 0, 100};
  const restrip_layout loose{32, 500, 0};
  EXPECT_LT(length(&tight), length(nullptr));
  EXPECT_LT(length(nullptr), length(&loose));
}

/// Every form and width, of a live buffer after random operations, of a mesh and of a list.
TEST(CInterface, BuffersInEveryForm) {
  std::mt19937 random(31);
  for (std::int32_t form = RESTRIP_FORM_RESTART; form <= RESTRIP_FORM_LIST; ++form)
    for (const std::int32_t bits : {0, 16, 32}) {
      const Handle mesh = handle_of(sample::tube(9, 12));
      ASSERT_EQ(begin_live(mesh.get(), form, bits), RESTRIP_OK);
      std::vector<std::byte> device;
      restrip_buffer_view view{};
      for (int round = 0; round < 20; ++round) {
        const restrip_range* ranges = nullptr;
        std::size_t count = 0;
        std::int32_t outgrown = 0;
        std::size_t room = 0;
        ASSERT_EQ(restrip_live_update(mesh.get(), 9, 16, &ranges, &count, &outgrown), RESTRIP_OK);
        ASSERT_EQ(restrip_live_buffer(mesh.get(), &view, &room), RESTRIP_OK);
        const auto width = static_cast<std::size_t>(view.index_bits) / 8;
        ASSERT_EQ(width, bits == 32 ? 4U : 2U);
        ASSERT_EQ(view.form, form);
        if (outgrown != 0) device.assign(room * width, std::byte{1});
        for (const restrip_range& range : std::span(ranges, count)) ASSERT_EQ(range.first * width % 16, 0U);
        upload(view.indices, {ranges, count}, width, device);
        ASSERT_EQ(read_view(device.data(), view.index_count * width, view), sorted_triangles(mesh.get()));
        if (round == 8) {
          ASSERT_EQ(restrip_mesh_stripify(mesh.get(), RESTRIP_EFFORT_FULL, &fewest_strips, 0, nullptr), RESTRIP_OK);
        }
        if (round == 12) {
          ASSERT_EQ(restrip_mesh_keep(mesh.get(), RESTRIP_POLICY_LOCAL, &fewest_strips), RESTRIP_OK);
        }
        play(mesh.get(), random, 8);
      }
      ASSERT_EQ(restrip_mesh_stripify(mesh.get(), RESTRIP_EFFORT_FAST, &fewest_indices, 0, nullptr), RESTRIP_OK);
      std::vector<std::uint32_t> list;
      for (const Corners& c : sorted_triangles(mesh.get())) list.insert(list.end(), c.begin(), c.end());
      const std::vector<std::uint16_t> narrow(list.begin(), list.end());
      const std::size_t vertices = restrip_mesh_vertex_bound(mesh.get());
      for (const std::size_t most : {0U, 40U}) {
        const restrip_format wanted{form, bits, most, most, 1};
        const restrip_cache cache{16, 0};
        for (int source = 0; source < 5; ++source) {
          restrip_buffer* buffer = nullptr;
          const restrip_status status =
              source < 2   ? restrip_mesh_buffer(mesh.get(), source == 0 ? nullptr : &cache, &wanted, &buffer)
              : source < 4 ? restrip_strips_of_u32(list.data(), list.size(), vertices, RESTRIP_EFFORT_FAST, nullptr,
                                                   source == 2 ? nullptr : &cache, &wanted, &buffer)
                           : restrip_strips_of_u16(narrow.data(), list.size(), vertices, RESTRIP_EFFORT_FULL,
                                                   &fewest_indices, nullptr, &wanted, &buffer);
          ASSERT_EQ(status, RESTRIP_OK);
          ASSERT_EQ(restrip_buffer_read(buffer, &view), RESTRIP_OK);
          ASSERT_EQ(view.form, form);
          ASSERT_EQ(view.triangles, list.size() / 3);
          ASSERT_EQ(read_view(view.indices, view.index_count * static_cast<std::size_t>(view.index_bits) / 8, view),
                    sorted_triangles(mesh.get()));
          for (const restrip_range& draw : std::span(view.draws, view.draw_count))
            ASSERT_TRUE(most == 0 || draw.count <= most);
          restrip_buffer_free(buffer);
        }
      }
    }
  // Triangles without neighbours become a list, which is reported.
  const std::vector<std::uint32_t> islands{0, 1, 2, 3, 4, 5};
  restrip_buffer* buffer = nullptr;
  restrip_buffer_view view{};
  ASSERT_EQ(restrip_strips_of_u32(islands.data(), 6, 6, RESTRIP_EFFORT_FAST, nullptr, nullptr, nullptr, &buffer),
            RESTRIP_OK);
  ASSERT_EQ(restrip_buffer_read(buffer, &view), RESTRIP_OK);
  EXPECT_EQ(view.form, RESTRIP_FORM_LIST);
  EXPECT_EQ(view.index_bits, 16);
  EXPECT_EQ(view.index_count, 6U);
  restrip_buffer_free(buffer);
}

/// Large vertex numbers are renumbered or refused before memory is allocated.
TEST(CInterface, VertexNumbersTakeNoMemory) {
  constexpr std::uint32_t far = 4'000'000'000;
  const std::vector<std::uint32_t> list{0, 1, far, far, 1, 70'000, far, 70'000, far + 1, 5, 5, 1, 0, 1, 4'294'967'294};
  restrip_mesh* mesh = nullptr;
  for (const std::size_t vertices : {std::size_t{536'870'912}, std::size_t{far} + 2, SIZE_MAX})
    EXPECT_EQ(restrip_mesh_build_u32(list.data(), list.size(), vertices, nullptr, nullptr, &mesh), RESTRIP_TOO_LARGE);
  EXPECT_EQ(mesh, nullptr);
  restrip_buffer* buffer = nullptr;
  restrip_format format{RESTRIP_FORM_RESTART, 0, 0, 0, 1};
  EXPECT_EQ(restrip_strips_of_u32(list.data(), list.size(), std::size_t{RESTRIP_NONE} + 1, RESTRIP_EFFORT_FAST, nullptr,
                                  nullptr, &format, &buffer),
            RESTRIP_TOO_LARGE);
  for (const std::int32_t form : {RESTRIP_FORM_RESTART, RESTRIP_FORM_STITCHED, RESTRIP_FORM_LENGTHS, RESTRIP_FORM_LIST})
    for (const std::size_t vertices : {std::size_t{far} + 2, std::size_t{far} + 1}) {
      format.form = form;
      ASSERT_EQ(restrip_strips_of_u32(list.data(), list.size(), vertices, RESTRIP_EFFORT_FAST, nullptr, nullptr,
                                      &format, &buffer),
                RESTRIP_OK);
      restrip_buffer_view view{};
      ASSERT_EQ(restrip_buffer_read(buffer, &view), RESTRIP_OK);
      EXPECT_EQ(view.index_bits, 32);
      std::vector<Corners> expected{{0, 1, far}, {1, 70'000, far}};
      if (vertices > far + 1) expected.push_back({70'000, far + 1, far});
      EXPECT_EQ(read_view(view.indices, 4 * view.index_count, view), expected);
      restrip_buffer_free(buffer);
    }
  const std::vector<std::uint16_t> narrow{0, 1, 2};  // far below the number of vertices
  ASSERT_EQ(
      restrip_strips_of_u16(narrow.data(), 3, RESTRIP_NONE, RESTRIP_EFFORT_FAST, nullptr, nullptr, nullptr, &buffer),
      RESTRIP_OK);
  restrip_buffer_free(buffer);
}

TEST(CInterface, FormatsAreChecked) {
  const Handle mesh = handle_of(sample::octahedron());
  restrip_buffer* buffer = nullptr;
  const std::vector<std::uint32_t> far{0, 1, 70'000};
  const auto status_of = [&](restrip_format format) {
    return restrip_strips_of_u32(far.data(), 3, 70'001, RESTRIP_EFFORT_FAST, nullptr, nullptr, &format, &buffer);
  };
  EXPECT_EQ(status_of({RESTRIP_FORM_LIST, 16, 0, 0, 0}), RESTRIP_TOO_LARGE);
  EXPECT_EQ(buffer, nullptr);
  for (const restrip_format bad :
       {restrip_format{4, 0, 0, 0, 0}, {-1, 0, 0, 0, 0}, {0, 8, 0, 0, 0}, {0, 0, 2, 0, 0}, {0, 0, 0, 3, 0}})
    EXPECT_EQ(status_of(bad), RESTRIP_BAD_ARGUMENT);
  const restrip_format batches{RESTRIP_FORM_RESTART, 0, 64, 0, 0};
  EXPECT_EQ(restrip_live_begin(mesh.get(), &batches, nullptr, 0), RESTRIP_BAD_ARGUMENT);
  for (const std::size_t most : {std::size_t{3}, SIZE_MAX / 2 + 1, SIZE_MAX - 3}) {  // whose sum is 0, among others
    const restrip_format opposite{RESTRIP_FORM_RESTART, 32, most, 0 - most, 0};
    EXPECT_EQ(restrip_live_begin(mesh.get(), &opposite, nullptr, 0), RESTRIP_BAD_ARGUMENT);
  }
  ASSERT_EQ(restrip_live_begin(mesh.get(), nullptr, nullptr, 0), RESTRIP_OK);
  const restrip_range* ranges = nullptr;
  std::size_t count = 0;
  for (const std::size_t align : {0U, 3U, 6U})
    EXPECT_EQ(restrip_live_update(mesh.get(), 0, align, &ranges, &count, nullptr), RESTRIP_BAD_ARGUMENT);
  for (const double weight : {-1.0, 1000.5, std::nan("")}) {
    const restrip_cache cache{16, weight};
    EXPECT_EQ(restrip_mesh_buffer(mesh.get(), &cache, nullptr, &buffer), RESTRIP_BAD_ARGUMENT);
    EXPECT_EQ(restrip_strips_of_u32(far.data(), 3, 70'001, RESTRIP_EFFORT_FAST, nullptr, &cache, nullptr, &buffer),
              RESTRIP_BAD_ARGUMENT);
  }
  EXPECT_EQ(restrip_mesh_buffer(nullptr, nullptr, nullptr, &buffer), RESTRIP_NULL_ARGUMENT);
  EXPECT_EQ(restrip_buffer_read(nullptr, nullptr), RESTRIP_NULL_ARGUMENT);
  restrip_buffer_free(nullptr);
  for (const restrip_layout bad : {restrip_layout{65, 95, 5}, {32, 1'000'001, 5}, {32, 95, 101}})
    EXPECT_EQ(restrip_live_begin(mesh.get(), nullptr, &bad, 0), RESTRIP_BAD_ARGUMENT);
}

/// A call for many operations does the same as one call for each, in their order.
TEST(CInterface, ManyInOneCallAreTheSameOnesInOrder) {
  const Handle mesh = handle_of(sample::rectangle(6, 6));
  const Handle twin = handle_of(sample::rectangle(6, 6));
  restrip_mesh* const m = mesh.get();
  std::vector<restrip_halfedge> all;
  std::vector<std::uint32_t> from;
  std::vector<std::uint32_t> to;
  for (restrip_halfedge h = 0; h < 4 * restrip_mesh_triangle_bound(m) + 40; ++h) {
    all.push_back(h);
    from.push_back(restrip_mesh_from(m, h));
    to.push_back(restrip_mesh_to(m, h));
  }
  std::vector<restrip_halfedge> found(all.size());
  ASSERT_EQ(restrip_mesh_find_each(m, all.size(), from.data(), to.data(), found.data()), RESTRIP_OK);
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(found[i], from[i] == RESTRIP_NONE ? RESTRIP_NONE : all[i]);
  std::vector<restrip_status> statuses(all.size());
  for (std::int32_t operation = RESTRIP_MERGE; operation >= RESTRIP_COLLAPSE; --operation) {
    std::vector<restrip_change> changes(all.size(), {7, 7, 7, 7});
    ASSERT_EQ(restrip_mesh_check_each(m, operation, all.size(), all.data(), statuses.data()), RESTRIP_OK);
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(statuses[i], ask_at(twin.get(), operation, all[i]));
    ASSERT_EQ(restrip_mesh_apply_each(m, operation, all.size(), all.data(), statuses.data(), changes.data()),
              RESTRIP_OK);
    for (std::size_t i = 0; i < all.size(); ++i) {
      restrip_change change{7, 7, 7, 7};
      const auto place = static_cast<std::size_t>(operation);
      ASSERT_EQ(statuses[i], at_halfedge.at(place).apply(twin.get(), all[i], &change)) << operation << " at " << all[i];
      EXPECT_EQ(std::memcmp(&changes[i], &change, sizeof change), 0);  // untouched by a refusal
    }
    EXPECT_EQ(corners_of(m), corners_of(twin.get()));
  }
  // Nothing at all is allowed, and numbers that no operation has are refused.
  EXPECT_EQ(restrip_mesh_find_each(m, 0, nullptr, nullptr, nullptr), RESTRIP_OK);
  EXPECT_EQ(restrip_mesh_apply_each(m, RESTRIP_FLIP, 0, nullptr, nullptr, nullptr), RESTRIP_OK);
  for (const std::int32_t operation : {-1, RESTRIP_MERGE + 1}) {
    EXPECT_EQ(restrip_mesh_check_each(m, operation, 0, nullptr, nullptr), RESTRIP_BAD_ARGUMENT);
    EXPECT_EQ(restrip_mesh_apply_each(m, operation, 0, nullptr, nullptr, nullptr), RESTRIP_BAD_ARGUMENT);
  }
}

/// A live buffer of 16 bits names vertices up to 65,534: an operation that would add vertex 65,535 is refused, whether
/// the caller names it or not. Other widths allow it.
TEST(CInterface, OperationsKeepToSixteenBits) {
  std::vector<std::uint32_t> triangles = list_of(sample::torus(8, 8));
  triangles.insert(triangles.end(), {65'532, 65'533, 65'534});
  restrip_mesh* made = nullptr;
  ASSERT_EQ(restrip_mesh_build_u32(triangles.data(), triangles.size(), 65'535, nullptr, nullptr, &made), RESTRIP_OK);
  const Handle mesh(made);
  const restrip_halfedge right = restrip_mesh_spoke(mesh.get(), 5);
  const restrip_halfedge left = restrip_mesh_opposite(
      mesh.get(), restrip_mesh_next(mesh.get(), restrip_mesh_next(mesh.get(), right)));  // turned counter-clockwise
  for (const std::int32_t bits : {16, 0}) {
    const restrip_status expected = bits == 16 ? RESTRIP_TOO_LARGE : RESTRIP_OK;
    ASSERT_EQ(begin_live(mesh.get(), RESTRIP_FORM_RESTART, bits), RESTRIP_OK);
    updated(mesh.get());
    const auto before = corners_of(mesh.get());
    EXPECT_EQ(restrip_mesh_check_split(mesh.get(), left, right, 65'536), expected);
    EXPECT_EQ(restrip_mesh_check_split(mesh.get(), left, right, 20'000), RESTRIP_OK);
    EXPECT_EQ(ask_at(mesh.get(), RESTRIP_BISECT, right), expected);
    EXPECT_EQ(ask_at(mesh.get(), RESTRIP_SPLIT_FACE, right), expected);
    if (bits == 16) {
      EXPECT_EQ(restrip_mesh_split(mesh.get(), left, right, RESTRIP_NONE, nullptr), expected);
      EXPECT_EQ(restrip_mesh_split_face(mesh.get(), right, nullptr), expected);
      EXPECT_EQ(corners_of(mesh.get()), before);
    }
    EXPECT_EQ(restrip_mesh_bisect(mesh.get(), right, nullptr), expected);
    updated(mesh.get());
  }
}

TEST(CInterface, BuffersOutDrawTheMesh) {
  const Handle mesh = handle_of(sample::sphere(2));
  ASSERT_EQ(restrip_mesh_stripify(mesh.get(), RESTRIP_EFFORT_FULL, &fewest_indices, 0, nullptr), RESTRIP_OK);
  std::size_t count = 0;
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

/// Compares every position and every pair of masks, including masks with a bit too many, with a rule of the library.
template <class RuleOf>
std::size_t compare_rules(std::int32_t rule, std::uint32_t k, std::uint32_t i, std::uint32_t j, unsigned edges,
                          bool expected_place, RuleOf&& rule_of) {
  std::size_t answered = 0;
  for (std::uint64_t colors = 0; colors < std::uint64_t{2} << edges; ++colors)
    for (std::uint64_t ports = 0; ports < std::uint64_t{2} << k; ++ports) {
      restrip_answer answer{};
      const restrip_status status = restrip_lookup(rule, k, i, j, colors, ports, &answer);
      if (!expected_place) {
        EXPECT_EQ(status, RESTRIP_BAD_ARGUMENT);
        return 0;
      }
      const Rule expected = rule_of(colors, ports);
      EXPECT_EQ(status, expected.valid ? RESTRIP_OK : RESTRIP_BAD_COLORING);
      if (!expected.valid) continue;
      ++answered;
      EXPECT_EQ(answer.colors, expected.colors);
      EXPECT_EQ(answer.ports, ports);
      EXPECT_EQ(answer.strips, expected.strips);
    }
  return answered;
}

TEST(CInterface, LookUpsAnswerAsTheRules) {
  std::size_t answered = 0;
  for (std::uint32_t k = 0; k <= 5; ++k)
    for (std::uint32_t i = 0; i <= k + 1; ++i) {
      const bool closed = k >= 3 && i >= 1 && i < k;
      const SplitPosition at{k, i};
      const Gap gap{k, i};
      answered +=
          compare_rules(RESTRIP_RULE_SPLIT, k, i, 0, k, closed, [&](auto c, auto p) { return split_rule(at, c, p); });
      answered += compare_rules(RESTRIP_RULE_COLLAPSE, k, i, 0, k + 3, closed,
                                [&](auto c, auto p) { return collapse_rule(at, c, p); });
      answered += compare_rules(RESTRIP_RULE_BOUNDARY_SPLIT, k, i, 0, k, k >= 1 && i <= k,
                                [&](auto c, auto p) { return boundary_split_rule(gap, c, p); });
      answered += compare_rules(RESTRIP_RULE_BOUNDARY_COLLAPSE, k, i, 0, k, k >= 1 && i <= k,
                                [&](auto c, auto p) { return boundary_collapse_rule(gap, c, p); });
      for (std::uint32_t j = 0; j <= k + 1; ++j) {
        const bool gaps = k >= 1 && i < j && j <= k;
        const GapPair both{k, i, j};
        answered += compare_rules(RESTRIP_RULE_OPEN_SPLIT, k, i, j, k, gaps,
                                  [&](auto c, auto p) { return open_split_rule(both, c, p); });
        answered += compare_rules(RESTRIP_RULE_OPEN_COLLAPSE, k, i, j, k + 2, gaps,
                                  [&](auto c, auto p) { return open_collapse_rule(both, c, p); });
      }
    }
  EXPECT_GT(answered, 10'000U);
  restrip_answer answer{};
  for (const std::int32_t wrong : {-1, 7})
    EXPECT_EQ(restrip_lookup(wrong, 4, 1, 2, 0, 0, &answer), RESTRIP_BAD_ARGUMENT);
  EXPECT_EQ(restrip_lookup(RESTRIP_RULE_SPLIT, 62, 3, 0, 0, 0, &answer), RESTRIP_BAD_ARGUMENT);
  ASSERT_EQ(restrip_lookup(RESTRIP_RULE_SPLIT, 61, 3, 0, 0, 0, &answer), RESTRIP_OK);
  EXPECT_EQ(answer.colors, split_rule({61, 3}, 0, 0).colors);
  EXPECT_EQ(restrip_lookup(RESTRIP_RULE_FLIP, 0, 0, 0, 2, 0, &answer), RESTRIP_BAD_COLORING);
  EXPECT_EQ(restrip_lookup(RESTRIP_RULE_FLIP, 0, 0, 0, 0, 16, &answer), RESTRIP_BAD_COLORING);
  for (unsigned inner = 0; inner < 2; ++inner)
    for (unsigned ports = 0; ports < 16; ++ports) {
      const FlipRule rule = flip_rule(inner != 0, ports);
      ASSERT_EQ(restrip_lookup(RESTRIP_RULE_FLIP, 0, 0, 0, inner, ports, &answer),
                rule.valid ? RESTRIP_OK : RESTRIP_BAD_COLORING);
      if (!rule.valid) continue;
      EXPECT_EQ(answer.colors, rule.inner ? 1U : 0U);
      EXPECT_EQ(answer.ports, rule.ports);
      EXPECT_EQ(answer.strips, rule.strips);
    }
}

}  // namespace
}  // namespace restrip::c_test
