// A loaded LiveMesh has the triangles, handles and colours of the saved one (live_random_test.cpp saves at random
// times), and damaged bytes are refused: every prefix, every byte, also with a matching checksum, so that the damage
// reaches the reader.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "form_reader.hpp"
#include "formats/baked_format.hpp"
#include "random_operations.hpp"
#include "restrip/live_mesh.hpp"
#include "restrip/output/live_buffer.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/keeper.hpp"
#include "sample_meshes.hpp"
#include "whole_mesh.hpp"

namespace restrip {
namespace {

using Bytes = std::vector<std::byte>;

void expect_drawn(const LiveMesh& live) {
  std::vector<IndexRange> draws;
  live.buffer().draws(draws);
  ASSERT_EQ(form_reader::drawn(live.bytes(), live.index_bytes(), live.buffer().format().form, draws),
            sample::triangles_of(live.mesh()));
}

/// One of these meshes has been loaded from the bytes of the other.
void expect_equal(const LiveMesh& one, const LiveMesh& other) {
  ASSERT_EQ(one.mesh().vertex_bound(), other.mesh().vertex_bound());
  ASSERT_TRUE(differing_triangles(one.mesh(), other.mesh()).empty());
  ASSERT_EQ(fault_of(other.mesh()), "");
  ASSERT_EQ(one.strips(), other.strips());
  ASSERT_EQ(one.keeper().policy(), other.keeper().policy());
  ASSERT_EQ(one.keeper().weights(), other.keeper().weights());
  ASSERT_EQ(one.keeper().cost(), other.keeper().cost());
  ASSERT_EQ(one.buffer().format(), other.buffer().format());
  ASSERT_EQ(one.buffer().layout(), other.buffer().layout());
  expect_drawn(other);
}

TEST(LiveSave, EmptyMeshesMarkedVerticesAndReservedRoom) {
  LiveMesh empty(std::vector<std::uint32_t>{}, 0);
  LiveMesh loaded = LiveMesh::load(empty.save());
  EXPECT_EQ(loaded.mesh().triangle_count(), 0U);
  EXPECT_EQ(loaded.bytes().size(), 0U);
  // Three triangles at one edge.
  LiveMesh book(std::vector<std::uint32_t>{0, 1, 2, 0, 1, 3, 0, 1, 4}, 9);
  loaded = LiveMesh::load(book.save());
  expect_equal(book, loaded);
  EXPECT_TRUE(loaded.mesh().non_manifold(0));
  EXPECT_FALSE(loaded.mesh().non_manifold(2));
  // Two triangles, with room for many.
  for (const std::size_t room : {10U, 1000U, 100'000U}) {
    LiveMesh live(std::vector<std::uint32_t>{0, 1, 2, 2, 1, 3}, 4);
    live.reserve(room, room);
    live.update();
    loaded = LiveMesh::load(live.save());
    expect_equal(live, loaded);
  }
}

// The size is linear in the triangles, and a bit for each number: also of a mesh that has shrunk to a hundredth.
TEST(LiveSave, AMeshThatHasShrunkIsSavedDensely) {
  std::mt19937 random(9);
  LiveMesh live(sample::torus(80, 80), {.policy = Policy::rules});
  const std::size_t vertices = live.mesh().vertex_bound();
  const std::size_t triangles = live.mesh().triangle_bound();
  while (live.mesh().triangle_count() > triangles / 100) live.collapse(random_halfedge(live.mesh(), random));
  Bytes bytes = live.save();
  EXPECT_EQ(bytes.size(), 41 + 8 + (triangles + 7) / 8 + (vertices + 7) / 8 + 13 * live.mesh().triangle_count());
  LiveMesh loaded = LiveMesh::load(bytes);
  expect_equal(live, loaded);
  // Free numbers are used again, the lowest first.
  Vertex lowest = 0;
  while (loaded.mesh().spoke(lowest).id != none) ++lowest;
  EXPECT_EQ(loaded.mesh().next_vertex(), lowest);
  live.pack();
  bytes = live.save();
  EXPECT_LT(bytes.size(), 60 + 14 * live.mesh().triangle_count());
  expect_equal(live, LiveMesh::load(bytes));
}

/// What load() says about these bytes; empty if it accepts them.
std::string refusal_of(std::span<const std::byte> bytes) {
  try {
    const LiveMesh live = LiveMesh::load(bytes);
    EXPECT_EQ(fault_of(live.mesh()), "");
    EXPECT_TRUE(check_coloring(live.mesh()).valid);
    expect_drawn(live);
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

/// With a matching checksum.
Bytes sealed(Bytes bytes) {
  bytes.resize(bytes.size() - 8);
  std::uint64_t sum = baked_format::fnv1a(std::span<const std::byte>(bytes));
  for (int i = 0; i < 8; ++i, sum >>= 8) bytes.push_back(static_cast<std::byte>(sum & 0xFF));
  return bytes;
}

TEST(LiveSave, DamagedBytesAreRefused) {
  std::mt19937 random(7);
  for (const StripForm form : {StripForm::restart, StripForm::stitched, StripForm::list}) {
    LiveMesh live(sample::rectangle(4, 3), {.format = {.form = form}});
    for (int i = 0; i < 15; ++i) {
      live.bisect(random_halfedge(live.mesh(), random));
      live.collapse(random_halfedge(live.mesh(), random));
    }
    const Bytes bytes = live.save();
    ASSERT_EQ(refusal_of(bytes), "");
    for (std::size_t size = 0; size < bytes.size(); ++size)
      ASSERT_NE(refusal_of(std::span(bytes).first(size)), "") << size;
    unsigned accepted = 0;
    unsigned refused = 0;
    for (std::size_t at = 0; at < bytes.size(); ++at)
      for (const unsigned flip : {1U, 2U, 0x80U, 0xFFU}) {
        Bytes altered = bytes;
        altered[at] ^= static_cast<std::byte>(flip);
        ASSERT_NE(refusal_of(altered), "") << at;
        if (at + 8 < bytes.size()) ++(refusal_of(sealed(altered)).empty() ? accepted : refused);
      }
    // Weights, layout and corners may be different.
    EXPECT_GT(refused, accepted / 2);
    EXPECT_GT(accepted, 0U);
  }
}

TEST(LiveSave, RefusalsSayWhatIsWrong) {
  LiveMesh live(sample::rectangle(2, 2));
  const Bytes bytes = live.save();
  EXPECT_NE(refusal_of(Bytes(100)).find("not a saved LiveMesh"), std::string::npos);
  EXPECT_NE(refusal_of(std::span(bytes).first(11)).find("truncated"), std::string::npos);
  EXPECT_NE(refusal_of(std::span(bytes).first(bytes.size() - 1)).find("checksum"), std::string::npos);
  Bytes other = bytes;
  other[8] = std::byte{3};
  EXPECT_NE(refusal_of(sealed(other)).find("version"), std::string::npos);
  other[8] = std::byte{1};
  EXPECT_NE(refusal_of(sealed(other)).find("older library"), std::string::npos);
  other = bytes;
  other.insert(other.end() - 8, std::byte{0});
  EXPECT_NE(refusal_of(sealed(other)).find("too long"), std::string::npos);
  other = bytes;
  for (std::size_t i = 37; i < 41; ++i) other[i] = std::byte{0xFF};  // the number of vertices
  EXPECT_NE(refusal_of(sealed(other)).find("truncated"), std::string::npos);
}

// A file with these triangles and solid sides, for the numbers 0 …; the rest as in a file of two triangles.
Bytes file_of(const std::vector<std::array<std::uint8_t, 4>>& triangles, std::uint8_t vertices, std::uint8_t free) {
  Bytes bytes = LiveMesh(std::vector<std::uint32_t>{0, 1, 2, 2, 1, 3}, 4).save();
  bytes.resize(33);
  const auto put = [&bytes](std::initializer_list<unsigned> numbers) {
    for (const unsigned number : numbers) bytes.push_back(static_cast<std::byte>(number));
  };
  const auto count = static_cast<unsigned>(triangles.size());
  put({count, 0, 0, 0, vertices, 0, 0, 0, (1U << count) - 1, free});
  for (const auto& [a, b, c, solid] : triangles) put({a, 0, 0, 0, b, 0, 0, 0, c, 0, 0, 0, solid});
  bytes.resize(bytes.size() + 8);
  return sealed(bytes);
}

TEST(LiveSave, RefusalsSayWhatDiffers) {
  EXPECT_EQ(refusal_of(file_of({{0, 1, 2, 0}, {2, 1, 3, 0}}, 4, 0)), "");
  EXPECT_EQ(refusal_of(file_of({{0, 1, 2, 2}, {2, 1, 3, 1}}, 4, 0)), "");
  const auto says = [](const Bytes& bytes, const char* what) {
    EXPECT_NE(refusal_of(bytes).find(what), std::string::npos) << refusal_of(bytes);
  };
  says(file_of({{0, 1, 1, 0}, {2, 1, 3, 0}}, 4, 0), "a corner twice");
  says(file_of({{0, 1, 2, 0}, {2, 1, 4, 0}}, 4, 0), "out of range");
  says(file_of({{0, 1, 2, 0}, {2, 1, 3, 0}}, 4, 8), "both free and in use");
  says(file_of({{0, 1, 2, 0}, {2, 1, 3, 0}}, 5, 32), "beyond its last");
  says(file_of({{0, 1, 2, 2}, {2, 1, 3, 0}}, 4, 0), "different colours");
  says(file_of({{0, 1, 2, 1}, {2, 1, 3, 0}}, 4, 0), "solid side on the boundary");
  says(file_of({{0, 1, 2, 8}, {2, 1, 3, 0}}, 4, 0), "more than three sides");
  // Three triangles around a vertex, joined to a cycle.
  says(file_of({{0, 1, 2, 5}, {0, 2, 3, 5}, {0, 3, 1, 5}}, 4, 0), "cycle");
}

// Edges are joined as building joins them: two sides of one edge cannot be left apart, and two edges between the same
// vertices are marked, so no operation meets them.
TEST(LiveSave, LoadedMeshesAreBuilt) {
  const LiveMesh joined = LiveMesh::load(file_of({{0, 1, 2, 0}, {2, 1, 3, 0}}, 4, 0));
  EXPECT_FALSE(StripMesh::on_boundary(joined.mesh().opposite(StripMesh::halfedge(0, 1))));
  const LiveMesh doubled = LiveMesh::load(file_of({{0, 1, 2, 0}, {2, 1, 3, 0}, {0, 1, 4, 0}, {4, 1, 0, 0}}, 5, 0));
  EXPECT_TRUE(doubled.mesh().non_manifold(0));
  EXPECT_TRUE(doubled.mesh().non_manifold(1));
}

// ---- the bytes of version 1.0
/// A sheet of 4 by 3 vertices in which vertex 5 went onto 6: two of twelve numbers of triangles are free.
constexpr std::string_view saved_by_1_0 =
    "526573747269704c02000000030300010000000002200000005f000000050000000c0000000c000000f70e40000000000001000000050000"
    "0006000000000500000004000000010100000002000000050000000602000000030000000700000004020000000700000005000000050400"
    "000005000000090000000604000000090000000800000001050000000a000000090000000505000000070000000b00000004050000000b00"
    "00000a000000053a88e333f7e46456";

std::vector<std::byte> bytes_of(std::string_view hexadecimal) {
  std::vector<std::byte> bytes;
  for (std::size_t i = 0; i < hexadecimal.size(); i += 2)
    bytes.push_back(static_cast<std::byte>(std::stoul(std::string(hexadecimal.substr(i, 2)), nullptr, 16)));
  return bytes;
}

TEST(SavedFile, OfVersion10IsReadAndWrittenAsItWas) {
  const LiveMesh live = LiveMesh::load(bytes_of(saved_by_1_0));
  using Corners = std::array<Vertex, 3>;
  constexpr Corners free{none, none, none};
  const std::vector<Corners> expected{{0, 1, 5}, {0, 5, 4}, {1, 2, 5}, free,       {2, 3, 7},  {2, 7, 5},
                                      {4, 5, 9}, {4, 9, 8}, free,      {5, 10, 9}, {5, 7, 11}, {5, 11, 10}};
  ASSERT_EQ(live.mesh().triangle_bound(), expected.size());
  for (Triangle t = 0; t < expected.size(); ++t) EXPECT_EQ(live.mesh().corners(t), expected[t]) << t;
  EXPECT_EQ(live.mesh().vertex_bound(), 12U);
  EXPECT_EQ(live.strips(), 2U);
  EXPECT_EQ(live.keeper().policy(), Policy::quick);
  EXPECT_EQ(LiveMesh::load(bytes_of(saved_by_1_0)).save(), bytes_of(saved_by_1_0));
}

}  // namespace
}  // namespace restrip
