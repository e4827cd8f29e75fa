#include "judge/orbits.hpp"

#include <boost/pending/disjoint_sets.hpp>

namespace restrip::verify {
namespace {

std::vector<Mask> images_of_masks(const Permutation& permutation) {
  std::vector<Mask> images;
  for (Mask mask = 0; mask < mask_count(static_cast<unsigned>(permutation.size())); ++mask)
    images.push_back(moved(mask, permutation));
  return images;
}

}  // namespace

OrbitCounts merged_orbits(const Operation& operation, const Symmetries& symmetries, const std::vector<bool>& valid) {
  const unsigned ports = operation.ports();
  boost::disjoint_sets_with_storage<> sets(valid.size());
  for (const Symmetry& symmetry : symmetries.generators()) {
    const std::vector<Mask> ports_image = images_of_masks(symmetry.ports);
    const std::vector<Mask> edges_image = images_of_masks(symmetry.edges_before);
    for (Mask both = 0; both < valid.size(); ++both)
      sets.union_set(both,
                     concatenated(edges_image[high_part(both, ports)], ports_image[low_part(both, ports)], ports));
  }
  OrbitCounts orbits;
  for (Mask both = 0; both < valid.size(); ++both)
    if (sets.find_set(both) == both) {
      ++orbits.all;
      orbits.valid += valid[both] ? 1U : 0U;
    }
  return orbits;
}

}  // namespace restrip::verify
