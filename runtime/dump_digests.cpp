// The results of the compiled look-up, as digests in the format of the programs for other languages
// (docs/how-to/other-languages.md, "Check a look-up"): a line for each operation, 0 to 6, and position, "operation k p
// q digest". The digest is the sum of mix() over all colours before and all ports, valid or not, modulo 2^32, so that
// programs that answer in parallel can add it up in any order.
#include <cstdint>
#include <cstdio>

#include "dump_output.hpp"
#include "restrip/rules/rules.hpp"

namespace restrip::dump {
namespace {

/// One position; at(before, ports) is its look-up.
template <class At>
void line(std::string_view wanted, unsigned operation, std::size_t k, std::size_t p, std::size_t q,
          std::size_t before_bits, std::size_t port_bits, At&& at) {
  if (wanted.find(static_cast<char>('0' + operation)) == std::string_view::npos) return;
  std::uint32_t digest = 0;
  for (Word before = 0; before < bit(before_bits); ++before)
    for (Word ports = 0; ports < bit(port_bits); ++ports) {
      const Rule rule = at(before, ports);
      const std::uint32_t strips = static_cast<std::uint32_t>(rule.strips + 8) << 16;
      const std::uint32_t packed = 0x80000000U | strips | static_cast<std::uint32_t>(rule.colors);
      digest += mix(before, ports, rule.valid ? packed : 0);
    }
  std::printf("%u %zu %zu %zu %08x\n", operation, k, p, q, digest);
}

}  // namespace

bool digests(std::size_t max_k, std::string_view wanted) {
  for (unsigned collapse = 0; collapse < 2; ++collapse)
    for (std::size_t k = 3; k <= max_k; ++k)
      for (std::size_t a = 1; a < k; ++a)
        line(wanted, collapse, k, a, 0, collapse != 0 ? k + 3 : k, k, [&](Word before, Word ports) {
          return collapse != 0 ? collapse_rule({k, a}, before, ports) : split_rule({k, a}, before, ports);
        });
  for (unsigned collapse = 0; collapse < 2; ++collapse)
    for (std::size_t k = 1; k <= max_k; ++k)
      for (std::size_t i = 0; i < k; ++i)
        for (std::size_t j = i + 1; j <= k; ++j)
          line(wanted, 2 + collapse, k, i, j, collapse != 0 ? k + 2 : k - 1, k, [&](Word before, Word ports) {
            return collapse != 0 ? open_collapse_rule({k, i, j}, before, ports)
                                 : open_split_rule({k, i, j}, before, ports);
          });
  for (unsigned collapse = 0; collapse < 2; ++collapse)
    for (std::size_t k = 1; k <= max_k; ++k)
      for (std::size_t i = 0; i <= k; ++i)
        line(wanted, 4 + collapse, k, i, 0, collapse != 0 ? k : k - 1, k, [&](Word before, Word ports) {
          return collapse != 0 ? boundary_collapse_rule({k, i}, before, ports)
                               : boundary_split_rule({k, i}, before, ports);
        });
  line(wanted, 6, 0, 0, 0, 1, 4, [](Word before, Word ports) {
    const FlipRule rule = flip_rule(before != 0, static_cast<unsigned>(ports));
    return Rule{static_cast<Word>(rule.inner) << 4 | rule.ports, rule.strips, rule.valid};
  });
  // Positions outside the tables: the other languages answer that the rule does not exist.
  std::printf("rules outside the tables: 0\n");
  return std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
}

}  // namespace restrip::dump
