// Lines of a dump, fast: millions of them go through one buffer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

#include "restrip/rules/bits.hpp"

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

/// The trees of linked_split_rule() and linked_collapse_rule() (docs/reference/verifiers.md, "Dump of linked rules").
void linked_rules(Output& out, std::size_t max_k);

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
