// A naive judge of operations, for the tests of the verifier: worlds are sets of pairs, cycles are found by comparing
// edges with components, and symmetries by trying all permutations. Of the verifier it uses only the operation as it
// was read.
#pragma once

#include <set>
#include <utility>
#include <vector>

#include "model/operation.hpp"

namespace restrip::verify::test {

using Pair = std::pair<int, int>;
using Pairs = std::set<Pair>;

struct NaiveColors {
  int inner = 0;
  int ports = 0;
  friend auto operator<=>(const NaiveColors&, const NaiveColors&) = default;
};

using NaiveKey = std::pair<int, int>;  ///< ports, joined pairs

/// A constraint of the problem that can be dropped, to find what a careless checker would accept.
enum class Dropped {
  nothing,
  all_cycles,
  outer_cycle,  ///< a cycle without the chord between A and D
  chord_cycles,
  degrees,
  new_degrees,  ///< degrees of A and D
  pairing
};

struct NaiveCandidate {
  NaiveColors after;
  std::vector<long> cost;
};

struct NaiveSymmetry {
  std::vector<int> ports, before, after;
};

class NaiveOperation {
 public:
  explicit NaiveOperation(Operation operation);

  const Operation& operation() const { return operation_; }
  int ports() const { return static_cast<int>(operation_.ports()); }
  std::vector<NaiveColors> configurations() const;
  bool valid(bool after, NaiveColors colors, Dropped dropped = Dropped::nothing) const;
  int joined(bool after, NaiveColors colors) const;
  int isolated(bool after, NaiveColors colors) const;
  NaiveKey key(NaiveColors configuration) const;
  /// The sound recolourings, by definition in every world; with a dropped constraint, by the joined pairs. In ascending
  /// order of R, then K.
  std::vector<NaiveCandidate> sound(NaiveColors configuration, Dropped dropped = Dropped::nothing) const;

  /// Whether an operation may leave these ports of the solid ones solid.
  bool may_keep(int ports, int kept) const;
  /// The criteria of the operation, in order.
  std::vector<long> cost(NaiveColors configuration, NaiveColors after) const;

  /// All worlds of these solid ports, as sets of pairs of ports that are connected.
  const std::vector<Pairs>& worlds(int ports) const { return worlds_[static_cast<std::size_t>(ports)]; }
  bool fits(bool after, NaiveColors colors, const Pairs& world) const;

  /// Without `before_too`, the symmetries of the patch after alone.
  std::vector<NaiveSymmetry> symmetries(bool before_too) const;
  NaiveColors moved(const NaiveSymmetry& symmetry, bool after, NaiveColors colors) const;
  NaiveKey moved(const NaiveSymmetry& symmetry, NaiveKey key) const;

  /// A rule's change of `strips`, or of `isolated` including ports given up.
  long change(NaiveColors after, NaiveColors configuration, Count count) const;

 private:
  const Side& side(bool after) const { return after ? operation_.after : operation_.before; }
  std::vector<int> degrees(bool after, NaiveColors colors) const;
  bool cycle_allowed(bool after, int inner, Dropped dropped) const;
  std::vector<Pairs> worlds_of(int ports) const;
  long counted(const Term& term, NaiveColors configuration, NaiveColors after) const;
  int moved_edges(const NaiveSymmetry& symmetry, bool after, int inner) const;
  bool cost_stays(const NaiveSymmetry& symmetry) const;

  Operation operation_;
  std::vector<std::vector<Pairs>> worlds_;  ///< by ports
  std::vector<int> joinable_;               ///< by ports: pairs that some recolouring joins
};

}  // namespace restrip::verify::test
