// How the table of an operation file is laid out (docs/operation-file.md), and its look-up.
//
// A configuration is a mask of the inner edges before the operation and a mask of the ports, 1 = solid; the rule is a
// mask of the inner edges after it and a mask of the ports that stay solid. The entry of a configuration is
//
//     entries[inner << ports | P] = inner after << ports | ports kept
//
// and all ones where the configuration is not valid. In a matching the rule depends on the ports alone: entry P.
//
// Where the file gives the triangles with their vertices, the header has them too (SurfaceOperation), and
// operations/apply.hpp does the operation on a mesh.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace restrip::tables {

/// Triangles and inner edges of a patch.
struct PatchSize {
  unsigned triangles = 0;
  unsigned edges = 0;
};

template <class Entry, std::size_t Size>
struct OperationTable {
  PatchSize before;
  PatchSize after;
  unsigned ports = 0;
  bool matching = false;
  std::array<Entry, Size> entries;
};

/// A triangle of a patch, as one meets it from the first: across a side of one that was met before, its own side 0.
/// Side s runs from corner s to the next one, counter-clockwise.
struct PatchTriangle {
  std::uint8_t from = 0;       ///< met from this triangle; the first one from outside
  std::uint8_t from_side = 0;  ///< across this side of it
  std::array<std::uint8_t, 3> vertex{};
  std::array<std::uint8_t, 3> side{};  ///< an inner edge by its number; `port_side` + a port; or `boundary_side`

  static constexpr std::uint8_t port_side = 64;
  static constexpr std::uint8_t boundary_side = 255;  ///< on the boundary of the mesh, no port
};

/// With the triangles before and after the operation. The first one, and its side 0, are those that the file names
/// first. Vertices are numbered from 0 in the order in which the file names them, both sides of the operation together.
template <class Entry, std::size_t Size, std::size_t Before, std::size_t After>
struct SurfaceOperation : OperationTable<Entry, Size> {
  unsigned vertices = 0;
  std::array<PatchTriangle, Before> triangles_before;
  std::array<PatchTriangle, After> triangles_after;
};

/// What a rule says. `strips` is the change of the number of strips in the whole mesh; of a matching it is the change
/// in the number of pairs and single triangles together.
struct OperationRule {
  std::uint32_t colors = 0;  ///< inner edges after
  std::uint32_t ports = 0;   ///< ports that stay solid
  int strips = 0;
  bool valid = false;
};

/// The rule of a configuration: `inner` has before.edges bits, `ports` has ports bits; higher bits are a programming
/// error. Constant time. Not valid: dash everything, or look for the fault. A matching's table cannot tell whether
/// `inner` is valid and answers as if it were.
template <class Entry, std::size_t Size>
[[nodiscard]] constexpr OperationRule rule_of(const OperationTable<Entry, Size>& table, std::uint32_t inner,
                                              std::uint32_t ports) noexcept {
  const Entry entry = table.entries[table.matching ? ports : inner << table.ports | ports];
  if (entry == static_cast<Entry>(-1)) return {};
  const std::uint32_t colors = entry >> table.ports;
  const std::uint32_t kept = entry & ((std::uint32_t{1} << table.ports) - 1);
  const int strips_before = static_cast<int>(table.before.triangles) - std::popcount(inner) - std::popcount(ports);
  const int strips_after = static_cast<int>(table.after.triangles) - std::popcount(colors) - std::popcount(kept);
  return {colors, kept, strips_after - strips_before, true};
}

}  // namespace restrip::tables
