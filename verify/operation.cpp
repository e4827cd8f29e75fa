#include "operation.hpp"

#include <fmt/format.h>

namespace restrip::verify {
namespace {

struct Gaps {
  unsigned first;
  unsigned second;
};

/// The positions that notation.md lists; all others are mirror images.
std::vector<Gaps> gap_pairs(unsigned k) {
  std::vector<Gaps> pairs;
  for (unsigned i = 0; i <= k; ++i)
    for (unsigned j = i + 1; j <= k && i + j <= k; ++j) pairs.push_back({i, j});
  return pairs;
}

Section fan_section(std::string position, unsigned k, unsigned recoloring_bits, bool serves_every_position = false) {
  return {std::move(position), k, k, recoloring_bits, serves_every_position, {}};
}

Family splits(unsigned max_k) {
  Family family{"split", {}};
  for (unsigned k = 3; k <= max_k; ++k)
    for (unsigned a = 1; 2 * a <= k; ++a) {
      const std::string position = fmt::format("k {} a {}", k, a);
      family.sections.push_back(fan_section(position, k, k + 3));
      family.sections.back().operations.push_back(
          {"split", position, Patch::closed_fan(k), Patch::ring_with_chord(k, a)});
    }
  return family;
}

Family collapses(unsigned max_k) {
  Family family{"collapse", {}};
  for (unsigned k = 3; k <= max_k; ++k) {
    family.sections.push_back(fan_section(fmt::format("k {}", k), k, k, true));
    for (unsigned a = 1; 2 * a <= k; ++a)
      family.sections.back().operations.push_back(
          {"collapse", fmt::format("k {} a {}", k, a), Patch::ring_with_chord(k, a), Patch::closed_fan(k)});
  }
  return family;
}

Family open_splits(unsigned max_k) {
  Family family{"open-split", {}};
  for (unsigned k = 1; k <= max_k; ++k)
    for (const Gaps gaps : gap_pairs(k)) {
      const std::string position = fmt::format("k {} gaps {} {}", k, gaps.first, gaps.second);
      family.sections.push_back(fan_section(position, k, k + 2));
      family.sections.back().operations.push_back(
          {"open-split", position, Patch::open_fan(k), Patch::path_with_chord(k, gaps.first, gaps.second)});
    }
  return family;
}

Family boundary_splits(unsigned max_k) {
  Family family{"boundary-split", {}};
  for (unsigned k = 1; k <= max_k; ++k)
    for (unsigned gap = 0; 2 * gap <= k; ++gap) {
      const std::string position = fmt::format("k {} gap {}", k, gap);
      family.sections.push_back(fan_section(position, k, k));
      family.sections.back().operations.push_back(
          {"boundary-split", position, Patch::open_fan(k), Patch::path(k, gap)});
    }
  return family;
}

Family fan_collapses(unsigned max_k) {
  Family family{"fan-collapse", {}};
  for (unsigned k = 1; k <= max_k; ++k) {
    family.sections.push_back(fan_section(fmt::format("k {}", k), k, k - 1, true));
    std::vector<Operation>& operations = family.sections.back().operations;
    for (const Gaps gaps : gap_pairs(k))
      operations.push_back({"open-collapse", fmt::format("k {} gaps {} {}", k, gaps.first, gaps.second),
                            Patch::path_with_chord(k, gaps.first, gaps.second), Patch::open_fan(k)});
    for (unsigned gap = 0; 2 * gap <= k; ++gap)
      operations.push_back(
          {"boundary-collapse", fmt::format("k {} gap {}", k, gap), Patch::path(k, gap), Patch::open_fan(k)});
  }
  return family;
}

Family flips() {
  Family family{"flip", {}};
  family.sections.push_back({"flip", 4, 1, 1, false, {}});
  family.sections.back().operations.push_back({"flip", "", Patch::flip(0, 1), Patch::flip(1, 2), true});
  return family;
}

}  // namespace

std::vector<Family> all_families(unsigned max_k) {
  return {splits(max_k), collapses(max_k), open_splits(max_k), boundary_splits(max_k), fan_collapses(max_k), flips()};
}

std::vector<LinkedFamily> linked_families(unsigned max_k) {
  return {{"linked-split", splits(max_k)}, {"linked-collapse", collapses(max_k)}};
}

}  // namespace restrip::verify
