// Checks that only the reported indices of a buffer have changed.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "restrip/output/strip_buffer.hpp"

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

}  // namespace restrip
