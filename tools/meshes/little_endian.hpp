// Little-endian numbers as bytes.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "meshes/soup.hpp"
#include "restrip/output/strip_format.hpp"

namespace restrip::tools {

inline void put(std::string& bytes, std::uint32_t value, unsigned width = 4) {
  for (unsigned i = 0; i < width; ++i) bytes.push_back(static_cast<char>(value >> (8 * i) & 0xFFU));
}

/// In 32 bits per coordinate.
inline void put(std::string& bytes, const Point& p) {
  for (const double coordinate : {p.x, p.y, p.z})
    put(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(coordinate)));
}

/// 2 or 4 bytes per index.
inline void put(std::string& bytes, const IndexBuffer& buffer) {
  const auto width = static_cast<unsigned>(buffer.index_bytes());
  bytes.reserve(bytes.size() + width * buffer.size());
  std::visit(
      [&](const auto& indices) {
        for (const auto index : indices) put(bytes, index, width);
      },
      buffer.indices);
}

/// The number at an offset, which must be valid.
[[nodiscard]] inline std::uint32_t little_endian(std::string_view bytes, std::size_t at, unsigned width = 4) {
  std::uint32_t value = 0;
  for (unsigned i = 0; i < width; ++i) value |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
  return value;
}

}  // namespace restrip::tools
