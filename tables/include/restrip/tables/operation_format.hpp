// How the table of an operation file is laid out (docs/operation-file.md), and its look-up.
//
// A configuration is a mask of the inner edges before the operation and a mask of the ports, 1 = solid; the rule is a
// mask of the inner edges after it and a mask of the ports that stay solid. The entry of a configuration is
//
//     entries[inner << ports | P] = inner after << ports | ports kept
//
// and all ones where the configuration is not valid. In a matching the rule depends on the ports alone: entry P.
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
