// Colours as bits: masks of one 64-bit word, and views of bit strings of any length.
//
// Bit 0 is the lowest bit of the first word, 1 = solid, 0 = dashed, as docs/reference/notation.md counts them.
// Everything here is constexpr, noexcept and constant time unless it says otherwise, and nothing allocates.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "restrip/precondition.hpp"

namespace restrip {

using Word = std::uint64_t;

inline constexpr std::size_t word_bits = 64;

/// "No such position." Larger than every index, so comparisons with it need no special case.
inline constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

/// The mask with bit i alone; zero when i >= 64.
constexpr Word bit(std::size_t i) noexcept { return i < word_bits ? Word{1} << i : Word{0}; }

/// The mask with bits 0 ... n-1; all bits when n >= 64.
constexpr Word low_bits(std::size_t n) noexcept { return n < word_bits ? (Word{1} << n) - 1 : ~Word{0}; }

/// Bit i of a mask; false when i >= 64.
constexpr bool has(Word mask, std::size_t i) noexcept { return (mask & bit(i)) != 0; }

/// Moves bit `position` and all higher bits one place up, and leaves a zero at `position`. The top bit is lost. The
/// identity when position >= 64.
constexpr Word insert_zero(Word mask, std::size_t position) noexcept {
  const Word below = low_bits(position);
  return (mask & below) | ((mask & ~below) << 1);
}

/// The inverse of insert_zero: removes bit `position`; the bits above it move one place down.
constexpr Word remove_bit(Word mask, std::size_t position) noexcept {
  const Word below = low_bits(position);
  return (mask & below) | ((mask >> 1) & ~below);
}

/// The number of set bits, as an int. Written out because lookups count bits on their fast path, and std::popcount is a
/// library call unless the compiler may assume the instruction.
constexpr int count_bits(Word mask) noexcept {
  mask -= mask >> 1 & 0x5555555555555555U;
  mask = (mask & 0x3333333333333333U) + (mask >> 2 & 0x3333333333333333U);
  mask = (mask + (mask >> 4)) & 0x0f0f0f0f0f0f0f0fU;
  return static_cast<int>(mask * 0x0101010101010101U >> 56);
}

// count_bits(a) - count_bits(b); masks below 2^32, the usual ones, are counted together.
constexpr int count_difference(Word a, Word b) noexcept {
  if (((a | b) >> 32) != 0) return count_bits(a) - count_bits(b);
  return count_bits(a | (b ^ 0xffffffffU) << 32) - 32;
}

// The number of words that n bits take.
constexpr std::size_t words_for(std::size_t n) noexcept { return (n + word_bits - 1) / word_bits; }

/// A read-only view of a bit string in consecutive words, little-endian. It does not own the words and does not know
/// their number: the function that takes it says how many bits it reads. Later bits are never read.
struct BitSpan {
  const Word* words = nullptr;

  /// One word as a bit string of up to 64 bits; the word must outlive the view.
  static constexpr BitSpan of(const Word& word) noexcept { return {&word}; }

  constexpr bool operator[](std::size_t i) const noexcept {
    return ((words[i / word_bits] >> (i % word_bits)) & 1) != 0;
  }

  /// The lowest set bit in [from, to), or `nowhere`. Time: one step a word.
  constexpr std::size_t first_set(std::size_t from, std::size_t to) const noexcept {
    while (from < to) {
      const Word rest = words[from / word_bits] >> (from % word_bits);
      if (rest != 0) {
        const std::size_t found = from + static_cast<std::size_t>(std::countr_zero(rest));
        return found < to ? found : nowhere;
      }
      from = (from / word_bits + 1) * word_bits;
    }
    return nowhere;
  }
};

/// A view through which a result is written. The words must not overlap the words of any argument.
struct MutableBitSpan {
  Word* words = nullptr;

  static constexpr MutableBitSpan of(Word& word) noexcept { return {&word}; }

  constexpr operator BitSpan() const noexcept { return {words}; }

  constexpr void set(std::size_t i) const noexcept { words[i / word_bits] |= bit(i % word_bits); }

  /// Zeroes every word that holds one of the first n bits, including its higher bits.
  constexpr void clear(std::size_t n) const noexcept {
    for (std::size_t w = 0; w < words_for(n); ++w) words[w] = 0;
  }
};

}  // namespace restrip
