// The results of the compiled look-up, as digests in the format of the programs for other languages
// (docs/how-to/other-languages.md, "Check a look-up"): a line for each operation, 0 to 6, and position, "operation k p
// q digest". The digest is the sum of mix() over all colours before and all ports, valid or not, modulo 2^32, so that
// programs that answer in parallel can add it up in any order.
#include <cstdint>
#include <cstdio>

#include "dump_output.hpp"

namespace restrip::dump {

bool digests(std::size_t max_k, std::string_view wanted) {
  const auto line = [wanted](unsigned operation, std::size_t k, std::size_t p, std::size_t q, std::size_t before_bits,
                             std::size_t port_bits, auto&& rule_of) {
    if (wanted.find(static_cast<char>('0' + operation)) == std::string_view::npos) return;
    std::uint32_t digest = 0;
    for (Word before = 0; before < bit(before_bits); ++before)
      for (Word ports = 0; ports < bit(port_bits); ++ports) {
        const Rule rule = rule_of(before, ports);
        const std::uint32_t strips = static_cast<std::uint32_t>(rule.strips + 8) << 16;
        const std::uint32_t packed = 0x80000000U | strips | static_cast<std::uint32_t>(rule.colors);
        digest += mix(before, ports, rule.valid ? packed : 0);
      }
    std::printf("%u %zu %zu %zu %08x\n", operation, k, p, q, digest);
  };
  for_each_position(max_k, [&](unsigned operation, std::size_t k, std::size_t p, std::size_t q, std::size_t bits,
                               auto&& rule_of) { line(operation, k, p, q, bits, k, rule_of); });
  line(6, 0, 0, 0, 1, 4, [](Word before, Word ports) {
    const FlipRule rule = flip_rule(before != 0, static_cast<unsigned>(ports));
    return Rule{static_cast<Word>(rule.inner) << 4 | rule.ports, rule.strips, rule.valid};
  });
  // Positions outside the tables: the other languages answer that the rule does not exist.
  std::printf("rules outside the tables: 0\n");
  return std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
}

}  // namespace restrip::dump
