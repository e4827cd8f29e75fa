#include "meshes/strip_file.hpp"

#include "meshes/little_endian.hpp"

namespace restrip::tools {

std::string index_bytes(std::span<const std::uint32_t> indices) {
  std::string bytes;
  bytes.reserve(4 * indices.size());
  for (const std::uint32_t index : indices) put(bytes, index);
  return bytes;
}

}  // namespace restrip::tools
