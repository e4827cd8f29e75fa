// Descriptions of operations (docs/reference/operation-file.md). A description with numbers is a family with one
// operation for each position; others describe a single operation with one position. The shipped families are in
// tables/families.json; no other code knows their names.
#pragma once

#include <compare>
#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "describe/formula.hpp"
#include "describe/operation.hpp"
#include "describe/triangles.hpp"

namespace restrip::generator {

// tables/families.json and a list of the files of tables/operations, embedded at build time (cmake/Embed.cmake).

extern const std::string_view families_text;
extern const std::string_view operations_text;

/// Limits for operation files, on either side; families must obey them when tables are made.
inline constexpr unsigned most_ports = 12;
inline constexpr unsigned most_nodes = 16;
/// Of one side together: a table has an entry for each of their colourings, at most 4 million.
inline constexpr unsigned most_edges_and_ports = 22;
/// Of families: the largest first number of a position, unless the user says.
inline constexpr unsigned default_max_k = 8;

/// Who wrote a file. Names of restrip's own tables are reserved for restrip's families, which have no limits.
enum class Author { user, restrip };

/// A side for all positions in tables/families.json: the triangles t_i, each with one port, in the order of their ring
/// or path, and inserted ones. Inner edges: along the ring or path, then the chord between the two inserted triangles.
struct Fan {
  bool ring = false;
  std::vector<Stretch> elements;
  bool chord = false;
};

/// Users' files give triangles.
using SideForm = std::variant<Fan, TrianglePatterns>;

struct Description {
  Author author = Author::user;
  std::string name;  ///< "open-collapse"
  std::string about;
  std::string certificate;  ///< the certificate whose rules it shares: "fan-collapse"
  Constraint constraint;
  Preference preference;
  bool own_cost = false;             ///< `preference` is not the default
  Mask may_give_up = 0;              ///< ports, also beyond the last if all may be given up
  bool has_table = true;             ///< among the shipped tables; the automaton answers the other families
  std::vector<std::string> numbers;  ///< of its positions: "k", "i", "j"; empty if there is only one position
  std::string range;                 ///< `where` as text
  Conditions where;                  ///< the positions that exist
  Conditions listed;                 ///< the positions that are not images of others
  std::string place;                 ///< "k {k} gaps {i} {j}", as dumps write a position; empty if there is only one
  std::string section;               ///< as certificates write it: "k {k}" if it omits some numbers
  SideForm before;
  SideForm after;
  std::vector<StretchPattern> boundary;  ///< in triangles
  std::string in_file;                   ///< the place in the file, as errors begin: "f.json:3:18: operations[0]: "
  std::string before_in_file;            ///< the same for its sides, and for the declared boundary
  std::string after_in_file;
  std::string boundary_in_file;
};

/// A name with underscores, as used in programs and file names.
[[nodiscard]] std::string identifier(std::string name);

/// The families of the shipped file, in its order.
[[nodiscard]] const std::vector<Description>& families();

/// The families that the shipped tables answer, in the same order. The automaton answers the others.
[[nodiscard]] const std::vector<Description>& tabled_families();

/// Throws std::invalid_argument for an unknown name.
[[nodiscard]] const Description& family_named(const std::string& name);

/// The position of an operation: `k` triangles in the fan; `at` is the arc a of a split, or gap i; `to` is gap j of an
/// open-split. Unused members are 0; k is the number of ports if there is only one position.
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

/// The positions of all valences up to this one; the only one of a family without numbers.
[[nodiscard]] std::vector<Position> positions_up_to(const Description& family, unsigned max_k);

/// The smallest valence of a family.
[[nodiscard]] unsigned smallest_valence(const Description& family);

/// True if a section of its certificate serves all positions of a valence: its rules do not depend on the position.
[[nodiscard]] bool serves_every_position(const Description& family);

/// Throws std::runtime_error, naming file, place and position, if its triangles do not make a patch.
[[nodiscard]] Patch make_patch(const Position& position);

/// The position of the rows that serve this one: numbers that its section omits are 0.
[[nodiscard]] Position position_of_rows(Position position);

/// The patch on which the rows of a position act: its own patch. If the rows serve every position, it has the side
/// after as both sides, and only the numbers of the section are needed.
[[nodiscard]] Patch patch_of_rows(const Position& position);

struct PositionWithPatch : Position {
  Patch patch;
};

/// The operation on the patch of this position or of its rows, as described, without a tie-break.
[[nodiscard]] Operation operation_at(const Position& position, Patch patch);

/// A position as certificates write it, after the word `section`.
[[nodiscard]] std::string position_text(const Position& position);

/// The name of an operation in dumps and reports: "open-collapse k 8 gaps 2 5".
[[nodiscard]] std::string name_of(const Position& position);

// Reads files of descriptions (docs/reference/operation-file.md): one description, or a list.

inline constexpr std::size_t most_terms = 64;  ///< of a criterion

/// "expected at most 22 edges and ports together: a table has an entry for each of their colourings; found 12 and 12".
[[nodiscard]] std::string too_many_colors(const Side& side);

/// Reads the files of a user, of at most 1 MiB each. Throws files::FileError, or std::runtime_error if descriptions in
/// two files have the same name or certificate.
[[nodiscard]] std::vector<Description> read_descriptions(const std::vector<std::string>& files);

/// Reads the text of a file; `file` is only used in errors.
[[nodiscard]] std::vector<Description> parse_descriptions(const std::string& file, const std::string& text,
                                                          Author author = Author::user);

// The tie-break, whose effect is measured, not proved: it keeps strips long over thousands of operations on fans
// (docs/reference/tables.md, "Tie-break").

/// The operation on which the rows of a position act (patch_of_rows), with its preference.
[[nodiscard]] Operation operation_of_rows(const Position& position);

/// The tie-break of a position with the side `after`: empty for descriptions of single operations and for descriptions
/// with an explicit constraint or cost.
[[nodiscard]] Criterion tie_break(const Position& position, const Side& after);

}  // namespace restrip::generator
