// Looks a rule up while the program is compiled. The look-ups are constexpr, need no mesh, and allocate nothing.
#include <cstdio>
#include <restrip/restrip.hpp>

int main() {
  // A vertex of four triangles t_0 … t_3, split so that the new triangle A comes before t_0 and D before t_2.
  constexpr restrip::SplitPosition at{.k = 4, .a = 2};

  // Before the split, t_0 … t_3 follow each other in a strip that enters and leaves by the ports of t_0 and t_3. Bit i
  // of the first mask is the dual edge between t_i and t_{i+1}, bit i of the second the port of t_i
  // (docs/reference/notation.md).
  constexpr restrip::Word loop = 0b0111;
  constexpr restrip::Word ports = 0b1001;

  constexpr restrip::Rule rule = restrip::split_rule(at, loop, ports);
  static_assert(rule.valid, "a stripification can have these colours");
  static_assert(rule.strips == 1, "every recolouring that is safe for every surrounding mesh adds a strip here");

  std::printf("inner edges after the split:");
  for (unsigned j = 0; j < at.k + 3; ++j) std::printf(" %s", (rule.colors >> j & 1U) != 0 ? "solid" : "dashed");
  std::printf("\nstrips: %+d\n", rule.strips);
}
