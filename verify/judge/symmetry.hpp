// The symmetries of an operation (docs/reference/certificate.md): isomorphisms, found by Boost's VF2, of a graph with a
// node for each port, each triangle, each inner edge after and each term of the cost that counts only some members.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "model/coloring.hpp"
#include "model/masks.hpp"

namespace restrip::verify {

/// The effect of a symmetry.
struct Symmetry {
  Permutation ports;
  Permutation edges_before;  ///< empty if the patch before is irrelevant
  Permutation edges_after;
};

class Symmetries {
 public:
  /// Symmetries of the patches before and after, or of the patch after alone, if one rule serves every position.
  enum class Keep { both_sides, after };
  /// Throws InputError if equal parts of a patch make the search take more than a few seconds.
  Symmetries(const Operation& operation, Keep keep);

  /// Generators of the symmetry group.
  const std::vector<Symmetry>& generators() const { return generators_; }
  /// The number of symmetries; some may have the same effect on all configurations.
  double order() const { return order_; }

  /// True if some symmetry moves the ports in this way.
  bool allows(const Permutation& ports) const { return with(ports) != nullptr; }
  /// True if some symmetry moves the ports in this way and maps one colouring after the operation to the other.
  bool carries(const Permutation& ports, Colors from, Colors to) const;

 private:
  Symmetry symmetry_of(const Permutation& nodes) const;
  /// One that moves the ports in this way, or null.
  const Symmetry* with(const Permutation& ports) const;

  const Operation& operation_;
  bool before_too_;
  std::vector<Symmetry> generators_;
  double order_ = 1;
  mutable std::map<Permutation, std::optional<Symmetry>> known_;  ///< by permutation of ports
};

/// Whether some map of triangles, edges and ports takes one operation to another: its patches before and after, the
/// ports that may be given up, and the cost. Throws InputError as above.
bool isomorphic(const Operation& one, const Operation& other);

// Counts orbits of configurations by merging each with its images under the symmetries found here. The generator counts
// them by nauty's symmetries.

struct OrbitCounts {
  std::uint64_t all = 0;
  std::uint64_t valid = 0;
};

/// `valid` gives for each configuration, indexed by concatenated(inner, ports), whether it is valid.
OrbitCounts merged_orbits(const Operation& operation, const Symmetries& symmetries, const std::vector<bool>& valid);

}  // namespace restrip::verify
