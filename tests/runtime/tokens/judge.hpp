// What the programs of this folder share. Each asks one part of the look-ups whatever it can be asked and prints
// digests of the answers; tokens.py alters a token and compares.
//
//   PROGRAM          prints
//   PROGRAM RIGHT    ends with 1 at the first line that RIGHT, a file of what it should print, does not have
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <random>

#include "restrip/rules/bits.hpp"

namespace restrip::judge {

using Sizes = std::initializer_list<std::size_t>;

inline std::FILE* right = nullptr;

/// The digest of one kind of answer, printed at the end of its life.
class Digest {
 public:
  explicit Digest(const char* name, std::size_t k = 0) : name_(name), k_(k) {}
  ~Digest() {
    char line[80];
    std::snprintf(line, sizeof line, "%s %zu %016llx\n", name_, k_, static_cast<unsigned long long>(sum_));
    std::fputs(line, stdout);
    char expected[80] = "";
    if (right == nullptr ||
        (std::fgets(expected, sizeof expected, right) != nullptr && std::strcmp(line, expected) == 0))
      return;
    std::fflush(stdout);
    std::_Exit(1);
  }
  Digest(const Digest&) = delete;
  Digest& operator=(const Digest&) = delete;

  template <class... Number>
  void add(Number... numbers) {
    ((sum_ = sum_ * 1000003 + static_cast<std::uint64_t>(numbers)), ...);
  }

 private:
  const char* name_;
  std::size_t k_;
  std::uint64_t sum_ = 0;
};

inline std::mt19937_64 numbers(8);

/// Few bits as often as many.
inline Word some_bits(std::size_t n) {
  const Word mask = numbers() % 3 == 0 ? numbers() & numbers() : numbers() % 2 == 0 ? numbers() | numbers() : numbers();
  return n < 64 ? mask % (Word{1} << n) : mask;
}

/// Words for n bits. Whoever looks behind them ends the program.
class Bits {
 public:
  explicit Bits(std::size_t n, Word value = 0) : size_((n + 63) / 64) {
    void* const room = mmap(nullptr, 2 * page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (room == MAP_FAILED || mprotect(static_cast<char*>(room) + page, page, PROT_NONE) != 0) std::exit(2);
    page_ = static_cast<Word*>(room);
    for (std::size_t w = 0; w < size_; ++w) data()[w] = value;
  }
  ~Bits() { munmap(page_, 2 * page); }
  Bits(const Bits&) = delete;
  Bits& operator=(const Bits&) = delete;

  [[nodiscard]] Word* data() const { return page_ + page / sizeof(Word) - size_; }
  [[nodiscard]] BitSpan read() const { return {data()}; }
  [[nodiscard]] MutableBitSpan write() const { return {data()}; }
  void tell(Digest& told) const {
    for (std::size_t w = 0; w < size_; ++w) told.add(data()[w]);
  }

 private:
  static constexpr std::size_t page = 4096;
  std::size_t size_;
  Word* page_;
};

/// Many of n bits, or few.
class SomeBits : public Bits {
 public:
  explicit SomeBits(std::size_t n) : Bits(n) {
    const auto few = numbers() % 4;
    for (std::size_t i = 0; i < n; ++i)
      if (few == 1 ? numbers() % 16 == 0 : few == 2 ? numbers() % 64 == 0 : numbers() % 3 != 0)
        data()[i / 64] |= Word{1} << i % 64;
  }
};

/// Calls with every position of fans of k triangles: closed(a), open(i, j), gap(i).
template <class Closed, class Open, class Gap>
void each_position(std::size_t k, const Closed& closed, const Open& open, const Gap& gap) {
  for (std::size_t a = 1; k > 2 && a < k; ++a) closed(a);
  for (std::size_t j = 1; j <= k; ++j)
    for (std::size_t i = 0; i < j; ++i) open(i, j);
  for (std::size_t i = 0; i <= k; ++i) gap(i);
}

/// Opens RIGHT and asks one part after the other: all that main() does.
inline int run(int argc, char** argv, std::initializer_list<void (*)()> parts) {
  if (argc > 1 && (right = std::fopen(argv[1], "r")) == nullptr) std::exit(2);
  for (const auto part : parts) part();
  return 0;
}

}  // namespace restrip::judge
