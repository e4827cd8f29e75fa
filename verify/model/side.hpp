#pragma once
// The triangles of a patch on one side of an operation, and the colours of their edges.

#include <array>
#include <string>
#include <vector>

#include "model/masks.hpp"

namespace restrip::verify {

inline constexpr unsigned most_triangles = 16;
inline constexpr unsigned most_ports = 12;   ///< 8 where a file writes a side out as a graph
inline constexpr unsigned most_colors = 27;  ///< inner edges and ports of a side together; 20 there

struct Side {
  unsigned triangles = 0;
  std::vector<std::array<unsigned, 2>> edges;
  std::vector<unsigned> owner_of_port;
  std::vector<std::string> names;  ///< of the triangles, as the description has them

  friend bool operator==(const Side&, const Side&) = default;

  unsigned inner_edges() const { return static_cast<unsigned>(edges.size()); }
  unsigned ports() const { return static_cast<unsigned>(owner_of_port.size()); }
  unsigned colors() const { return inner_edges() + ports(); }
};

/// Solid inner edges and solid ports; after the operation the ports are those that stay solid.
struct Colors {
  Mask inner = 0;
  Mask ports = 0;
  friend constexpr bool operator==(Colors, Colors) = default;
};

}  // namespace restrip::verify
