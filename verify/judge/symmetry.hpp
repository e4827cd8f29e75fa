#pragma once
// The symmetries of an operation (docs/reference/certificate.md): isomorphisms, found by Boost's VF2, of one graph that
// has a node for each port, each triangle, each inner edge after and each term of the cost that counts only some of
// them.

#include <map>
#include <optional>
#include <vector>

#include "model/coloring.hpp"
#include "model/key.hpp"

namespace restrip::verify {

/// What a symmetry does.
struct Symmetry {
  Permutation ports;
  Permutation edges_before;  ///< empty where the patch before plays no part
  Permutation edges_after;
};

class Symmetries {
 public:
  /// Symmetries that keep the patches before and after; or the patch after alone, where one rule serves every position.
  enum class Keep { both_sides, after };
  /// InputError when a patch has so many equal parts that the search takes more than a few seconds.
  Symmetries(const Operation& operation, Keep keep);

  /// Symmetries of which all others are made.
  const std::vector<Symmetry>& generators() const { return generators_; }
  /// How many symmetries there are; some of them may do the same to all configurations.
  double order() const { return order_; }

  /// True when some symmetry moves the ports so.
  bool allows(const Permutation& ports) const { return with(ports) != nullptr; }
  /// True when some symmetry moves the ports so and takes one colouring after the operation to the other.
  bool carries(const Permutation& ports, Colors from, Colors to) const;

 private:
  Symmetry symmetry_of(const Permutation& nodes) const;
  /// One that moves the ports so, or null.
  const Symmetry* with(const Permutation& ports) const;

  const Operation& operation_;
  bool before_too_;
  std::vector<Symmetry> generators_;
  double order_ = 1;
  mutable std::map<Permutation, std::optional<Symmetry>> known_;  ///< by what it does to the ports
};

}  // namespace restrip::verify
