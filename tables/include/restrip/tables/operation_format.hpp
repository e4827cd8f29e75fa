// How the table of an operation file is laid out (docs/reference/operation-file.md), and its look-up.
//
// A configuration is a mask of the inner edges before the operation and a mask of the ports, 1 = solid; the rule is a
// mask of the inner edges after it and a mask of the ports that stay solid. The entry of a configuration is
//
//     entries[inner << ports | P] = inner after << ports | ports kept
//
// and all ones where the configuration is not valid. In a matching the rule depends on the ports alone: entry P.
//
// A family has the tables of all its positions one after another (OperationFamily).
//
// The header also has the triangles before and after the operation (SurfaceOperation, SurfaceFamily), for programs that
// change a mesh; restrip/operations/apply.hpp is one.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

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

/// A triangle of a patch. Triangles are in traversal order; each after the first is entered through its side 0, across
/// a side of an earlier one. Side s runs from corner s to the next one, counter-clockwise.
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

/// The numbers of a position, in the order in which the file names them; unused ones are 0.
using FamilyNumbers = std::array<unsigned, 3>;

/// One position of a family.
struct FamilyPosition {
  FamilyNumbers numbers{};
  PatchSize before;
  PatchSize after;
  unsigned ports = 0;
  std::size_t first = 0;  ///< its entries begin here
};

/// The tables of all positions of a family, up to some largest first number.
template <class Entry, std::size_t Size, std::size_t Positions>
struct OperationFamily {
  bool matching = false;
  const char* position = "";  ///< how dumps name a position: "k {0} a {1}", by the places of its numbers
  std::array<FamilyPosition, Positions> positions;  ///< in ascending order of their numbers
  std::array<Entry, Size> entries;
};

/// The triangles of a SurfaceFamily that belong to a position.
struct PositionTriangles {
  unsigned vertices = 0;
  std::size_t first_before = 0;
  std::size_t first_after = 0;
};

/// With the triangles of all positions, numbered as in SurfaceOperation in each of them.
template <class Entry, std::size_t Size, std::size_t Positions, std::size_t Before, std::size_t After>
struct SurfaceFamily : OperationFamily<Entry, Size, Positions> {
  std::array<PositionTriangles, Positions> position_triangles;  ///< in the order of `positions`
  std::array<PatchTriangle, Before> triangles_before;
  std::array<PatchTriangle, After> triangles_after;
};

/// The most triangles and ports that a side of an operation has.
inline constexpr std::size_t most_patch_triangles = 16;
inline constexpr std::size_t most_patch_ports = 12;

/// One position of a SurfaceFamily, to be used like a SurfaceOperation. It refers to the family.
template <class Entry>
struct PositionTable {
  PatchSize before;
  PatchSize after;
  unsigned ports = 0;
  bool matching = false;
  const Entry* entries = nullptr;
  unsigned vertices = 0;
  std::span<const PatchTriangle> triangles_before;
  std::span<const PatchTriangle> triangles_after;
};

/// What a rule says. `strips` is the change of the number of strips in the whole mesh; of a matching it is the change
/// in the number of pairs and single triangles together.
struct OperationRule {
  std::uint32_t colors = 0;  ///< inner edges after
  std::uint32_t ports = 0;   ///< ports that stay solid
  int strips = 0;
  bool valid = false;

  /// The meaning of an entry for a configuration, if a patch has this size. `none` is the entry of configurations that
  /// are not valid.
  [[nodiscard]] static constexpr OperationRule in_entry(std::uint32_t entry, std::uint32_t none, PatchSize before,
                                                        PatchSize after, unsigned port_count, std::uint32_t inner,
                                                        std::uint32_t ports) noexcept {
    if (entry == none) return {};
    const std::uint32_t colors = entry >> port_count;
    const std::uint32_t kept = entry & ((std::uint32_t{1} << port_count) - 1);
    const int strips_before = static_cast<int>(before.triangles) - std::popcount(inner) - std::popcount(ports);
    const int strips_after = static_cast<int>(after.triangles) - std::popcount(colors) - std::popcount(kept);
    return {colors, kept, strips_after - strips_before, true};
  }
};

/// Some of the inner edges and the ports of a patch, such as the solid ones: edge i is bit i, port i is bit 32 + i.
using PatchEdges = std::uint64_t;

constexpr PatchEdges patch_edges(std::uint32_t edges, std::uint32_t ports) noexcept {
  return PatchEdges{ports} << 32 | edges;
}
/// The bit of a side of a PatchTriangle; for the boundary, which is dashed, a bit that belongs to no port.
constexpr PatchEdges edge_of(std::uint8_t side) noexcept {
  static_assert(PatchTriangle::port_side == 64 && PatchTriangle::boundary_side == 255);
  return PatchEdges{1} << ((side & 31U) | (side >> 1 & 32U));
}

/// The isolated triangles of one side of a patch.
template <class Triangles>
[[nodiscard]] constexpr int isolated_among(const Triangles& triangles, PatchEdges solid) noexcept {
  int isolated = 0;
  for (const auto& [from, from_side, vertex, side] : triangles)
    isolated += (solid & (edge_of(side[0]) | edge_of(side[1]) | edge_of(side[2]))) == 0 ? 1 : 0;
  return isolated;
}

/// The rule of a configuration: `inner` has before.edges bits, `ports` has ports bits; higher bits are a programming
/// error. Constant time. If the answer is not valid, clear every edge, or look for the fault. A matching's table does
/// not know whether `inner` is valid and answers as if it were.
template <class Entry, std::size_t Size>
[[nodiscard]] constexpr OperationRule rule_of(const OperationTable<Entry, Size>& table, std::uint32_t inner,
                                              std::uint32_t ports) noexcept {
  return OperationRule::in_entry(table.entries[table.matching ? ports : inner << table.ports | ports],
                                 static_cast<Entry>(-1), table.before, table.after, table.ports, inner, ports);
}
/// The same at a position of a family. Not valid if the family has no such position.
template <class Entry>
[[nodiscard]] constexpr OperationRule rule_of(const PositionTable<Entry>& table, std::uint32_t inner,
                                              std::uint32_t ports) noexcept {
  if (table.entries == nullptr) return {};
  return OperationRule::in_entry(table.entries[table.matching ? ports : inner << table.ports | ports],
                                 static_cast<Entry>(-1), table.before, table.after, table.ports, inner, ports);
}

/// Which of its positions has these numbers: found in logarithmic time; family.positions.size() if none has.
template <class Entry, std::size_t Size, std::size_t Positions>
[[nodiscard]] constexpr std::size_t place_of(const OperationFamily<Entry, Size, Positions>& family,
                                             const FamilyNumbers& numbers) noexcept {
  const auto at = std::lower_bound(
      family.positions.begin(), family.positions.end(), numbers,
      [](const FamilyPosition& position, const FamilyNumbers& wanted) { return position.numbers < wanted; });
  return at == family.positions.end() || at->numbers != numbers
             ? Positions
             : static_cast<std::size_t>(at - family.positions.begin());
}

/// The rules and triangles of a position, as a table; one without triangles if the family has no such position.
template <class Entry, std::size_t Size, std::size_t Positions, std::size_t Before, std::size_t After>
[[nodiscard]] constexpr PositionTable<Entry> position_of(
    const SurfaceFamily<Entry, Size, Positions, Before, After>& family, const FamilyNumbers& numbers) noexcept {
  const std::size_t place = place_of(family, numbers);
  if (place == Positions) return {};
  const FamilyPosition& at = family.positions[place];
  const PositionTriangles& triangles = family.position_triangles[place];
  return {at.before,
          at.after,
          at.ports,
          family.matching,
          family.entries.data() + at.first,
          triangles.vertices,
          std::span(family.triangles_before).subspan(triangles.first_before, at.before.triangles),
          std::span(family.triangles_after).subspan(triangles.first_after, at.after.triangles)};
}

/// The rule of a configuration at a position. Not valid if the family has no such position.
template <class Entry, std::size_t Size, std::size_t Positions>
[[nodiscard]] constexpr OperationRule rule_of(const OperationFamily<Entry, Size, Positions>& family,
                                              const FamilyNumbers& numbers, std::uint32_t inner,
                                              std::uint32_t ports) noexcept {
  const std::size_t place = place_of(family, numbers);
  if (place == Positions) return {};
  const FamilyPosition& at = family.positions[place];
  return OperationRule::in_entry(family.entries[at.first + (family.matching ? ports : inner << at.ports | ports)],
                                 static_cast<Entry>(-1), at.before, at.after, at.ports, inner, ports);
}

}  // namespace restrip::tables
