// What the C++ look-up answers, as digests in the format of the drivers beside this file: a line for each operation and
// position, "operation k p q digest", for all operations, 0 to 6, or those in a second argument such as 024. The digest
// is the sum of mix() over all colours before and all ports, valid or not, modulo 2^32, so that programs that answer in
// parallel can add it up in any order.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "restrip/rules/rules.hpp"

namespace {

const char* wanted = "0123456";  // operations

using restrip::Word;

/// 0 for colours that are not valid.
std::uint32_t packed(bool valid, Word colors, int strips) {
  return valid ? 0x80000000U | static_cast<std::uint32_t>(strips + 8) << 16 | static_cast<std::uint32_t>(colors) : 0;
}

std::uint32_t packed(const restrip::Rule& rule) { return packed(rule.valid, rule.colors, rule.strips); }

std::uint32_t mix(Word before, Word ports, std::uint32_t answer) {
  std::uint32_t h =
      answer ^ static_cast<std::uint32_t>(before) * 0x9e3779b1U ^ static_cast<std::uint32_t>(ports) * 0x85ebca77U;
  h = (h ^ h >> 16) * 0x85ebca6bU;
  h = (h ^ h >> 13) * 0xc2b2ae35U;
  return h ^ h >> 16;
}

/// One position; at(before, ports) is its look-up.
template <class At>
void line(unsigned operation, std::size_t k, std::size_t p, std::size_t q, std::size_t before_bits,
          std::size_t port_bits, At&& at) {
  if (std::strchr(wanted, static_cast<char>('0' + operation)) == nullptr) return;
  std::uint32_t digest = 0;
  for (Word before = 0; before < restrip::bit(before_bits); ++before)
    for (Word ports = 0; ports < restrip::bit(port_bits); ++ports) digest += mix(before, ports, at(before, ports));
  std::printf("%u %zu %zu %zu %08x\n", operation, k, p, q, digest);
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t max_k = argc == 2 || argc == 3 ? std::strtoul(argv[1], nullptr, 10) : 0;
  if (max_k < 3 || max_k > restrip::table_max_k) {
    std::fprintf(stderr, "usage: answers K [OPERATIONS], 3 <= K <= %u\n", static_cast<unsigned>(restrip::table_max_k));
    return 2;
  }
  if (argc == 3) wanted = argv[2];
  for (unsigned collapse = 0; collapse < 2; ++collapse)
    for (std::size_t k = 3; k <= max_k; ++k)
      for (std::size_t a = 1; a < k; ++a)
        line(collapse, k, a, 0, collapse != 0 ? k + 3 : k, k, [&](Word before, Word ports) {
          return packed(collapse != 0 ? restrip::collapse_rule({k, a}, before, ports)
                                      : restrip::split_rule({k, a}, before, ports));
        });
  for (unsigned collapse = 0; collapse < 2; ++collapse)
    for (std::size_t k = 1; k <= max_k; ++k)
      for (std::size_t i = 0; i < k; ++i)
        for (std::size_t j = i + 1; j <= k; ++j)
          line(2 + collapse, k, i, j, collapse != 0 ? k + 2 : k - 1, k, [&](Word before, Word ports) {
            return packed(collapse != 0 ? restrip::open_collapse_rule({k, i, j}, before, ports)
                                        : restrip::open_split_rule({k, i, j}, before, ports));
          });
  for (unsigned collapse = 0; collapse < 2; ++collapse)
    for (std::size_t k = 1; k <= max_k; ++k)
      for (std::size_t i = 0; i <= k; ++i)
        line(4 + collapse, k, i, 0, collapse != 0 ? k : k - 1, k, [&](Word before, Word ports) {
          return packed(collapse != 0 ? restrip::boundary_collapse_rule({k, i}, before, ports)
                                      : restrip::boundary_split_rule({k, i}, before, ports));
        });
  line(6, 0, 0, 0, 1, 4, [](Word before, Word ports) {
    const restrip::FlipRule rule = restrip::flip_rule(before != 0, static_cast<unsigned>(ports));
    return packed(rule.valid, static_cast<Word>(rule.inner) << 4 | rule.ports, rule.strips);
  });
  // Positions that no table holds: the other languages answer that there is no rule.
  std::printf("rules outside the tables: 0\n");
  return 0;
}
