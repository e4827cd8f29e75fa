// The C interface does what LiveMesh does, with the same refusals, and reports it: the driver of tests/drive drives
// both. Formats and tables that cannot be used are codes. tests/python tries more of it: many operations in one call,
// vertices that 16 bits cannot name, far vertices, damaged saves, searches that are stopped.
#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <span>
#include <utility>

#include "c_subject.hpp"
#include "drive/driver.hpp"
#include "drive/live_subject.hpp"
#include "handle.hpp"
#include "restrip/live_mesh.hpp"
#include "restrip/restrip.hpp"
#include "runtime/form_reader.hpp"
#include "runtime/sample_meshes.hpp"
#include "support/failing_new.hpp"

namespace restrip::c_test {
namespace {

using Corners = std::array<std::uint32_t, 3>;

constexpr restrip_cost fewest_indices = RESTRIP_FEWEST_INDICES;

form_reader::Triangles sorted_triangles(const restrip_mesh* mesh) {
  std::vector<Corners> all = corners_of(mesh);
  std::erase_if(all, [](const Corners& c) { return c[0] == RESTRIP_NONE; });
  return sample::sorted(std::move(all));
}

/// The driver of tests/drive on a mesh of this interface, with a simulated device and looks of all frames; and, unless
/// 16 bits matter, next to a LiveMesh.
TEST(CInterface, DoesWhatLiveMeshDoes) {
  std::uint32_t seed = 0;
  drive::Tally sum;
  for (const std::int32_t form : {RESTRIP_FORM_RESTART, RESTRIP_FORM_STITCHED, RESTRIP_FORM_LENGTHS, RESTRIP_FORM_LIST})
    for (const std::int32_t bits : {0, 16, 32})
      for (const std::size_t history : {std::size_t{0}, std::size_t{1'000'000}}) {
        const std::string bytes = drive::random_bytes(800, ++seed);
        const StripMesh start = seed % 2 == 0 ? sample::tube(5, 6) : sample::sphere(1);
        Handle mesh = handle_of(start);
        ASSERT_EQ(begin_live(mesh.get(), form, bits, history), RESTRIP_OK);
        ASSERT_EQ(restrip_mesh_stripify(mesh.get(), RESTRIP_EFFORT_FAST, &fewest_indices, 0, nullptr), RESTRIP_OK);
        updated(mesh.get());  // buffer and history begin
        CSubject subject(std::move(mesh), history);
        const IndexWidth width = bits == 16   ? IndexWidth::bits16
                                 : bits == 32 ? IndexWidth::bits32
                                              : IndexWidth::automatic;
        LiveMesh live(start, {.history = history, .format = {static_cast<StripForm>(form), width}, .deferred = true});
        live.recolor(Effort::fast, Cost::indices());
        live.update();
        drive::LiveSubject other(std::move(live), history);
        drive::Device device;
        drive::FrameLooks looks(history != 0);
        drive::Twin twin(other);
        const std::array<drive::Oracle*, 3> oracles{&device, &looks, &twin};
        drive::Input input(bytes);
        sum += drive::drive(input, subject, oracles, {.allocations_fail = false, .far_names = bits != 16});
      }
  using enum drive::Call;
  for (const drive::Call call : {split, merge, replace, reload, undo})
    EXPECT_GT(sum.done[static_cast<std::size_t>(call)], 30U);
}

/// Memory may run out in any call: that is a code, and afterwards everything works again.
TEST(CInterface, MemoryMayRunOut) {
  drive::Tally sum;
  for (std::uint32_t seed = 1; seed < 33; ++seed) {
    const std::string bytes = drive::random_bytes(2000, seed);
    const std::size_t history = seed % 2 == 0 ? 0 : 1'000'000;
    Handle mesh = handle_of(sample::torus(6, 5));
    ASSERT_EQ(begin_live(mesh.get(), static_cast<std::int32_t>(seed % 4), 0, history), RESTRIP_OK);
    updated(mesh.get());
    CSubject subject(std::move(mesh), history);
    drive::Device device;
    drive::FrameLooks looks(history != 0);
    drive::Input input(bytes);
    sum += drive::drive(input, subject, std::array<drive::Oracle*, 2>{&device, &looks});
  }
  EXPECT_GT(sum.failed, 50U);
  restrip_mesh* made = nullptr;
  restrip_status status = RESTRIP_OK;
  const auto indices = list_of(sample::sphere(1));
  const std::size_t built = testing_support::for_each_allocation(
      [&] { status = restrip_mesh_build_u32(indices.data(), indices.size(), 18, nullptr, nullptr, &made); },
      [&] { EXPECT_TRUE(status == RESTRIP_OUT_OF_MEMORY && made == nullptr); });
  EXPECT_EQ(status, RESTRIP_OK);
  EXPECT_GT(built, 4U);
  restrip_mesh_free(made);
}

form_reader::Triangles read_view(const void* indices, std::size_t bytes, const restrip_buffer_view& view) {
  const auto width = static_cast<std::size_t>(view.index_bits) / 8;
  form_reader::Reader reader({static_cast<const std::byte*>(indices), bytes}, width);
  for (const restrip_range& draw : std::span(view.draws, view.draw_count))
    reader.draw(static_cast<StripForm>(view.form), std::array{IndexRange{draw.first, draw.count}});
  return std::move(reader).triangles();
}

/// Every form and width, of a mesh and of a list.
TEST(CInterface, BuffersInEveryForm) {
  for (std::int32_t form = RESTRIP_FORM_RESTART; form <= RESTRIP_FORM_LIST; ++form)
    for (const std::int32_t bits : {0, 16, 32}) {
      const Handle mesh = handle_of(sample::tube(9, 12));
      restrip_buffer_view view{};
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

TEST(CInterface, FormatsAreChecked) {
  const Handle mesh = handle_of(sample::octahedron());
  restrip_buffer* buffer = nullptr;
  const std::vector<std::uint32_t> far{0, 1, 70'000};
  const auto status_of = [&](restrip_format format) {
    return restrip_strips_of_u32(far.data(), 3, 70'001, RESTRIP_EFFORT_FAST, nullptr, nullptr, &format, &buffer);
  };
  EXPECT_EQ(status_of({RESTRIP_FORM_LIST, 16, 0, 0, 0}), RESTRIP_TOO_LARGE);  // 65,534 is the last that 16 bits name
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

/// The operation that divides a face into three, as a table.
struct DividedFace {
  std::vector<restrip_patch_triangle> before{{0, 0, {0, 1, 2}, {64, 65, 66}}};
  std::vector<restrip_patch_triangle> after{
      {0, 0, {0, 1, 3}, {64, 0, 2}}, {0, 1, {3, 1, 2}, {0, 65, 1}}, {1, 2, {3, 2, 0}, {1, 66, 2}}};
  std::vector<std::uint32_t> entries{24, 25, 50, 51, 44, 29, 46, RESTRIP_NONE};
  restrip_operation operation{3, 0, 3, 4, 0, nullptr, 0, nullptr, 0, nullptr, 0};

  restrip_status make(restrip_table** table, std::string* said = nullptr) {
    operation.before = before.data();
    operation.before_count = before.size();
    operation.after = after.data();
    operation.after_count = after.size();
    operation.entries = entries.data();
    operation.entry_count = entries.size();
    char text[100];
    const restrip_status status = restrip_table_make(&operation, text, sizeof text, table);
    EXPECT_EQ(status == RESTRIP_OK, text[0] == '\0');
    if (said != nullptr) *said = text;
    return status;
  }
};
struct FreeTable {
  void operator()(restrip_table* table) const { restrip_table_free(table); }
};
using Table = std::unique_ptr<restrip_table, FreeTable>;

/// What is wrong is named, and a table that is accepted, however it was altered, leaves valid colours.
TEST(CInterface, TablesAreChecked) {
  const auto said = [](const auto& spoil) {
    DividedFace given;
    spoil(given);
    restrip_table* table = nullptr;
    std::string text;
    EXPECT_EQ(given.make(&table, &text), RESTRIP_BAD_ARGUMENT);
    EXPECT_EQ(table, nullptr);
    return text;
  };
  EXPECT_EQ(said([](DividedFace& d) { d.entries[0] = 7 << 3; }),
            "entry 0 is not a sound rule: in some mesh it closes a cycle or branches");
  EXPECT_EQ(said([](DividedFace& d) { d.entries[1] |= 2; }).substr(0, 25), "entry 1 is not a sound ru");
  EXPECT_EQ(said([](DividedFace& d) { d.entries[2] = 8 << 3; }).substr(0, 25), "entry 2 is not a sound ru");
  EXPECT_EQ(said([](DividedFace& d) { d.entries.pop_back(); }), "7 entries; one is needed for each colouring");
  EXPECT_EQ(said([](DividedFace& d) { d.operation.matching = 1; }), "it is a table for matchings; a mesh keeps strips");
  EXPECT_EQ(said([](DividedFace& d) { d.operation.ports = 13; }).substr(0, 16), "it has more port");
  EXPECT_EQ(said([](DividedFace& d) { d.before.clear(); }), "before: 0 triangles; 1 to 16 are allowed");
  EXPECT_EQ(said([](DividedFace& d) { d.after[2].from_side = 1; }),
            "after: triangle 2 does not share its first side with the triangle that it is met from");
  EXPECT_EQ(said([](DividedFace& d) { std::swap(d.before[0].side[0], d.before[0].side[1]); }),
            "a port has other vertices after the operation");
  EXPECT_EQ(said([](DividedFace& d) {  // a hole that would pinch a mesh whose boundary has vertex 2
              d.after = {{0, 0, {0, 1, 3}, {64, 0, 1}},
                         {0, 1, {3, 1, 2}, {0, 65, 255}},
                         {0, 2, {0, 3, 4}, {1, 255, 2}},
                         {2, 2, {0, 4, 2}, {2, 255, 66}}};
              d.operation.vertices = 5;
            }),
            "after: the triangles at vertex 2 are not one fan");
  std::mt19937 random(12);
  std::size_t accepted = 0;
  for (int n = 0; n < 4000; ++n) {
    DividedFace given;
    for (auto changes = random() % 3; changes < 3; ++changes) {
      auto& side = random() % 3 == 0 ? given.before : given.after;
      auto* const bytes = reinterpret_cast<std::uint8_t*>(side.data());
      if (random() % 2 == 0)
        given.entries[random() % 8] = random() % 64;
      else
        bytes[random() % (8 * side.size())] = static_cast<std::uint8_t>(random() % 3 == 0 ? random() : random() % 4);
    }
    restrip_table* made = nullptr;
    if (given.make(&made) != RESTRIP_OK) continue;
    const Table table(made);
    const Handle mesh = handle_of(sample::octahedron());
    ++accepted;
    for (int tries = 0; tries < 6; ++tries) {
      restrip_mesh_apply(mesh.get(), made, static_cast<restrip_halfedge>(4 * (random() % 8) + random() % 3), nullptr,
                         nullptr, nullptr);
      counted(mesh.get());
    }
  }
  EXPECT_GT(accepted, 50U);
}

TEST(CInterface, LookUpsAnswerAsTheRules) {
  restrip_answer answer{};
  std::size_t answered = 0;
  const auto same = [&](std::int32_t rule, std::uint32_t i, std::uint32_t j, std::uint64_t edges, std::uint64_t ports,
                        const Rule& expected) {
    const restrip_status status = restrip_lookup(rule, 4, i, j, edges, ports, &answer);
    ASSERT_EQ(status, expected.valid ? RESTRIP_OK : RESTRIP_BAD_COLORING);
    if (!expected.valid) return;
    ++answered;
    EXPECT_EQ(answer.colors, expected.colors);
    EXPECT_EQ(answer.ports, ports);
    EXPECT_EQ(answer.strips, expected.strips);
  };
  for (std::uint64_t edges = 0; edges < 128; ++edges)
    for (std::uint64_t ports = 0; ports < 16; ++ports) {
      same(RESTRIP_RULE_SPLIT, 2, 0, edges, ports, split_rule({4, 2}, edges, ports));
      same(RESTRIP_RULE_COLLAPSE, 1, 0, edges, ports, collapse_rule({4, 1}, edges, ports));
      same(RESTRIP_RULE_OPEN_SPLIT, 1, 3, edges, ports, open_split_rule({4, 1, 3}, edges, ports));
      same(RESTRIP_RULE_OPEN_COLLAPSE, 0, 4, edges, ports, open_collapse_rule({4, 0, 4}, edges, ports));
      same(RESTRIP_RULE_BOUNDARY_SPLIT, 0, 0, edges, ports, boundary_split_rule({4, 0}, edges, ports));
      same(RESTRIP_RULE_BOUNDARY_COLLAPSE, 4, 0, edges, ports, boundary_collapse_rule({4, 4}, edges, ports));
      const FlipRule flip = flip_rule(edges % 2 != 0, static_cast<unsigned>(ports));
      ASSERT_EQ(restrip_lookup(RESTRIP_RULE_FLIP, 0, 0, 0, edges % 2, ports, &answer),
                flip.valid ? RESTRIP_OK : RESTRIP_BAD_COLORING);
      if (flip.valid) {
        EXPECT_EQ(answer.colors, flip.inner ? 1U : 0U);
        EXPECT_EQ(answer.ports, flip.ports);
      }
    }
  EXPECT_GT(answered, 500U);
  const std::array<std::uint32_t, 4> wrong[] = {{RESTRIP_RULE_SPLIT, 2, 1, 0},
                                                {RESTRIP_RULE_SPLIT, 62, 3, 0},
                                                {RESTRIP_RULE_COLLAPSE, 4, 4, 0},
                                                {RESTRIP_RULE_OPEN_SPLIT, 4, 3, 3},
                                                {RESTRIP_RULE_OPEN_COLLAPSE, 4, 1, 5},
                                                {RESTRIP_RULE_BOUNDARY_SPLIT, 0, 0, 0},
                                                {RESTRIP_RULE_BOUNDARY_COLLAPSE, 4, 5, 0},
                                                {7, 4, 1, 2}};
  for (const auto& [rule, k, i, j] : wrong)
    EXPECT_EQ(restrip_lookup(static_cast<std::int32_t>(rule), k, i, j, 0, 0, &answer), RESTRIP_BAD_ARGUMENT);
  ASSERT_EQ(restrip_lookup(RESTRIP_RULE_SPLIT, 61, 3, 0, 0, 0, &answer), RESTRIP_OK);
  EXPECT_EQ(restrip_lookup(RESTRIP_RULE_FLIP, 0, 0, 0, 2, 0, &answer), RESTRIP_BAD_COLORING);
  EXPECT_EQ(restrip_lookup(RESTRIP_RULE_FLIP, 0, 0, 0, 0, 16, &answer), RESTRIP_BAD_COLORING);
}

}  // namespace
}  // namespace restrip::c_test
