// FileBytes put together by hand from docs/reference/file-formats.md are read as the page says: the base with its
// colours, a record with its flips, a payload. A change of any byte, and any missing byte, is refused. The tests of the
// tools read files that programs write.
#include "restrip/formats/baked_file.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "restrip/output/strips.hpp"

namespace restrip {
namespace {

class FileBytes {
 public:
  void u8(std::uint8_t value) { all_.push_back(std::byte{value}); }
  void u32(std::uint32_t value) {
    for (unsigned i = 0; i < 4; ++i) u8(static_cast<std::uint8_t>(value >> (8 * i)));
  }
  void point(float x, float y, float z) {
    for (const float f : {x, y, z}) u32(std::bit_cast<std::uint32_t>(f));
  }
  void text(const char* characters) {
    for (; *characters != '\0'; ++characters) u8(static_cast<std::uint8_t>(*characters));
  }
  /// FNV-1a as its authors write it down: an exclusive or, then a multiplication by 2^40 + 2^8 + 0xb3.
  [[nodiscard]] std::vector<std::byte> with_checksum() const {
    std::uint64_t hash = 14'695'981'039'346'656'037U;
    for (const std::byte b : all_) {
      hash ^= std::to_integer<std::uint64_t>(b);
      hash = (hash << 40) + (hash << 8) + hash * 0xb3;
    }
    FileBytes whole = *this;
    whole.u32(static_cast<std::uint32_t>(hash));
    whole.u32(static_cast<std::uint32_t>(hash >> 32));
    return whole.all_;
  }

 private:
  std::vector<std::byte> all_;
};

/// A square of two triangles, 0 1 2 and 2 1 3, in one strip. The record splits vertex 1 along its spokes to 2 and 3.
FileBytes square(std::uint32_t version) {
  FileBytes bytes;
  bytes.text("RestripB");
  bytes.u32(version);
  for (const std::uint32_t n : {4U, 2U, 1U}) bytes.u32(n);
  if (version == 2) bytes.u32(3);
  bytes.point(0, 0, 0);
  bytes.point(1, 0, 0);
  bytes.point(0, 1, 0);
  bytes.point(1, 1, 0);
  for (const std::uint32_t corner : {0U, 1U, 2U, 2U, 1U, 3U}) bytes.u32(corner);
  bytes.u8(0b010);  // from 1 to 2
  bytes.u8(0b001);  // from 2 to 1
  bytes.point(0.5F, 0.25F, 0);
  bytes.u8(1);            // v_s
  bytes.u8(2 * (3 + 1));  // v_l is vertex 2, the second of its three neighbours 0, 2, 3; v_r is missing
  bytes.u8(0);            // no flips
  if (version == 2) bytes.text("abc");
  return bytes;
}

TEST(BakedFileByHand, IsReadAsThePageSays) {
  for (const std::uint32_t version : {1U, 2U}) {
    BakedFile file;
    ASSERT_EQ(read_baked(square(version).with_checksum(), file), "");
    EXPECT_EQ(file.points.size(), 5U);
    EXPECT_EQ(file.points[4], (std::array<float, 3>{0.5F, 0.25F, 0}));
    EXPECT_EQ(file.base, (std::vector<std::array<Vertex, 3>>{{0, 1, 2}, {2, 1, 3}}));
    EXPECT_EQ(check_coloring(file.mesh).strips, 1U);
    ASSERT_EQ(file.splits.size(), 1U);
    EXPECT_EQ(file.splits[0].v_s, 1U);
    EXPECT_EQ(file.splits[0].v_t, 4U);
    EXPECT_EQ(file.splits[0].v_l, 2U);
    EXPECT_EQ(file.splits[0].v_r, none);
    EXPECT_EQ(file.payload[0].size(), version == 2 ? 3U : 0U);
    split_baked(file.mesh, spokes_of(file.mesh, file.splits[0]), file.records[0], file.splits[0].v_t);
    EXPECT_EQ(file.mesh.triangle_count(), 3U);
    EXPECT_TRUE(check_coloring(file.mesh).valid);
  }
}

TEST(BakedFileByHand, WhatIsAlteredOrMissingIsRefused) {
  const std::vector<std::byte> right = square(2).with_checksum();
  const auto refused = [](std::vector<std::byte> bytes) {
    BakedFile file;
    file.points.resize(7);
    const std::string fault = read_baked(bytes, file);
    EXPECT_EQ(file.points.size(), fault.empty() ? 5U : 7U) << "what is refused leaves the file as it was";
    return !fault.empty();
  };
  EXPECT_FALSE(refused(right));
  for (std::size_t i = 0; i < right.size(); ++i) {
    std::vector<std::byte> bytes = right;
    bytes[i] ^= std::byte{0x10};
    EXPECT_TRUE(refused(bytes)) << "byte " << i;
    bytes = right;
    bytes.resize(i);
    EXPECT_TRUE(refused(bytes)) << i << " bytes";
  }
}

TEST(BakedFileByHand, PayloadsAreGivenAndTakenAway) {
  std::vector<std::byte> bytes = square(1).with_checksum();
  const std::array payload{std::byte{'a'}, std::byte{'b'}, std::byte{'c'}};
  EXPECT_EQ(set_payload(bytes, payload), "");
  EXPECT_EQ(bytes, square(2).with_checksum());
  EXPECT_EQ(set_payload(bytes, {}), "");
  EXPECT_EQ(bytes, square(1).with_checksum());
}

}  // namespace
}  // namespace restrip
