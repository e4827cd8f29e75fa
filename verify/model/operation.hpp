// One operation at one position: the patch before and after it, the kept ports, the cost
// (docs/reference/operation-file.md).
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/formula.hpp"
#include "model/side.hpp"

namespace restrip::verify {

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
unsigned most_solid(Constraint constraint);

/// Whether a recolouring may keep exactly the solid ports `kept`.
inline bool admissible(const Operation& operation, Mask ports, Mask kept) {
  return is_subset(kept, ports) && is_subset(ports & ~kept, operation.may_give_up);
}

/// Whether rules may have reasons: for strips, if the cost is fewest strips, then fewest isolated triangles
/// and ports given up, then fewest ports given up.
bool may_have_reasons(const Operation& operation);

/// The cost of an operation whose description has none.
std::vector<Criterion> default_cost(Constraint constraint);

/// Up to this number of ports, and for every matching, all recolourings are searched in every world. Beyond it, rules
/// are proved by their reasons, and linked rules by the checks of their lists: strips of 8 ports have 764 worlds, of 12
/// ports 140,152.
inline constexpr unsigned most_searched_ports = 8;
inline bool searched(const Operation& operation) {
  return operation.ports() <= most_searched_ports || operation.constraint == Constraint::matching;
}

}  // namespace restrip::verify
