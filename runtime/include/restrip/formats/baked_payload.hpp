// User data of a baked mesh.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "restrip/precondition.hpp"

namespace restrip {

/// User data for each record, the same number of bytes for all: a texture coordinate, an error bound, a priority.
struct BakedPayload {
  std::size_t bytes = 0;  ///< for each record; 0: none
  std::vector<std::byte> all;

  [[nodiscard]] std::span<const std::byte> operator[](std::size_t record) const noexcept {
    return std::span(all).subspan(record * bytes, bytes);
  }
};

}  // namespace restrip
