// A mesh that version 1.0 saved is read by every later version 1 (docs/reference/stability.md): its bytes are written
// down here, and so is what they mean. A change of the format needs a new number, and a reader of both.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "restrip/live_mesh.hpp"
#include "restrip/search/keeper.hpp"

namespace restrip {
namespace {

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

TEST(SavedFile, OfVersion10IsRead) {
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
}

TEST(SavedFile, IsWrittenAsVersion10Did) {
  EXPECT_EQ(LiveMesh::load(bytes_of(saved_by_1_0)).save(), bytes_of(saved_by_1_0));
}

}  // namespace
}  // namespace restrip
