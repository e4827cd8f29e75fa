#include "operation.hpp"

#include <fmt/format.h>

namespace restrip::verify {
namespace {

struct Gaps {
  unsigned first;
  unsigned second;
};

/// All i < j <= k.
std::vector<Gaps> gap_pairs(unsigned k) {
  std::vector<Gaps> pairs;
  for (unsigned i = 0; i <= k; ++i)
    for (unsigned j = i + 1; j <= k; ++j) pairs.push_back({i, j});
  return pairs;
}

// Which positions notation.md lists.
bool listed_arc(unsigned k, unsigned a) { return 2 * a <= k; }
bool listed_gaps(unsigned k, Gaps gaps) { return gaps.first + gaps.second <= k; }
bool listed_gap(unsigned k, unsigned gap) { return 2 * gap <= k; }

std::string at_arc(unsigned k, unsigned a) { return fmt::format("k {} a {}", k, a); }
std::string at_gaps(unsigned k, Gaps gaps) { return fmt::format("k {} gaps {} {}", k, gaps.first, gaps.second); }
std::string at_gap(unsigned k, unsigned gap) { return fmt::format("k {} gap {}", k, gap); }

Section fan_section(std::string position, unsigned k, unsigned recoloring_bits, bool serves_every_position = false) {
  return {std::move(position), k, k, recoloring_bits, serves_every_position, {}};
}

Family splits(unsigned max_k) {
  Family family{"split", {}, {}};
  for (unsigned k = 3; k <= max_k; ++k)
    for (unsigned a = 1; a < k; ++a) {
      const std::string position = at_arc(k, a);
      const Operation operation{"split", position, Patch::closed_fan(k), Patch::ring_with_chord(k, a)};
      if (listed_arc(k, a)) {
        family.sections.push_back(fan_section(position, k, k + 3));
        family.sections.back().operations.push_back(operation);
      } else {
        family.unlisted.push_back(operation);
      }
    }
  return family;
}

Family collapses(unsigned max_k) {
  Family family{"collapse", {}, {}};
  for (unsigned k = 3; k <= max_k; ++k) {
    family.sections.push_back(fan_section(fmt::format("k {}", k), k, k, true));
    for (unsigned a = 1; a < k; ++a)
      (listed_arc(k, a) ? family.sections.back().operations : family.unlisted)
          .push_back({"collapse", at_arc(k, a), Patch::ring_with_chord(k, a), Patch::closed_fan(k)});
  }
  return family;
}

Family open_splits(unsigned max_k) {
  Family family{"open-split", {}, {}};
  for (unsigned k = 1; k <= max_k; ++k)
    for (const Gaps gaps : gap_pairs(k)) {
      const std::string position = at_gaps(k, gaps);
      const Operation operation{"open-split", position, Patch::open_fan(k),
                                Patch::path_with_chord(k, gaps.first, gaps.second)};
      if (listed_gaps(k, gaps)) {
        family.sections.push_back(fan_section(position, k, k + 2));
        family.sections.back().operations.push_back(operation);
      } else {
        family.unlisted.push_back(operation);
      }
    }
  return family;
}

Family boundary_splits(unsigned max_k) {
  Family family{"boundary-split", {}, {}};
  for (unsigned k = 1; k <= max_k; ++k)
    for (unsigned gap = 0; gap <= k; ++gap) {
      const std::string position = at_gap(k, gap);
      const Operation operation{"boundary-split", position, Patch::open_fan(k), Patch::path(k, gap)};
      if (listed_gap(k, gap)) {
        family.sections.push_back(fan_section(position, k, k));
        family.sections.back().operations.push_back(operation);
      } else {
        family.unlisted.push_back(operation);
      }
    }
  return family;
}

Family fan_collapses(unsigned max_k) {
  Family family{"fan-collapse", {}, {}};
  for (unsigned k = 1; k <= max_k; ++k) {
    family.sections.push_back(fan_section(fmt::format("k {}", k), k, k - 1, true));
    for (const Gaps gaps : gap_pairs(k))
      (listed_gaps(k, gaps) ? family.sections.back().operations : family.unlisted)
          .push_back({"open-collapse", at_gaps(k, gaps), Patch::path_with_chord(k, gaps.first, gaps.second),
                      Patch::open_fan(k)});
    for (unsigned gap = 0; gap <= k; ++gap)
      (listed_gap(k, gap) ? family.sections.back().operations : family.unlisted)
          .push_back({"boundary-collapse", at_gap(k, gap), Patch::path(k, gap), Patch::open_fan(k)});
  }
  return family;
}

Family flips() {
  Family family{"flip", {}, {}};
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
