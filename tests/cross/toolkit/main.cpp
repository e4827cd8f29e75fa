// The rules of tables made in this build: valid, and the change of strips is as stated.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <restrip/rules/rules.hpp>

// The rules come from the tables of this build.
static_assert(restrip::table_max_k == MAX_K);
static_assert(restrip::split_rule({MAX_K, MAX_K / 2}, 0, 0).valid);

int main() {
  std::uint64_t random = 1;
  std::size_t valid = 0;
  for (std::size_t a = 1; a < MAX_K; ++a)
    for (int n = 0; n < 20000; ++n) {
      random = random * 6364136223846793005U + 1442695040888963407U;
      const restrip::Word loop = random >> 20 & ((restrip::Word{1} << MAX_K) - 1);
      const restrip::Word ports = random >> 40 & ((restrip::Word{1} << MAX_K) - 1);
      const restrip::Patch before = restrip::closed_fan(MAX_K);
      const restrip::Patch after = restrip::ring_with_chord(MAX_K, a);
      const restrip::Rule rule = restrip::split_rule({MAX_K, a}, loop, ports);
      if (rule.valid != before.valid(loop, ports)) return EXIT_FAILURE;
      if (!rule.valid) continue;
      ++valid;
      if (!after.valid(rule.colors, ports)) return EXIT_FAILURE;
      if (rule.strips != 2 - restrip::count_bits(rule.colors) + restrip::count_bits(loop)) return EXIT_FAILURE;
    }
  std::printf("%zu rules\n", valid);
  return valid > 100 ? EXIT_SUCCESS : EXIT_FAILURE;
}
