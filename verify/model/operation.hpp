#pragma once
// One operation at one position: the patch before and after it, what is kept, what is best
// (docs/reference/operation-file.md).

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

enum class Constraint { strips, matching, forest };
inline constexpr std::array<std::string_view, 3> constraint_names = {"strips", "matching", "forest"};

enum class Count { strips, isolated, given_up, kept, joined, solid, ends, ends_at_port, neighbouring_ends, squares };
inline constexpr std::array<std::string_view, 10> count_names = {
    "strips", "isolated",     "given_up",          "kept",   "joined", "solid",
    "ends",   "ends_at_port", "neighbouring_ends", "squares"};

struct Term {
  Count count = Count::strips;
  std::int64_t weight = 1;
  Mask among = 0;  ///< what is counted, if the count has a choice
  friend auto operator<=>(const Term&, const Term&) = default;
};

/// What a count may be restricted to, and what it counts all of by default.
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
  std::string position;  ///< "k 8 gaps 2 5"; empty where there is but one
  Numbers numbers;       ///< 8, 2, 5
  Constraint constraint = Constraint::strips;
  Side before;
  Side after;
  Mask may_give_up = 0;
  /// Names of vertices on both sides together, where it is given by its triangles and was found to be an operation on a
  /// mesh; otherwise 0.
  unsigned vertices = 0;
  std::vector<PlacedTriangle> placed_before;  ///< its triangles in the order of the file
  std::vector<PlacedTriangle> placed_after;
  std::vector<Criterion> cost;       ///< the default is written out
  std::optional<int> most_strips;    ///< as the description claims: no rule costs more
  std::optional<int> most_isolated;  ///< the same of isolated triangles
  std::optional<int> most_indices;   ///< no operation adds more to 3 strips + swaps (judge/index_cost.hpp)

  bool on_a_mesh() const { return vertices != 0; }
  unsigned ports() const { return before.ports(); }
  std::string name() const { return position.empty() ? family : family + ' ' + position; }
};

/// The most solid edges that a triangle may have.
unsigned most_solid(Constraint constraint);

/// Whether a recolouring may keep just these of the solid ports.
inline bool admissible(const Operation& operation, Mask ports, Mask kept) {
  return is_subset(kept, ports) && is_subset(ports & ~kept, operation.may_give_up);
}

/// Whether rules may have reasons: strips or forests, where fewest strips come first, then fewest isolated triangles
/// and ports given up, then fewest ports given up.
bool may_have_reasons(const Operation& operation);

/// The cost of an operation whose description has none.
std::vector<Criterion> default_cost(Constraint constraint);

/// Up to so many ports all recolourings are searched. Beyond, rules are proved by their reasons and linked rules by
/// what is checked of their lists.
inline constexpr unsigned most_searched_ports = 8;
inline bool searched(const Operation& operation) { return operation.ports() <= most_searched_ports; }

}  // namespace restrip::verify
