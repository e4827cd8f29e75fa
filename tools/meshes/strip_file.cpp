#include "meshes/strip_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "meshes/little_endian.hpp"

namespace restrip::tools {

std::string index_bytes(std::span<const std::uint32_t> indices) {
  std::string bytes;
  bytes.reserve(4 * indices.size());
  for (const std::uint32_t index : indices) put(bytes, index);
  return bytes;
}

std::string as_text(const std::vector<std::string>& required_extensions, const std::string& name) {
  if (required_extensions.empty()) return {};
  return fmt::format("{}: requires {}, a proposal that few viewers know; the others refuse the file\n", name,
                     fmt::join(required_extensions, ", "));
}

}  // namespace restrip::tools
