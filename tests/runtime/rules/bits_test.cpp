// Masks and bit strings against strings of zeroes and ones: every position of a word and beyond it, and strings that go
// over the ends of words.
#include "restrip/rules/bits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace restrip {
namespace {

static_assert(bit(0) == 1 && bit(63) == Word{1} << 63 && bit(64) == 0 && bit(nowhere) == 0);
static_assert(low_bits(0) == 0 && low_bits(64) == ~Word{0} && low_bits(nowhere) == ~Word{0});
static_assert(words_for(0) == 0 && words_for(1) == 1 && words_for(64) == 1 && words_for(65) == 2);

/// Bit i is character i.
std::string text_of(Word mask) {
  std::string text;
  for (; text.size() < word_bits; mask /= 2) text += mask % 2 == 0 ? '0' : '1';
  return text;
}

TEST(Bits, MasksAreStringsOfZeroesAndOnes) {
  std::mt19937_64 random(1);
  for (int round = 0; round < 200; ++round) {
    const Word mask = round == 0 ? 0 : round == 1 ? ~Word{0} : random() & (round % 2 == 0 ? random() : ~Word{0});
    const std::string text = text_of(mask);
    const auto ones = std::count(text.begin(), text.end(), '1');
    EXPECT_EQ(count_bits(mask), ones);
    for (const Word other : {random(), random() >> 32, Word{0}}) {
      EXPECT_EQ(count_difference(mask, other), ones - count_bits(other));
      EXPECT_EQ(count_difference(mask >> 32, other), count_bits(mask >> 32) - count_bits(other));
    }
    for (std::size_t i = 0; i < word_bits; ++i) {
      EXPECT_EQ(has(mask, i), text[i] == '1');
      std::string longer = text;
      longer.insert(i, "0");
      longer.pop_back();
      EXPECT_EQ(text_of(insert_zero(mask, i)), longer) << i;
      std::string shorter = text;
      shorter.erase(i, 1);
      EXPECT_EQ(text_of(remove_bit(mask, i)), shorter + "0") << i;
      EXPECT_EQ(text_of(mask & low_bits(i)), text.substr(0, i) + std::string(word_bits - i, '0'));
    }
    EXPECT_FALSE(has(mask, word_bits));
    EXPECT_EQ(insert_zero(mask, word_bits), mask);
  }
}

TEST(Bits, StringsGoOverTheEndsOfWords) {
  std::mt19937_64 random(2);
  for (const std::size_t n : {1U, 63U, 64U, 65U, 128U, 150U})
    for (const unsigned one_in : {2U, 40U, 1000U}) {
      std::vector<bool> plain(n);
      std::vector<Word> words(words_for(n) + 1, ~Word{0});
      const MutableBitSpan bits{words.data()};
      bits.clear(n);
      EXPECT_EQ(words.back(), ~Word{0});  // no word of others
      for (std::size_t i = 0; i < n; ++i)
        if (random() % one_in == 0) {
          plain[i] = true;
          bits.set(i);
        }
      const BitSpan read = bits;
      for (std::size_t from = 0; from <= n; ++from) {
        if (from < n) {
          EXPECT_EQ(read[from], plain[from]);
        }
        const auto found = std::find(plain.begin() + static_cast<std::ptrdiff_t>(from), plain.end(), true);
        const auto first = static_cast<std::size_t>(found - plain.begin());
        EXPECT_EQ(read.first_set(from, n), found == plain.end() ? nowhere : first);
        EXPECT_EQ(read.first_set(from, first), nowhere) << "the end does not count";
      }
    }
}

}  // namespace
}  // namespace restrip
