// One operation at one position: the patch before and after it, the kept ports, the cost
// (docs/reference/operation-file.md).
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/formula.hpp"
#include "model/masks.hpp"

namespace restrip::verify {

// The triangles of a patch on one side of an operation, and the colours of their edges.

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

inline constexpr unsigned most_criteria = 8;
inline constexpr unsigned most_terms = 64;
inline constexpr std::int64_t largest_weight = 1'000'000;

enum class Constraint { strips, matching };
inline constexpr std::array<std::string_view, 2> constraint_names = {"strips", "matching"};

enum class Count { strips, isolated, given_up, kept, joined, solid, ends, ends_at_port, neighbouring_ends, squares };
inline constexpr std::array<std::string_view, 10> count_names = {
    "strips", "isolated",     "given_up",          "kept",   "joined", "solid",
    "ends",   "ends_at_port", "neighbouring_ends", "squares"};

struct Term {
  Count count = Count::strips;
  std::int64_t weight = 1;
  Mask among = 0;  ///< the counted members, if the count has a choice
  friend auto operator<=>(const Term&, const Term&) = default;
};

/// What a count may be restricted to; by default it counts all of it.
enum class Among { nothing, edges, triangles, ports };
inline constexpr std::array<std::string_view, 4> among_names = {"", "edges", "triangles", "ports"};
constexpr Among among_of(Count count) {
  switch (count) {
    case Count::solid:
      return Among::edges;
    case Count::ends:
    case Count::ends_at_port:
      return Among::triangles;
    case Count::kept:
      return Among::ports;
    default:
      return Among::nothing;
  }
}

using Criterion = std::vector<Term>;

struct Operation {
  std::string family;    ///< the name of the description: "open-collapse"
  std::string position;  ///< "k 8 gaps 2 5"; empty if there is only one
  Numbers numbers;       ///< 8, 2, 5
  Constraint constraint = Constraint::strips;
  Side before;
  Side after;
  Mask may_give_up = 0;
  /// The number of vertex names on both sides together; 0 for the fans of tables/families.json.
  unsigned vertices = 0;
  std::vector<PlacedTriangle> placed_before;  ///< its triangles in the order of the file
  std::vector<PlacedTriangle> placed_after;
  std::vector<Criterion> cost;       ///< includes the default, if none is given
  std::optional<int> most_strips;    ///< claim of the description: no rule costs more
  std::optional<int> most_isolated;  ///< the same for isolated triangles
  std::optional<int> most_indices;   ///< claim: no operation adds more to 3 strips + swaps (judge/index_cost.hpp)

  bool is_fan() const { return vertices == 0; }
  unsigned ports() const { return before.ports(); }
  std::string name() const { return position.empty() ? family : family + ' ' + position; }
};

/// The most solid edges that a triangle may have.
constexpr unsigned most_solid(Constraint constraint) { return constraint == Constraint::strips ? 2 : 1; }

/// Whether a recolouring may keep exactly the solid ports `kept`.
inline bool admissible(const Operation& operation, Mask ports, Mask kept) {
  return is_subset(kept, ports) && is_subset(ports & ~kept, operation.may_give_up);
}

/// The cost of an operation whose description has none.
inline std::vector<Criterion> default_cost(Constraint constraint) {
  std::vector<Criterion> cost = {{{Count::strips}}, {{Count::isolated}, {Count::given_up}}, {{Count::given_up}}};
  if (constraint == Constraint::matching) cost.erase(cost.begin());
  return cost;
}

/// Whether rules may have reasons: for strips, if the cost is fewest strips, then fewest isolated triangles
/// and ports given up, then fewest ports given up.
inline bool may_have_reasons(const Operation& operation) {
  const std::vector<Criterion> first = default_cost(Constraint::strips);
  return operation.constraint != Constraint::matching && operation.cost.size() >= first.size() &&
         std::equal(first.begin(), first.end(), operation.cost.begin());
}

/// Up to this number of ports, and for every matching, all recolourings are searched in every world. Beyond it, rules
/// are proved by their reasons, and linked rules by the checks of their lists: strips of 8 ports have 764 worlds, of 12
/// ports 140,152.
inline constexpr unsigned most_searched_ports = 8;
inline bool searched(const Operation& operation) {
  return operation.ports() <= most_searched_ports || operation.constraint == Constraint::matching;
}

}  // namespace restrip::verify
