// A sparse set of numbers, visited in order. Included by annealing.hpp.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace restrip::detail {

/// Numbers below a bound as bits, 64 to a word, and above the words a bit for each that is not empty, and so on: the
/// next word with a number is found in O(log(bound)) steps, however many empty words lie between.
class MarkedWords {
 public:
  static constexpr std::size_t no_word = std::numeric_limits<std::size_t>::max();

  /// Empties the set.
  void reset(std::size_t bound) {
    levels_.clear();
    for (std::size_t words = (bound + 63) / 64; words != 0; words = words == 1 ? 0 : (words + 63) / 64)
      levels_.emplace_back(words, 0);
  }
  [[nodiscard]] bool empty() const noexcept { return levels_.empty(); }

  /// The numbers 64 * word … 64 * word + 63.
  [[nodiscard]] std::uint64_t operator[](std::size_t word) const noexcept { return levels_[0][word]; }
  void mark(std::size_t number) noexcept {
    for (auto& level : levels_) {
      std::uint64_t& word = level[number / 64];
      const bool was_empty = word == 0;
      word |= std::uint64_t{1} << number % 64;
      if (!was_empty) return;
      number /= 64;
    }
  }
  void clear(std::size_t number) noexcept {
    for (auto& level : levels_) {
      std::uint64_t& word = level[number / 64];
      word &= ~(std::uint64_t{1} << number % 64);
      if (word != 0) return;
      number /= 64;
    }
  }
  /// The first word from `word` on that is not empty, or no_word.
  [[nodiscard]] std::size_t next(std::size_t word) const noexcept {
    if (levels_.empty()) return no_word;
    if (word < levels_[0].size() && levels_[0][word] != 0) return word;
    std::size_t level = 1;
    for (; level < levels_.size(); ++level, word = word / 64 + 1) {
      if (word / 64 >= levels_[level].size()) return no_word;
      const std::uint64_t left = levels_[level][word / 64] >> word % 64;
      if (left == 0) continue;
      word += static_cast<unsigned>(std::countr_zero(left));
      break;
    }
    if (level == levels_.size()) return no_word;
    for (; level-- > 1;) word = word * 64 + static_cast<unsigned>(std::countr_zero(levels_[level][word]));
    return word;
  }

 private:
  std::vector<std::vector<std::uint64_t>> levels_;
};

}  // namespace restrip::detail
