// Vertices by their places: the same bits, the two zeros being one. With attributes, by these too.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>

#include "meshes/little_endian.hpp"
#include "meshes/soup.hpp"

namespace restrip::tools {

class PlaceIndex {
 public:
  PlaceIndex() = default;
  /// The attributes must outlive it.
  explicit PlaceIndex(std::span<const Attribute> attributes) : attributes_(attributes) {}

  /// The vertex that was first put at this place, with the attributes that `vertex` has: `vertex`, when there was none.
  std::uint32_t put(const Point& at, std::uint32_t vertex) {
    key_.clear();
    restrip::tools::put(key_, {at.x + 0.0F, at.y + 0.0F, at.z + 0.0F});
    for (const Attribute& attribute : attributes_)
      key_.append(attribute.bytes, vertex * attribute.value_bytes(), attribute.value_bytes());
    return vertex_.try_emplace(key_, vertex).first->second;
  }

 private:
  std::span<const Attribute> attributes_;
  std::string key_;
  std::unordered_map<std::string, std::uint32_t> vertex_;
};

}  // namespace restrip::tools
