// The triangles of a patch on one side of an operation, and the colours of their edges.
#pragma once

#include <array>
#include <compare>
#include <optional>
#include <string>
#include <vector>

#include "model/masks.hpp"

namespace restrip::verify {

inline constexpr unsigned most_triangles = 16;
inline constexpr unsigned most_ports = 12;
inline constexpr unsigned most_colors = 27;  ///< inner edges and ports of a side together, in a shipped family
inline constexpr unsigned most_colors_of_a_user = 22;  ///< in a user's file

inline constexpr std::size_t longest_word = 20;  ///< names of vertices, triangles and numbers

/// What lies at a side of a triangle: the number of an inner edge, or of a port plus this constant, or the boundary of
/// the mesh. restrip/tables/operation_format.hpp has the same numbers.
inline constexpr unsigned first_port_side = 64;
inline constexpr unsigned boundary_side = 255;

struct Side {
  unsigned triangles = 0;
  std::vector<std::array<unsigned, 2>> edges;
  std::vector<unsigned> owner_of_port;
  std::vector<std::string> names;       ///< of the triangles, from the description: "t0", or "abm" by their vertices
  std::vector<std::string> port_names;  ///< "a b" by the vertices; empty for fans, whose port i is at t_i
  /// What lies at the three sides of each triangle, counter-clockwise: a strip turns at a triangle, and which way
  /// depends on this order.
  std::vector<std::array<unsigned, 3>> around;

  /// Whatever the names.
  friend bool operator==(const Side& one, const Side& other) {
    return one.triangles == other.triangles && one.edges == other.edges && one.owner_of_port == other.owner_of_port &&
           one.around == other.around;
  }

  unsigned inner_edges() const { return static_cast<unsigned>(edges.size()); }
  unsigned ports() const { return static_cast<unsigned>(owner_of_port.size()); }
  unsigned colors() const { return inner_edges() + ports(); }
  std::optional<unsigned> edge_between(unsigned one, unsigned other) const {
    for (unsigned edge = 0; edge < inner_edges(); ++edge)
      if (edges[edge] == std::array{one, other} || edges[edge] == std::array{other, one}) return edge;
    return {};
  }
};

/// A triangle as its file names it; side s runs from corner s to the next one. Vertices are numbered in order of
/// appearance, before the operation first.
struct PlacedTriangle {
  std::array<unsigned, 3> vertex{};
  std::array<unsigned, 3> side{};
  friend bool operator==(const PlacedTriangle&, const PlacedTriangle&) = default;
};

/// Solid inner edges and solid ports; after the operation, the ports that stay solid.
struct Colors {
  Mask inner = 0;
  Mask ports = 0;
  friend constexpr auto operator<=>(Colors, Colors) = default;
};

}  // namespace restrip::verify
