// What the examples with a mesh of another library compare: its triangles, and those that the index buffer draws.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Each triangle from its smallest corner on, in ascending order.
inline Triangles sorted(Triangles list) {
  for (auto& t : list) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(list.begin(), list.end());
  return list;
}

/// What a device draws of strips with primitive restart.
inline Triangles drawn(std::span<const std::uint32_t> indices) {
  Triangles list;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] == 0xFFFFFFFF) {
      begin = i + 1;
    } else if (i >= begin + 2) {
      const bool odd = (i - begin) % 2 != 0;
      const std::array<std::uint32_t, 3> t{indices[i - 2], indices[odd ? i : i - 1], indices[odd ? i - 1 : i]};
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) list.push_back(t);
    }
  }
  return sorted(std::move(list));
}
