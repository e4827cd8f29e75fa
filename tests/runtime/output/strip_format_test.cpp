// Every form of an index buffer draws the triangles of the mesh, with their windings, in the stated number of indices,
// for all strips and batches, read by an independent reader.
#include "restrip/output/strip_format.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "form_reader.hpp"
#include "random_operations.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

using Indices = std::vector<std::uint32_t>;

constexpr std::array all_forms{StripForm::restart, StripForm::stitched, StripForm::lengths, StripForm::list};

/// Meshes with all kinds of strips: of any length, from either end, isolated triangles.
template <class Use>
void for_each_colored(Use&& use) {
  for (StripMesh& mesh : sample::meshes())
    for (const Cost cost : {Cost::strips(), Cost::indices()}) {
      stripify(mesh, Effort::fast, cost);
      use(mesh);
      std::mt19937 random(5);
      Keeper keeper(mesh, Policy::rules, cost);
      for (int i = 0; i < 40; ++i) random_operation(keeper, random, i % 2 == 0);
      use(mesh);
      for (const auto h : sample::dual_edges(mesh))
        if (random() % 3 == 0) mesh.set_solid(h, false);
      use(mesh);
    }
}

TEST(StripFormat, EveryFormDrawsTheMesh) {
  for_each_colored([](const StripMesh& mesh) {
    const Indices plain = strip_indices(mesh);
    for (const StripForm form : all_forms)
      for (const IndexWidth width : {IndexWidth::automatic, IndexWidth::bits32}) {
        const IndexBuffer buffer = format_strips(plain, {.form = form, .width = width, .list_if_shorter = false});
        ASSERT_EQ(buffer.form, form);
        ASSERT_EQ(buffer.index_bytes(), width == IndexWidth::bits32 ? 4U : 2U);
        ASSERT_EQ(buffer.triangles, mesh.triangle_count());
        ASSERT_EQ(form_reader::read(buffer), sample::triangles_of(mesh));
        const std::size_t strips = count_strips(mesh);
        if (form == StripForm::stitched) {
          ASSERT_LE(buffer.size(), plain.size() + strips);  // an index for parity once, at the end
        } else {
          ASSERT_EQ(buffer.size(), form == StripForm::restart   ? plain.size()
                                   : form == StripForm::lengths ? plain.size() - (strips - 1)
                                                                : 3 * mesh.triangle_count());
        }
      }
  });
}

TEST(StripFormat, BatchesKeepTheirLimits) {
  for_each_colored([](const StripMesh& mesh) {
    const Indices plain = strip_indices(mesh);
    for (const StripForm form : all_forms)
      for (const auto& [vertices, indices] :
           {std::pair<std::size_t, std::size_t>{3, 0}, {0, 4}, {7, 9}, {64, 0}, {0, 50}}) {
        const IndexBuffer buffer = format_strips(
            plain, {.form = form, .list_if_shorter = false, .most_vertices = vertices, .most_indices = indices});
        ASSERT_EQ(form_reader::read(buffer), sample::triangles_of(mesh));
        const form_reader::Reader reader(buffer.bytes(), buffer.index_bytes());
        std::size_t end = 0;
        for (const IndexRange& batch : buffer.batches) {
          ASSERT_EQ(batch.first, end);
          end += batch.count;
          ASSERT_TRUE(vertices == 0 || reader.vertices(batch.first, batch.count) <= vertices);
          ASSERT_TRUE(indices == 0 || batch.count <= indices);
        }
        ASSERT_EQ(end, buffer.size());
      }
  });
}

TEST(StripFormat, TakesStitchedStripsApart) {
  for_each_colored([](const StripMesh& mesh) {
    const Indices plain = strip_indices(mesh);
    const IndexBuffer stitched =
        format_strips(plain, {.form = StripForm::stitched, .width = IndexWidth::bits32, .list_if_shorter = false});
    const auto& indices = std::get<0>(stitched.indices);
    for (const StripForm form : all_forms) {
      const IndexBuffer again = format_strips(indices, {.form = form, .list_if_shorter = false});
      ASSERT_EQ(form_reader::read(again), sample::triangles_of(mesh));
    }
    ASSERT_LE(format_strips(indices, {.list_if_shorter = false}).size(), plain.size() + count_strips(mesh));
  });
}

TEST(StripFormat, AListIsReturnedWhenItIsShorter) {
  const Indices islands{0, 1, 2, restart_index, 3, 4, 5, restart_index, 6, 7, 8};
  for (const StripForm form : {StripForm::restart, StripForm::stitched}) {
    const IndexBuffer buffer = format_strips(islands, {.form = form});
    EXPECT_EQ(buffer.form, StripForm::list);
    EXPECT_EQ(std::get<1>(buffer.indices), (std::vector<std::uint16_t>{0, 1, 2, 3, 4, 5, 6, 7, 8}));
    EXPECT_EQ(format_strips(islands, {.form = form, .list_if_shorter = false}).form, form);
  }
  EXPECT_EQ(format_strips(islands, {.form = StripForm::lengths}).lengths, (Indices{3, 3, 3}));
}

TEST(StripFormat, SixteenBitsAsFarAsTheyReach) {
  const auto highest = [](std::uint32_t v) { return Indices{0, 1, v}; };
  EXPECT_EQ(format_strips(highest(65'534)).index_bytes(), 2U);
  EXPECT_EQ(format_strips(highest(65'535)).index_bytes(), 4U);
  EXPECT_EQ(format_strips(highest(7), {.width = IndexWidth::bits32}).index_bytes(), 4U);
  EXPECT_THROW((void)format_strips(highest(65'535), {.width = IndexWidth::bits16}), std::length_error);
  EXPECT_THROW((void)format_strips(highest(3), {.most_vertices = 2}), std::invalid_argument);
  EXPECT_THROW((void)format_strips(highest(3), {.most_indices = 3}), std::invalid_argument);
  EXPECT_TRUE(format_strips({}).empty());
  EXPECT_TRUE(format_strips({}).batches.empty());
  EXPECT_TRUE(format_strips(Indices{4, 4, 5, restart_index, 1, 2}).empty());
}

}  // namespace
}  // namespace restrip
