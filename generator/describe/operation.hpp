// An operation as the search sees it: its patch, which contains the touched triangles, before and after it, and the
// order of preference among sound recolourings. Every description (description.hpp) has one for each of its positions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
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

/// One side of a patch: nodes 0 … nodes - 1, inner edges in the order of their mask bits, and the node of each port.
struct Side {
  unsigned nodes = 0;
  std::vector<Edge> edges;
  std::vector<unsigned> owner;

  [[nodiscard]] unsigned ports() const { return static_cast<unsigned>(owner.size()); }
  [[nodiscard]] Mask all_ports() const { return (Mask{1} << owner.size()) - 1; }
  friend bool operator==(const Side&, const Side&) = default;
};

/// The condition on solid edges: no cycle, and a maximum at each triangle. Two make strips, one a matching.
struct Constraint {
  unsigned most_edges = 2;
  friend bool operator==(const Constraint&, const Constraint&) = default;
};

/// A triangle in traversal order from the first: every other one is reached across a side of an earlier one, which is
/// its side 0.
struct SurfaceTriangle {
  unsigned from = 0;                   ///< the triangle from which it is entered, by index in the list
  unsigned from_side = 0;              ///< and the side of that triangle
  std::array<unsigned, 3> vertex{};    ///< its corners; side s runs from corner s to the next one
  std::array<std::uint8_t, 3> side{};  ///< an inner edge, port_side plus a port, or boundary_side
  static constexpr std::uint8_t port_side = 64;
  static constexpr std::uint8_t boundary_side = 255;
};

/// The triangles in a header, for code that changes a mesh; empty for the fans of tables/families.json.
struct Surface {
  std::vector<SurfaceTriangle> before;
  std::vector<SurfaceTriangle> after;
  unsigned vertices = 0;  ///< of both sides, numbered in order of appearance in the file
};

/// Before and after share the ports; nothing else need correspond.
struct Patch {
  Side before;
  Side after;
  Surface surface;
};

/// docs/reference/operation-file.md defines each.
enum class Count { strips, isolated, given_up, kept, joined, solid, ends, ends_at_port, neighbouring_ends, squares };

struct Term {
  static constexpr Mask all = ~Mask{0};

  Count count = Count::strips;
  std::int64_t weight = 1;
  Mask of = all;  ///< edges or nodes of the side after, or ports; for counts that choose among them
  friend bool operator==(const Term&, const Term&) = default;
};

/// A weighted sum.
using Criterion = std::vector<Term>;
/// Compared lexicographically (docs/reference/operation-file.md, "Cost").
using Preference = std::vector<Criterion>;

/// Fewest strips; then fewest isolated triangles, where a port given up counts as one; then fewest ports given up.
[[nodiscard]] inline Preference fewest_strips() {
  return {{{Count::strips}}, {{Count::isolated}, {Count::given_up}}, {{Count::given_up}}};
}

/// The limit for a preference.
inline constexpr std::size_t most_criteria = 8;

struct Operation {
  Patch patch;
  Constraint constraint;
  Mask may_give_up = 0;  ///< ports that may be solid before and dashed after
  Preference preference;
  Criterion tie_break;       ///< among equally preferred recolourings; symmetries need not respect it
  bool turns_first = false;  ///< if two symmetries serve equally, the one that turns the ports is chosen
};

// The words of operation files.

/// By the maximum of solid edges at a triangle, from one.
inline constexpr std::array<std::string_view, 2> constraint_words{"matching", "strips"};

/// Every count, in the order of Count.
inline constexpr std::array<std::string_view, 10> count_words{
    "strips", "isolated",     "given_up",          "kept",   "joined", "solid",
    "ends",   "ends_at_port", "neighbouring_ends", "squares"};

/// What each count can choose among: "edge", "triangle" or "port"; the member's name has an s.
inline constexpr std::array<std::string_view, 10> count_among{"",     "",         "",         "port", "",
                                                              "edge", "triangle", "triangle", "",     ""};

/// The number of members to choose among.
[[nodiscard]] inline std::size_t how_many(std::string_view among, const Side& after) {
  return among == "edge" ? after.edges.size() : among == "triangle" ? after.nodes : among == "port" ? after.ports() : 0;
}

}  // namespace restrip::generator
