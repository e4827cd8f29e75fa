#pragma once
// Certificates for small fans, made in the slowest and most obvious way, and deliberately wrong ones. Shares nothing
// with the checker that it tests: triangles are numbers, edges are pairs of numbers, strips are found by union-find.

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace restrip::verify::test {

using Pair = std::pair<int, int>;

/// t_i is triangle i; A and D are the two numbers below.
inline constexpr int triangle_a = 100;
inline constexpr int triangle_d = 101;

struct NaivePatch {
  std::vector<int> triangles;
  std::vector<int> port_owner;
  std::vector<Pair> edges;
  bool closed = false;
  int chord = -1;  ///< index of an edge, -1 for none
};

struct NaiveOperation {
  NaivePatch before;
  NaivePatch after;
  bool flip = false;
};

struct NaiveSection {
  std::string position;
  bool whole_fan_symmetry = false;
  std::vector<NaiveOperation> operations;
};

struct NaiveFamily {
  std::string name;
  std::vector<NaiveSection> sections;
};

std::vector<NaiveFamily> naive_families(int max_k);

/// An operation on a fan by its name, such as "open-collapse", at {k, a}, {k, i, j} or {k, i}; any position.
NaiveOperation naive_operation(const std::string& name, const std::vector<int>& position);

struct NaiveColors {
  int inner = 0;
  int ports = 0;
  friend auto operator<=>(NaiveColors, NaiveColors) = default;
};

/// A constraint of the problem that can be dropped, to find what a careless checker would accept.
enum class Dropped {
  nothing,
  all_cycles,
  outer_cycle,  ///< a cycle without the chord
  chord_cycles,
  degrees,
  new_degrees,  ///< those of A and D
  pairing
};

struct Anatomy {
  std::set<Pair> joined;
  int solid = 0;  ///< inner edges and ports
  int isolated = 0;
};

/// nullopt when the colouring is not valid, the dropped constraint aside.
std::optional<Anatomy> anatomy(const NaivePatch& patch, NaiveColors colors, Dropped dropped = Dropped::nothing);

/// A sound recolouring and how good it is: solid edges, minus isolated, ports kept.
struct Candidate {
  NaiveColors colors;
  std::vector<int> merit;
};

/// All sound recolourings of a valid configuration, the dropped constraint aside.
std::vector<Candidate> sound_recolorings(const NaiveOperation& operation, NaiveColors before,
                                         Dropped dropped = Dropped::nothing);

/// A question that a checker of reasons can forget, to find what it would take for a reason then.
enum class Careless {
  not_at_all,
  off_by_one,
  only_dashed,  ///< isolated triangles and ports given up are not asked for
  sound_sets,
  overlapping_sets,
  count_dashed_twice,
  foreign_edges,
  skip_solid_case,
  skip_dashed_case,
  solid_in_both_cases
};

/// A reason why nothing is preferred to `after`, as certificates write it; nullopt when there is none.
std::optional<std::string> naive_reason(const NaiveOperation& operation, NaiveColors before, NaiveColors after,
                                        Careless careless = Careless::not_at_all);

using NaiveKey = std::pair<int, int>;  ///< ports and `joined`, or ports and inner for the flip

struct NaiveRow {
  NaiveColors after;
  std::string by;             ///< symmetry of a copy, empty for a rule
  std::string because = "-";  ///< reason of a rule
};

struct NaiveTable {
  std::string family;
  std::string position;
  bool flip = false;
  std::vector<std::pair<std::string, int>> claims;
  std::map<NaiveKey, NaiveRow> rows;
};

NaiveKey naive_key(const NaiveOperation& operation, NaiveColors before);
/// Calls back for each valid configuration of each operation of the section.
void for_each_valid(const NaiveSection& section, const std::function<void(const NaiveOperation&, NaiveColors)>& visit);

NaiveTable naive_table(const NaiveFamily& family, const NaiveSection& section);

/// A certificate that holds these sections.
std::string certificate_text(const std::string& family, const std::vector<NaiveTable>& tables);

/// The text with the right sums in its last line, if that begins with "end"; otherwise the text as it is.
std::string with_sums(const std::string& text);

}  // namespace restrip::verify::test
