#pragma once
// Which worlds colourings fit. What a world closes depends on a colouring only by which solid ports the solid inner
// edges connect: triangles that are connected count as one node. So colourings that connect the same ports are the same
// graph, which is held against the worlds once, on whatever side and in whatever position it is met. The key of a
// configuration plays no part in it.

#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

#include "judge/worlds.hpp"

namespace restrip::verify {

/// The colourings with the same solid ports that fit the same worlds.
struct FitClass {
  Mask ports = 0;
  NumberSet worlds;  ///< by their numbers among all worlds of the same ports
  PortPairs joined;  ///< in the first of them
};

/// For all sides with so many ports, under one constraint. Not for several threads at once.
class FitTable {
 public:
  FitTable(Constraint constraint, unsigned ports);

  const Worlds& worlds() const { return worlds_; }
  const std::vector<FitClass>& classes() const { return classes_; }

  /// The class of the colouring with these solid inner edges and ports, and the pairs of ports that it joins.
  struct Found {
    std::uint32_t fit_class = 0;
    PortPairs joined;
  };
  Found class_of(const Side& side, const SolidGraph& inner, Mask ports);

  /// True when a colouring of the class `after`, which kept some of the ports of the class `before`, fits every world
  /// that those of `before` fit.
  bool sound(std::uint32_t before, std::uint32_t after);
  /// The first world that one of class `before` fits and one of class `after` does not; the number of worlds when there
  /// is none.
  std::size_t refuting_world(std::uint32_t before, std::uint32_t after);

 private:
  const std::vector<std::uint32_t>& restriction(Mask ports, Mask kept);

  Worlds worlds_;
  std::vector<FitClass> classes_;
  std::vector<std::map<NumberSet, std::uint32_t>> known_sets_;  ///< by ports
  std::unordered_map<std::uint64_t, Found> known_graphs_;
  std::map<std::array<Mask, 2>, std::vector<std::uint32_t>> restrictions_;
};

}  // namespace restrip::verify
