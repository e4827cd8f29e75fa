#include <array>
#include <stdexcept>

#include "orbits.hpp"
#include "symmetry.hpp"

namespace restrip::verify {
namespace {

/// The image of every mask of as many bits as the permutation has.
std::vector<Mask> images(const EdgePermutation& permutation) {
  std::vector<Mask> result;
  for (Mask mask = 0; mask < mask_count(static_cast<unsigned>(permutation.size())); ++mask)
    result.push_back(permuted(mask, permutation));
  return result;
}

}  // namespace

// The number of orbits is the average number of configurations that a symmetry leaves as they are.
OrbitCounts burnside_orbits(const Operation& operation, const std::vector<bool>& valid) {
  const std::vector<ConfigurationSymmetry> group = configuration_symmetries(operation);
  OrbitCounts fixed;
  for (const ConfigurationSymmetry& symmetry : group) {
    const std::vector<Mask> ports_image = images(symmetry.ports);
    const std::vector<Mask> inner_image = images(symmetry.inner);
    for (Mask inner = 0; inner < inner_image.size(); ++inner) {
      if (inner_image[inner] != inner) continue;
      for (Mask ports = 0; ports < ports_image.size(); ++ports) {
        if (ports_image[ports] != ports) continue;
        ++fixed.all;
        fixed.valid += valid[concatenated(inner, ports, operation.before.ports())] ? 1U : 0U;
      }
    }
  }
  if (fixed.all % group.size() != 0 || fixed.valid % group.size() != 0)
    throw std::logic_error("the symmetries of " + operation.name() + " are not a group");
  return {fixed.all / group.size(), fixed.valid / group.size()};
}

}  // namespace restrip::verify
