// Claim: no sequence of bytes makes a reader do anything but return a soup whose corners exist, or throw BadInput.
// Noise is made from small valid files by seeded changes; run under the sanitizers to see more.
#include <gtest/gtest.h>

#include "bad_input.hpp"
#include "mesh_file.hpp"
#include "pm_file.hpp"
#include "random.hpp"
#include "shapes.hpp"
#include "simplify.hpp"

namespace restrip::replay {
namespace {

constexpr std::size_t rounds = 20000;

std::string with_noise(std::string bytes, Random& random) {
  for (std::uint32_t change = 0, changes = 1 + random.below(4); change < changes && !bytes.empty(); ++change) {
    const std::size_t at = random.below(static_cast<std::uint32_t>(bytes.size()));
    switch (random.below(5)) {
      case 0:
        bytes[at] = static_cast<char>(random.below(256));
        break;
      case 1:
        bytes.erase(at, 1 + random.below(8));
        break;
      case 2:
        bytes.insert(at, std::string(1 + random.below(4), "0123456789-./\n eE\xFF\\"[random.below(19)]));
        break;
      case 3:
        bytes.resize(at);
        break;
      default:
        bytes.insert(at, bytes.substr(random.below(static_cast<std::uint32_t>(bytes.size())), random.below(40)));
    }
  }
  return bytes;
}

void expect_sound(const Soup& soup) {
  for (const Corners& t : soup.triangles)
    for (const std::uint32_t corner : t) ASSERT_LT(corner, soup.points.size());
}

template <class Read>
void shake(const std::string& bytes, std::uint64_t seed, Read&& read) {
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  Random random(seed);
  std::size_t refused = 0;
  for (std::size_t round = 0; round < rounds; ++round) {
    const std::string noisy = with_noise(bytes, random);
    try {
      read(noisy);
    } catch (const BadInput&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 0U);
}

TEST(Noise, Obj) {
  shake("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0.5\nf 1/2/3 2//1 3\nf -1 -2 -3\nf 1 2 3 4\n", 1,
        [](const std::string& b) { expect_sound(read_obj(b, "f")); });
}
TEST(Noise, Off) {
  shake("OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0.5\n3 0 1 2\n4 0 1 3 2\n", 2,
        [](const std::string& b) { expect_sound(read_off(b, "f")); });
}
TEST(Noise, PlyText) {
  shake(
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
      3, [](const std::string& b) { expect_sound(read_ply(b, "f")); });
}
TEST(Noise, PlyBinary) {
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uint int vertex_indices\nend_header\n";
  bytes += std::string(36, '\0') + std::string("\3\0\0\0\0\0\0\0\1\0\0\0\2\0\0\0", 16);
  shake(bytes, 4, [](const std::string& b) { expect_sound(read_ply(b, "f")); });
}
TEST(Noise, StlText) {
  shake(
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
      "0\nendloop\nendfacet\nendsolid\n",
      5, [](const std::string& b) { expect_sound(read_stl(b, "f")); });
}
TEST(Noise, StlBinary) {
  std::string bytes(84 + 50, '\0');
  bytes[80] = 1;
  shake(bytes, 6, [](const std::string& b) { expect_sound(read_stl(b, "f")); });
}
TEST(Noise, ProgressiveMesh) {
  const std::string bytes = pm_bytes(simplify(sheet(4), {0.1, BoundaryPolicy::move}).mesh);
  shake(bytes, 7, [](const std::string& b) {
    for (const Corners& t : parse_pm(b, "f").base)
      for (const std::uint32_t corner : t) ASSERT_LT(corner, b.size());
  });
}

}  // namespace
}  // namespace restrip::replay
