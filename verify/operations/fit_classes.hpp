#pragma once
// All colourings of one side, grouped by the worlds that they fit. Every colouring is held against every world of its
// solid ports, as a graph; the key of a configuration plays no part in it.

#include <cstdint>
#include <vector>

#include "worlds.hpp"

namespace restrip::verify::operations {

/// The valid colourings with the same solid ports that fit the same worlds.
struct FitClass {
  Colors first;      ///< the first of them
  NumberSet worlds;  ///< by their numbers among all worlds of the same ports
  PortPairs joined;  ///< in the first of them
  std::uint64_t colorings = 0;
};

struct FitClasses {
  static constexpr std::uint32_t not_valid = 0xffffffff;

  FitClasses(const Side& side, unsigned most_solid, const Worlds& worlds);

  std::uint32_t class_of(Colors colors) const {
    return class_of_coloring[concatenated(colors.inner, colors.ports, ports)];
  }

  unsigned ports = 0;
  std::vector<FitClass> classes;
  std::vector<std::vector<std::uint32_t>> of_ports;  ///< the classes of each set of solid ports
  std::vector<std::uint32_t> class_of_coloring;      ///< by concatenated(inner, ports)
  std::uint64_t tested = 0;                          ///< pairs of a valid colouring and a world
};

}  // namespace restrip::verify::operations
