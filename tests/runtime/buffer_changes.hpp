// Checks of buffers: that only the reported indices have changed, and that they draw their mesh.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "check_buffer.hpp"
#include "output/strip_buffer.hpp"
#include "output/triangle_list_buffer.hpp"

namespace restrip {

inline void expect_only_reported_changes(const std::vector<std::uint32_t>& before, std::span<const std::uint32_t> after,
                                         std::span<const IndexRange> ranges) {
  std::vector<bool> reported(after.size(), false);
  std::size_t end = 0;
  for (const auto& range : ranges) {
    ASSERT_TRUE(end == 0 || range.first > end);
    end = range.first + range.count;
    ASSERT_LE(end, after.size());
    std::fill_n(reported.begin() + static_cast<std::ptrdiff_t>(range.first), range.count, true);
  }
  for (std::size_t i = 0; i < after.size(); ++i)
    if (!reported[i]) {
      ASSERT_TRUE(i < before.size() && before[i] == after[i]) << "index " << i;
    }
}

inline BufferReport check_buffer(const StripBuffer& buffer, const StripMesh& mesh) {
  const bool narrow = buffer.width() == IndexWidth::bits16;
  return detail::compare_drawn(narrow ? triangles_of_strips(buffer.indices16()) : triangles_of_strips(buffer.indices()),
                               triangles_of(mesh));
}
inline BufferReport check_buffer(const TriangleListBuffer& buffer, const StripMesh& mesh) {
  const bool narrow = buffer.width() == IndexWidth::bits16;
  return detail::compare_drawn(narrow ? triangles_of_list(buffer.indices16()) : triangles_of_list(buffer.indices()),
                               triangles_of(mesh));
}

}  // namespace restrip
