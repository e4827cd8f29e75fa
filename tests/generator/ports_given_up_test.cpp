// Claim: the rules of splits and collapses are best only among the recolourings that keep their ports
// (docs/explanation/theory.md, "Ports given up"). This is the example of that section, a split with k = 5 and a = 2,
// solved by the generator's search and by trying all recolourings on the ring with chord, numbered as in
// docs/reference/notation.md, in every outside.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "operations/description_file.hpp"
#include "solve/section.hpp"

namespace restrip::generator {
namespace {

constexpr unsigned k = 5;
constexpr Mask ports = 0x15;  // 0, 2 and 4
constexpr Mask rule = 0x2d;
constexpr Mask bolder = 0xf6;
constexpr Mask bolder_keeps = 0x5;

using Ends = std::pair<unsigned, unsigned>;
constexpr unsigned nodes = k + 2;

/// A and D are nodes k and k + 1; f_7 is the chord.
constexpr std::array<Ends, k + 3> edges_after{
    {{k, 0}, {0, 1}, {1, k + 1}, {k + 1, 2}, {2, 3}, {3, 4}, {4, k}, {k, k + 1}}};
/// e_0 and e_1 are solid before the split, so that ports 0 and 2 are joined.
constexpr std::array<Ends, 2> solid_before{{{0, 1}, {1, 2}}};

/// Solid edges that are added one by one.
class SolidGraph {
 public:
  SolidGraph() { std::iota(root_.begin(), root_.end(), 0U); }
  void add(Ends edge) {
    valid_ =
        valid_ && ++degree_[edge.first] <= 2 && ++degree_[edge.second] <= 2 && find(edge.first) != find(edge.second);
    root_[find(edge.first)] = find(edge.second);
  }
  void add_port(unsigned port) { valid_ = valid_ && ++degree_[port] <= 2; }
  /// A strip outside leads from one solid port to another.
  void join(Ends outside) {
    valid_ = valid_ && find(outside.first) != find(outside.second);
    root_[find(outside.first)] = find(outside.second);
  }
  [[nodiscard]] bool valid() const { return valid_; }

 private:
  unsigned find(unsigned node) const { return root_[node] == node ? node : find(root_[node]); }
  std::array<unsigned, nodes> root_{};
  std::array<unsigned, nodes> degree_{};
  bool valid_ = true;
};

/// All joins by strips outside that close no cycle before the split: two of the three ports at most.
std::vector<std::vector<Ends>> outsides() {
  std::vector<std::vector<Ends>> found{{}};
  for (const Ends& pair : {Ends{0, 2}, Ends{0, 4}, Ends{2, 4}}) {
    SolidGraph before;
    for (const Ends& edge : solid_before) before.add(edge);
    for (const unsigned port : {0U, 2U, 4U}) before.add_port(port);
    before.join(pair);
    if (before.valid()) found.push_back({pair});
  }
  return found;
}

bool is_sound(Mask recoloring, Mask kept) {
  for (const std::vector<Ends>& outside : outsides()) {
    SolidGraph after;
    for (unsigned e = 0; e < edges_after.size(); ++e)
      if ((recoloring >> e & 1U) != 0) after.add(edges_after.at(e));
    for (unsigned port = 0; port < k; ++port)
      if ((kept >> port & 1U) != 0) after.add_port(port);
    for (const auto& [one, other] : outside)
      if ((kept >> one & 1U) != 0 && (kept >> other & 1U) != 0) after.join({one, other});
    if (!after.valid()) return false;
  }
  return true;
}

int solid(Mask recoloring, Mask kept) { return std::popcount(recoloring) + std::popcount(kept); }

/// The most solid edges of a sound recolouring that keeps ports for which `may` is true.
template <class May>
int most_solid(May may) {
  int most = -1;
  for (Mask kept = 0; kept < 1U << k; ++kept)
    for (Mask recoloring = 0; (kept & ~ports) == 0 && may(kept) && recoloring < 1U << edges_after.size(); ++recoloring)
      if (is_sound(recoloring, kept)) most = std::max(most, solid(recoloring, kept));
  return most;
}

TEST(PortsGivenUp, TheRuleIsBestIfAllAreKept) {
  EXPECT_EQ(outsides().size(), 3U);  // nothing, ports 0 and 4, ports 2 and 4; 0 and 2 would close a cycle
  EXPECT_TRUE(is_sound(rule, ports));
  EXPECT_EQ(solid(rule, ports), 7);
  EXPECT_EQ(most_solid([](Mask kept) { return kept == ports; }), 7);
}

TEST(PortsGivenUp, OneGivenUpSavesAStrip) {
  EXPECT_TRUE(is_sound(bolder, bolder_keeps));
  EXPECT_EQ(solid(bolder, bolder_keeps), 8);
  EXPECT_EQ(most_solid([](Mask) { return true; }), 8);
  EXPECT_FALSE(is_sound(bolder, ports));  // the port that it gives up is in its way
}

TEST(PortsGivenUp, TheGeneratorFindsBoth) {
  const Position position{&family_named("split"), k, 2, 0};
  PortPairs joined;
  joined.add(0, 2);
  std::size_t compared = 0;
  for (const Section& section : solved("split", k, 1)) {
    if (section.position != position) continue;
    EXPECT_EQ(row_of(section, ports, joined).recoloring, rule);
    ++compared;
  }
  EXPECT_EQ(compared, 1U);

  std::vector<Description> file = parse_descriptions("file.json", operation_file_text(position));
  const auto row = [&] {
    const Section own = solve(patches_of(file, k).at(0));
    return row_of(own, ports, joined);
  };
  const Row keeping = row();
  EXPECT_EQ(keeping.recoloring, rule);
  EXPECT_EQ(keeping.kept, ports);

  file.at(0).gives_all_up = true;
  file.at(0).preference.resize(1);  // only strips
  const Row giving = row();
  EXPECT_EQ(solid(giving.recoloring, giving.kept), 8);
  EXPECT_TRUE(is_sound(giving.recoloring, giving.kept));
}

}  // namespace
}  // namespace restrip::generator
