// How the generated tables are laid out. The data are in restrip/tables/*.hpp, written by restrip-generate; nothing
// there explains itself, so here is what the numbers mean.
//
// A rule of a fan family depends on its position and on a key of two masks, (ports, joined): docs/reference/notation.md
// says why. Of the 4^k pairs of masks only a few thousand are keys, so the keys of one valence are packed by *row
// displacement* (Tarjan and Yao, "Storing a sparse table", 1979): the row of `ports` starts at rows[1 << k | ports],
// and the cell of a key lies `joined` cells further. Rows overlap like combs; no two keys share a cell. All positions
// of a valence use the same packing, one block of cells after the other:
//
//     rules[first[k] + place * cells[k] + rows[1 << k | ports] + joined]
//
// Example, k = 4, a = 2: with ports 0b0101 solid and joined to each other, the cell is
// first[4] + 1 * cells[4] + rows[0b10101] + 0b0101.
// In a closed fan with exactly two solid ports either bit of `joined`, or both, stands for the pair: all three cells
// are filled.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace restrip {

/// Places inside a table: 16 bits if they suffice, 32 in tables that go beyond k = 8 (docs/reference/tables.md, "Larger
/// tables").
template <unsigned MaxK>
using TableIndex = std::conditional_t<MaxK <= 8, std::uint16_t, std::uint32_t>;

/// Where the rows of keys start: index 1 << k | ports.
template <unsigned MaxK>
using RowStarts = std::array<TableIndex<MaxK>, std::size_t{2} << MaxK>;

/// The rules of one family. `Entry` has room for a recolouring: k + 3 bits for splits, k bits for collapses.
template <class Entry, unsigned MaxK, std::size_t Cells>
struct RuleTable {
  std::array<std::uint32_t, MaxK + 1> first;     ///< where the blocks of valence k start
  std::array<TableIndex<MaxK>, MaxK + 1> cells;  ///< cells in one block of valence k
  std::array<Entry, Cells> rules;                ///< recolourings; cells without a key hold 0
};

/// The rules of the flip, index inner << 4 | ports: the new inner edge in bit 4, the ports kept in bits 0 … 3; 0xff
/// where the configuration is invalid.
using FlipTable = std::array<std::uint8_t, 32>;

}  // namespace restrip
