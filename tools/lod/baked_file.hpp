// Baked progressive meshes as files. docs/reference/file-formats.md specifies the format: compact, versioned, with a
// checksum over every byte.
#pragma once

#include <string>
#include <string_view>

#include "lod/bake.hpp"
#include "restrip/formats/baked_format.hpp"

namespace restrip::tools {

/// Throws BadInput if the bytes have another format or version, are truncated or altered, or describe splits or colours
/// that no mesh can have. Plays all records once.
[[nodiscard]] BakedMesh parse_baked(std::string_view bytes, const std::string& name);

/// Renumbers the vertices in order of appearance, as pm_bytes does.
[[nodiscard]] std::string baked_bytes(const BakedMesh& baked);

/// baked_format::fnv1a of characters.
[[nodiscard]] constexpr std::uint64_t fnv1a(std::string_view bytes) noexcept {
  return baked_format::fnv1a(std::span<const char>(bytes));
}

}  // namespace restrip::tools
