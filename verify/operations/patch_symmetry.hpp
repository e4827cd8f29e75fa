#pragma once
// The symmetries of an operation (docs/operation-file.md, "Certificate"): found by backtracking on one graph that has a
// node for each port, each triangle, each inner edge after and each term of the cost that counts only some of them.

#include <optional>
#include <string>
#include <vector>

#include "coloring.hpp"
#include "isomorphism.hpp"

namespace restrip::verify::operations {

/// The key of a configuration: solid ports, and which of them are joined.
struct OperationKey {
  Mask ports = 0;
  PortPairs joined;
  friend constexpr auto operator<=>(OperationKey, OperationKey) = default;
};

/// What a symmetry does to configurations.
struct SideSymmetry {
  Permutation ports;
  Permutation edges;  ///< inner edges before
};

class PatchSymmetries {
 public:
  explicit PatchSymmetries(const OperationFile& operation);

  /// Symmetries of which all others are made.
  const std::vector<SideSymmetry>& generators() const { return generators_; }
  /// How many symmetries there are; some of them may do the same to all configurations.
  double order() const { return order_; }

  /// True when some symmetry moves the ports so.
  bool allows(const Permutation& ports) const;
  /// True when some symmetry moves the ports so and takes one colouring after the operation to the other.
  bool carries(const Permutation& ports, Colors from, Colors to) const;

 private:
  ColoredGraph graph(Colors after) const;

  const OperationFile& operation_;
  std::vector<SideSymmetry> generators_;
  double order_ = 1;
};

Mask moved(Mask mask, const Permutation& permutation);
OperationKey moved(OperationKey key, const Permutation& ports);

}  // namespace restrip::verify::operations
