#pragma once
// Symmetries of a patch: a turn or a mirror of its ports, and what it does to triangles and edges, worked out on the
// graph itself.

#include <optional>
#include <string>
#include <vector>

#include "key.hpp"

namespace restrip::verify {

/// `turn n` takes port i to i + n, `mirror n` takes it to n - i, both modulo the number of ports.
struct PortSymmetry {
  bool mirror = false;
  unsigned n = 0;

  unsigned image(unsigned port, unsigned port_count) const {
    return (mirror ? n + port_count - port : port + n) % port_count;
  }
  std::string text() const { return (mirror ? "mirror " : "turn ") + std::to_string(n); }
};

/// Where each edge of some kind goes.
using EdgePermutation = std::vector<unsigned>;

Mask permuted(Mask mask, const EdgePermutation& permutation);

EdgePermutation port_permutation(PortSymmetry symmetry, unsigned port_count);

/// Every way to carry the patch onto itself that moves the ports as told, as permutations of the inner edges. More
/// than one only when triangles without ports can trade places; none when the patch lacks the symmetry.
std::vector<EdgePermutation> extensions(const Patch& patch, PortSymmetry symmetry);

/// The turns and mirrors that rows of a section may name: those that keep the position, or the whole fan where a
/// rule serves every position.
std::vector<PortSymmetry> symmetries_of(const Section& section);

/// How one symmetry of an operation acts on configurations.
struct ConfigurationSymmetry {
  EdgePermutation ports;
  EdgePermutation inner;
  friend bool operator==(const ConfigurationSymmetry&, const ConfigurationSymmetry&) = default;
};

/// The group that acts on the configurations of an operation, each element once.
std::vector<ConfigurationSymmetry> configuration_symmetries(const Operation& operation);

/// The key that the symmetry takes `key` to. `key.second` must be meaningful (pairs_of succeeds).
Key image_of(Key key, PortSymmetry symmetry, const Section& section);

}  // namespace restrip::verify
