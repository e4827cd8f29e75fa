// What the search knows of an operation: its patch, the triangles that it touches, before and after it; and what makes
// one sound recolouring better than another. Every description (description.hpp) says one for each of its positions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace restrip::generator {

/// Colours of up to 32 dual edges, 1 = solid; or a set of edges, triangles or ports.
using Mask = std::uint32_t;

/// A dual edge inside the patch, by its two nodes.
struct Edge {
  unsigned u = 0;
  unsigned v = 0;
  friend bool operator==(const Edge&, const Edge&) = default;
};

/// The patch at one moment: nodes 0 … nodes - 1, inner edges in the order of their mask bits, and for each port its
/// node.
struct Side {
  unsigned nodes = 0;
  std::vector<Edge> edges;
  std::vector<unsigned> owner;

  [[nodiscard]] unsigned ports() const { return static_cast<unsigned>(owner.size()); }
  [[nodiscard]] Mask all_ports() const { return (Mask{1} << owner.size()) - 1; }
  friend bool operator==(const Side&, const Side&) = default;
};

/// What the solid edges must be: no cycle, and at most so many at a triangle. Two make strips, one a matching, three a
/// forest.
struct Constraint {
  unsigned most_edges = 2;
  friend bool operator==(const Constraint&, const Constraint&) = default;
};

/// Before and after share the ports; nothing else need correspond.
struct Patch {
  Side before;
  Side after;
};

/// docs/reference/operation-file.md says what each counts.
enum class Count { strips, isolated, given_up, kept, joined, solid, ends, ends_at_port, neighbouring_ends, squares };

struct Term {
  static constexpr Mask all = ~Mask{0};

  Count count = Count::strips;
  std::int64_t weight = 1;
  Mask of = all;  ///< edges or nodes of the side after, or ports; for the counts that choose among them
  friend bool operator==(const Term&, const Term&) = default;
};

/// A weighted sum.
using Criterion = std::vector<Term>;
/// Compared in turn (docs/reference/operation-file.md, "Cost").
using Preference = std::vector<Criterion>;

/// Fewest strips; then fewest isolated triangles, a port given up counting as one; then fewest ports given up.
[[nodiscard]] inline Preference fewest_strips() {
  return {{{Count::strips}}, {{Count::isolated}, {Count::given_up}}, {{Count::given_up}}};
}

/// No preference has more criteria.
inline constexpr std::size_t most_criteria = 8;

struct Operation {
  Patch patch;
  Constraint constraint;
  Mask may_give_up = 0;  ///< ports that may be solid before and dashed after
  Preference preference;
  Criterion tie_break;       ///< among recolourings that `preference` finds equal; symmetries need not respect it
  bool turns_first = false;  ///< of two symmetries that serve alike, one that turns the ports is taken before another
};

}  // namespace restrip::generator
