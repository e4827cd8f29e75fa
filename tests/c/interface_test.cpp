// The C interface does what LiveMesh does, with the same refusals, and reports it: the driver of tests/drive drives
// both. Formats, widths and vertex numbers that cannot be had are codes.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <numeric>
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

restrip_status ask_at(const restrip_mesh* mesh, std::int32_t operation, restrip_halfedge h) {
  restrip_status status = RESTRIP_UNEXPECTED;
  EXPECT_EQ(restrip_mesh_check_each(mesh, operation, 1, &h, &status), RESTRIP_OK);
  return status;
}

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

TEST(CInterface, DamagedSavesAreRefused) {
  const Handle mesh = handle_of(sample::octahedron());
  std::string bytes = saved(mesh.get());
  const std::size_t size = bytes.size();
  restrip_mesh* loaded = mesh.get();
  char text[100];
  EXPECT_EQ(restrip_mesh_load(bytes.data(), size - 1, 0, text, sizeof text, &loaded), RESTRIP_BAD_FILE);
  EXPECT_EQ(loaded, nullptr);
  EXPECT_NE(std::string(text).find("truncated"), std::string::npos);
  bytes[size / 2] = static_cast<char>(bytes[size / 2] ^ 1);
  EXPECT_EQ(restrip_mesh_load(bytes.data(), size, 0, nullptr, 0, &loaded), RESTRIP_BAD_FILE);
  EXPECT_EQ(restrip_mesh_load("ply", 3, 0, text, sizeof text, &loaded), RESTRIP_BAD_FILE);
  EXPECT_NE(std::string(text).find("not a saved"), std::string::npos);
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

/// A call for many operations does the same as one call for each, in their order.
TEST(CInterface, ManyInOneCallAreTheSameOnesInOrder) {
  const Handle mesh = handle_of(sample::rectangle(6, 6));
  const Handle twin = handle_of(sample::rectangle(6, 6));
  restrip_mesh* const m = mesh.get();
  std::vector<restrip_halfedge> all(4 * restrip_mesh_triangle_bound(m) + 40);
  std::iota(all.begin(), all.end(), 0U);
  std::vector<std::uint32_t> from;
  std::vector<std::uint32_t> to;
  for (const restrip_halfedge h : all) {
    from.push_back(restrip_mesh_from(m, h));
    to.push_back(restrip_mesh_to(m, h));
  }
  std::vector<restrip_halfedge> found(all.size());
  ASSERT_EQ(restrip_mesh_find_each(m, all.size(), from.data(), to.data(), found.data()), RESTRIP_OK);
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(found[i], from[i] == RESTRIP_NONE ? RESTRIP_NONE : all[i]);
  std::vector<restrip_status> statuses(all.size());
  for (std::int32_t operation = RESTRIP_MERGE; operation >= RESTRIP_COLLAPSE; --operation) {
    std::vector<restrip_change> changes(all.size(), {7, 7, 7, 7});
    ASSERT_EQ(restrip_mesh_apply_each(m, operation, all.size(), all.data(), statuses.data(), changes.data()),
              RESTRIP_OK);
    for (std::size_t i = 0; i < all.size(); ++i) {
      restrip_change change{7, 7, 7, 7};
      EXPECT_EQ(statuses[i], ask_at(twin.get(), operation, all[i]));
      ASSERT_EQ(statuses[i], at_halfedge.at(static_cast<std::size_t>(operation))(twin.get(), all[i], &change));
      EXPECT_EQ(std::memcmp(&changes[i], &change, sizeof change), 0);  // untouched by a refusal
    }
    EXPECT_EQ(corners_of(m), corners_of(twin.get()));
  }
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

/// Long searches ask whether to stop; stopped at once, they leave valid strips, and otherwise the same ones as always.
TEST(CInterface, LongSearchesMayBeStopped) {
  struct Asked {
    std::size_t times = 0;
    std::size_t most = 0;
  };
  const auto stop = [](void* context) -> std::int32_t {
    auto& asked = *static_cast<Asked*>(context);
    return ++asked.times > asked.most ? 7 : 0;
  };
  for (const restrip_cost& cost : {fewest_strips, fewest_indices}) {
    const Handle mesh = handle_of(sample::torus(90, 80));
    std::size_t strips = 0;
    std::size_t fast = 0;
    ASSERT_EQ(restrip_mesh_stripify(mesh.get(), RESTRIP_EFFORT_FAST, &cost, 0, &fast), RESTRIP_OK);
    for (const std::size_t most : {0U, 3U}) {
      Asked asked{0, most};
      ASSERT_EQ(restrip_mesh_stripify_until(mesh.get(), RESTRIP_EFFORT_BEST, &cost, 0, stop, &asked, &strips),
                RESTRIP_OK);
      EXPECT_LE(asked.times, most + 1);
      const restrip_coloring coloring = counted(mesh.get());
      EXPECT_TRUE(coloring.valid != 0 && coloring.strips == strips);
    }
    Asked never{0, SIZE_MAX};
    ASSERT_EQ(restrip_mesh_stripify_until(mesh.get(), RESTRIP_EFFORT_FULL, &cost, 0, stop, &never, &strips),
              RESTRIP_OK);
    const auto colors = colors_of(mesh.get());
    ASSERT_EQ(restrip_mesh_stripify(mesh.get(), RESTRIP_EFFORT_FULL, &cost, 0, &strips), RESTRIP_OK);
    EXPECT_EQ(colors_of(mesh.get()), colors);
    EXPECT_GT(never.times, 0U);
  }
}

TEST(CInterface, StripsTrianglesAndCopiesComeOut) {
  const StripMesh sphere = sample::sphere(2);
  const Handle mesh = handle_of(sphere);
  restrip_mesh* const m = mesh.get();
  ASSERT_EQ(restrip_mesh_stripify(m, RESTRIP_EFFORT_FULL, &fewest_indices, 0, nullptr), RESTRIP_OK);
  StripMesh same = sphere;
  stripify(same, Effort::full, Cost::indices());
  EXPECT_EQ(colors_of(m), colors_of(same));
  const Strips expected = extract_strips(same);
  std::vector<std::uint32_t> order(expected.order.size());
  std::vector<std::size_t> starts(expected.start.size());
  ASSERT_EQ(restrip_mesh_strips(m, order.data(), order.size(), starts.data(), starts.size()), RESTRIP_OK);
  EXPECT_EQ(order, expected.order);
  EXPECT_EQ(starts, expected.start);
  ASSERT_EQ(restrip_mesh_collapse(m, restrip_mesh_spoke(m, 7), nullptr), RESTRIP_OK);
  std::vector<std::uint32_t> corners(3 * restrip_mesh_triangle_count(m));
  ASSERT_EQ(restrip_mesh_triangles(m, corners.data(), corners.size()), RESTRIP_OK);
  std::vector<Corners> all;
  for (std::size_t i = 0; i < corners.size(); i += 3) all.push_back({corners[i], corners[i + 1], corners[i + 2]});
  EXPECT_EQ(sample::sorted(std::move(all)), sorted_triangles(m));
  // A copy is by itself, and room that was reserved is enough.
  restrip_mesh* copy = nullptr;
  ASSERT_EQ(restrip_mesh_copy(m, &copy), RESTRIP_OK);
  const Handle owned(copy);
  EXPECT_EQ(corners_of(copy), corners_of(m));
  EXPECT_EQ(colors_of(copy), colors_of(m));
  ASSERT_EQ(restrip_mesh_reserve(copy, 2000, 2000), RESTRIP_OK);
  updated(copy);
  std::size_t room = 0;
  restrip_buffer_view view{};
  ASSERT_EQ(restrip_live_buffer(copy, &view, &room), RESTRIP_OK);
  for (std::uint32_t h = 0; restrip_mesh_triangle_count(copy) < 900; ++h)
    ASSERT_EQ(restrip_mesh_split_face(copy, 4 * h, nullptr), RESTRIP_OK);
  updated(copy);
  EXPECT_LE(live_view(copy).index_count, room);
  EXPECT_EQ(sorted_triangles(m).size(), corners.size() / 3);
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

TEST(CInterface, CustomOperationsAreData) {
  restrip_table* made = nullptr;
  ASSERT_EQ(DividedFace().make(&made), RESTRIP_OK);
  const Table table(made);
  const Handle mesh = handle_of(sample::sphere(1));
  restrip_mesh* const m = mesh.get();
  ASSERT_EQ(restrip_mesh_stripify(m, RESTRIP_EFFORT_FULL, nullptr, 0, nullptr), RESTRIP_OK);
  for (std::uint32_t t = 0; t < 40; ++t) {
    std::uint32_t corners[3];
    ASSERT_EQ(restrip_mesh_corners(m, t, corners), RESTRIP_OK);
    const std::size_t triangles = restrip_mesh_triangle_count(m);
    const std::size_t strips = strip_count(m);
    restrip_change change{};
    std::uint32_t added[RESTRIP_MOST_NEW_VERTICES] = {};
    std::size_t count = 0;
    const auto next = static_cast<std::uint32_t>(restrip_mesh_vertex_bound(m));
    ASSERT_EQ(restrip_mesh_apply(m, made, 4 * t + t % 3, &change, added, &count), RESTRIP_OK);
    ASSERT_EQ(count, 1U);
    EXPECT_EQ(added[0], next);
    EXPECT_EQ(restrip_mesh_from(m, change.halfedge), corners[t % 3]);
    EXPECT_EQ(restrip_mesh_to(m, change.halfedge), corners[(t + 1) % 3]);
    EXPECT_EQ(restrip_mesh_triangle_count(m), triangles + 2);
    EXPECT_EQ(counted(m).strips, strips + static_cast<std::size_t>(change.strips));
  }
  EXPECT_EQ(restrip_mesh_apply(m, made, RESTRIP_NONE, nullptr, nullptr, nullptr), RESTRIP_NO_SUCH_EDGE);
}

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
