#pragma once
// An operation as its file describes it (docs/operation-file.md), and the reader of such files.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "masks.hpp"

namespace restrip::verify::operations {

inline constexpr unsigned most_triangles = 16;
inline constexpr unsigned most_ports = 8;
inline constexpr unsigned most_colors = 20;  ///< inner edges and ports of a side together
inline constexpr unsigned most_criteria = 8;
inline constexpr unsigned most_terms = 64;
inline constexpr std::int64_t largest_weight = 1'000'000;
inline constexpr unsigned longest_name = 60;

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

/// The triangles of a patch on one side of the operation.
struct Side {
  unsigned triangles = 0;
  std::vector<std::array<unsigned, 2>> edges;
  std::vector<unsigned> owner_of_port;

  unsigned inner_edges() const { return static_cast<unsigned>(edges.size()); }
  unsigned ports() const { return static_cast<unsigned>(owner_of_port.size()); }
};

struct OperationFile {
  std::string name;
  std::string about;
  Constraint constraint = Constraint::strips;
  Side before;
  Side after;
  Mask may_give_up = 0;
  std::vector<Criterion> cost;  ///< the default is written out
  bool on_a_mesh = false;       ///< given by its triangles, and found to be an operation on a mesh

  unsigned ports() const { return before.ports(); }
  /// The most solid edges that a triangle may have.
  unsigned most_solid() const;
};

/// Whether rules of the operation may have reasons: strips or forests, where fewest strips come first, then fewest
/// isolated triangles and ports given up, then fewest ports given up.
bool may_have_reasons(const OperationFile& operation);

/// InputError "file:line:column: member: expected …" when anything is not as docs/operation-file.md says.
OperationFile parse_operation_file(const std::string& file, std::string_view text);

}  // namespace restrip::verify::operations
