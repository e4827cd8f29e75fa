// Descriptions of operations: what docs/reference/operation-file.md says of them. A description with numbers is a
// family, one operation for each position; the others are single ones, with one position. The shipped families are
// those of tables/families.json; no other code knows one by its name.
#pragma once

#include <array>
#include <compare>
#include <string>
#include <variant>
#include <vector>

#include "operations/formula.hpp"
#include "operations/operation.hpp"
#include "operations/triangles.hpp"

namespace restrip::generator {

/// Triangles in the order of the ring or path that they form.
struct Chain {
  bool ring = false;
  std::vector<Stretch> elements;
};

/// A side for all positions. Inner edges: along the chains, then the chords.
struct SidePattern {
  std::vector<Chain> chains;
  std::vector<std::array<Stretch, 2>> chords;
  std::vector<Stretch> ports;  ///< who owns them; where none exist, each triangle with an index has one
};

/// A side in one of the forms that a file can give it in: as a graph, as the chains of a pattern, or by its triangles.
using SideForm = std::variant<Side, SidePattern, TrianglePatterns>;

struct Description {
  std::string name;  ///< "open-collapse"
  std::string about;
  std::string certificate;  ///< whose rules it shares: "fan-collapse"
  Constraint constraint;
  Preference preference;
  bool own_cost = false;             ///< `preference` is not the usual one
  bool gives_all_up = false;         ///< all ports may be given up, or
  Mask may_give_up = 0;              ///< just these
  std::vector<std::string> numbers;  ///< of its positions: "k", "i", "j"; none when there is only one position
  std::string range;                 ///< `where`, for people
  Conditions where;                  ///< which positions there are
  Conditions listed;                 ///< and which of them are not images of others
  std::string place;                 ///< "k {k} gaps {i} {j}", as dumps write a position; empty where there is but one
  std::string section;               ///< as certificates write it: "k {k}", where it leaves some numbers out
  bool linked = false;               ///< there are linked rules as well
  SideForm before;
  SideForm after;
  std::vector<StretchPattern> boundary;  ///< of triangles
  std::string in_file;                   ///< where it stands, as errors begin: "f.json:3: operations[0]: "
  std::string before_in_file;            ///< the same of its sides, and of what of them lies on the boundary
  std::string after_in_file;
  std::string boundary_in_file;

  [[nodiscard]] bool is_pattern() const { return std::holds_alternative<SidePattern>(after); }
  /// Nothing says whether it is an operation on a mesh.
  [[nodiscard]] bool is_graph_only() const { return !std::holds_alternative<TrianglePatterns>(after); }
};

/// The families of the shipped file, in its order.
[[nodiscard]] const std::vector<Description>& families();

/// Throws std::invalid_argument.
[[nodiscard]] const Description& family_named(const std::string& name);

/// Where an operation happens: `k` triangles in the fan; `at` is the arc a of a split, or gap i; `to` is gap j of an
/// open-split. Unused members are 0; k is the number of ports where there is only one position.
struct Position {
  const Description* family = nullptr;
  unsigned k = 0;
  unsigned at = 0;
  unsigned to = 0;
  [[nodiscard]] PositionNumbers numbers() const { return {k, at, to}; }
  friend auto operator<=>(const Position&, const Position&) = default;
};

/// All positions with this valence, one for each class under mirror images and half turns, in ascending order.
[[nodiscard]] std::vector<Position> positions(const Description& family, unsigned k);

/// Those of all valences up to this one; the only one of a family without numbers.
[[nodiscard]] std::vector<Position> positions_up_to(const Description& family, unsigned max_k);

/// The smallest valence of a family.
[[nodiscard]] unsigned smallest_valence(const Description& family);

/// True when the fan closes around an interior vertex.
[[nodiscard]] bool closed(const Description& family);

/// True when a section of its certificate serves all positions of a valence: its rules do not depend on the position.
[[nodiscard]] bool serves_every_position(const Description& family);

/// Throws std::runtime_error that names file, place and position if a pattern does not make a patch of triangles.
[[nodiscard]] Patch make_patch(const Position& position);

/// The triangles of a position, which must not be is_graph_only().
[[nodiscard]] Surface surface_at(const Position& position);

/// The position of the rows that serve this one: numbers that its section leaves out are 0.
[[nodiscard]] Position position_of_rows(Position position);

/// What the rows of a position act on: its patch; where they serve every position, of which only the numbers of the
/// section need be given then, the side after alone, before and after.
[[nodiscard]] Patch patch_of_rows(const Position& position);

/// The operation at this position, or on the patch of its rows, as its description has it: without a tie-break.
[[nodiscard]] Operation operation_at(const Position& position, Patch patch);
[[nodiscard]] inline Operation operation_at(const Position& position) {
  return operation_at(position, make_patch(position));
}

/// A position as certificates write it, after the word `section`.
[[nodiscard]] std::string position_text(const Position& position);

/// An operation as dumps and reports name it: "open-collapse k 8 gaps 2 5".
[[nodiscard]] std::string name_of(const Position& position);

}  // namespace restrip::generator
