// Shared by the dumps: lines, fast (millions of them go through one buffer), and the positions of the rules.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

#include "restrip/rules/rules.hpp"

namespace restrip::dump {

class Output {
 public:
  explicit Output(std::FILE* file) : file_(file) { text_.reserve(size); }

  void line(const std::string& words) {
    text_ += words;
    text_ += '\n';
    flush_if_full();
  }
  void text(std::string_view words) { text_ += words; }
  void hex(Word value, char after) {
    char digits[16];
    int n = 0;
    do {
      digits[n++] = "0123456789abcdef"[value & 15U];
      value >>= 4;
    } while (value != 0);
    while (n > 0) text_ += digits[--n];
    text_ += after;
  }
  /// After each entry line.
  void entry_done() {
    ++lines_;
    flush_if_full();
  }
  /// False when not everything could be written.
  bool finish() {
    line("end " + std::to_string(lines_));
    flush();
    return std::fflush(file_) == 0 && std::ferror(file_) == 0;
  }

 private:
  static constexpr std::size_t size = std::size_t{1} << 16;
  void flush() {
    std::fwrite(text_.data(), 1, text_.size(), file_);
    text_.clear();
  }
  void flush_if_full() {
    if (text_.size() > size - 4096) flush();
  }
  std::FILE* file_;
  std::string text_;
  std::size_t lines_ = 0;
};

/// Calls visit(operation, k, p, q, bits, rule) for every position of operations 0 to 5 with k <= max_k: `bits` colours
/// before, whose rule is rule(before, ports).
template <class Visit>
void for_each_position(std::size_t max_k, Visit&& visit) {
  for (const bool collapse : {false, true})
    for (std::size_t k = 3; k <= max_k; ++k)
      for (std::size_t a = 1; a < k; ++a)
        visit(collapse ? 1U : 0U, k, a, std::size_t{0}, collapse ? k + 3 : k, [=](Word before, Word ports) {
          return collapse ? collapse_rule({k, a}, before, ports) : split_rule({k, a}, before, ports);
        });
  for (const bool collapse : {false, true})
    for (std::size_t k = 1; k <= max_k; ++k)
      for (std::size_t i = 0; i < k; ++i)
        for (std::size_t j = i + 1; j <= k; ++j)
          visit(collapse ? 3U : 2U, k, i, j, collapse ? k + 2 : k - 1, [=](Word before, Word ports) {
            return collapse ? open_collapse_rule({k, i, j}, before, ports) : open_split_rule({k, i, j}, before, ports);
          });
  for (const bool collapse : {false, true})
    for (std::size_t k = 1; k <= max_k; ++k)
      for (std::size_t i = 0; i <= k; ++i)
        visit(collapse ? 5U : 4U, k, i, std::size_t{0}, collapse ? k : k - 1, [=](Word before, Word ports) {
          return collapse ? boundary_collapse_rule({k, i}, before, ports) : boundary_split_rule({k, i}, before, ports);
        });
}

/// The numbers of the automaton, and a digest of its answers to every key of every position with k <= max_k.
void automaton(Output& out, std::size_t max_k);

/// Digests of what the automaton's look-up answers in positions with k <= max_k (docs/reference/verifiers.md, "Digests
/// of the automaton"). False when not everything could be written.
bool automaton_digests(std::size_t max_k);

/// What a digest adds up (docs/reference/verifiers.md, "Digests of answers").
constexpr std::uint32_t mix(Word before, Word ports, std::uint32_t answer) {
  std::uint32_t h =
      answer ^ static_cast<std::uint32_t>(before) * 0x9e3779b1U ^ static_cast<std::uint32_t>(ports) * 0x85ebca77U;
  h = (h ^ h >> 16) * 0x85ebca6bU;
  h = (h ^ h >> 13) * 0xc2b2ae35U;
  return h ^ h >> 16;
}

/// Digests of the results of the look-up, to compare with other languages; `wanted` has the numbers of the operations,
/// such as "024". False when not everything could be written.
bool digests(std::size_t max_k, std::string_view wanted);

}  // namespace restrip::dump
