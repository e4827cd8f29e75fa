// Finds the vertex at a point: the same bits, the two zeros being one. With attributes, by these too.
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

class VertexLookup {
 public:
  VertexLookup() = default;
  /// The attributes must outlive it.
  explicit VertexLookup(std::span<const Attribute> attributes) : attributes_(attributes) {}

  /// The vertex that was first put at this point with the attributes that `vertex` has; `vertex` if there was none.
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
