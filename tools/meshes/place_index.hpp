// Vertices by their places: the same bits, the two zeros being one.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <unordered_map>

#include "meshes/soup.hpp"

namespace restrip::tools {

class PlaceIndex {
 public:
  /// The vertex that was first put at this place: `vertex`, when there was none.
  std::uint32_t put(const Point& at, std::uint32_t vertex) {
    return vertex_.try_emplace({bits_of(at.x), bits_of(at.y), bits_of(at.z)}, vertex).first->second;
  }

 private:
  using Place = std::array<std::uint32_t, 3>;
  struct Hash {
    std::size_t operator()(const Place& place) const noexcept {
      std::uint64_t hash = 0;
      for (const std::uint32_t bits : place) hash = (hash ^ bits) * 0x9E3779B97F4A7C15U, hash ^= hash >> 29;
      return static_cast<std::size_t>(hash);
    }
  };
  static std::uint32_t bits_of(float value) { return std::bit_cast<std::uint32_t>(value + 0.0F); }

  std::unordered_map<Place, std::uint32_t, Hash> vertex_;
};

}  // namespace restrip::tools
