// Operations report what a count of the whole mesh finds: a random one under a keeper, and the sum of many.
#pragma once

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "../support/random_operations.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/policy.hpp"

namespace restrip {

/// The policies that search after a rule, and so weigh more than strips.
inline std::vector<Policy> searching_policies() {
  std::vector<Policy> found;
  for (const PolicyRow& row : policies)
    if (row.plan.limits.looks > 0) found.push_back(row.policy);
  return found;
}

/// Strips and isolated triangles of the whole mesh: what operations report must add up to them.
struct Census {
  long strips = 0;
  long isolated = 0;
  /// Adds the changes that an operation reports.
  template <class Done>
  Census& operator+=(const Done& done) {
    strips += done.strips;
    isolated += done.isolated;
    return *this;
  }
  friend bool operator==(const Census&, const Census&) = default;
};

/// Of a valid colouring.
inline Census census_of(const StripMesh& mesh) {
  const ColoringReport report = check_coloring(mesh);
  EXPECT_TRUE(report.valid);
  return {static_cast<long>(report.strips), static_cast<long>(report.isolated)};
}

/// False if the operation of the list that was drawn was not possible.
template <class Keeper, std::size_t N = splits_collapses_flips.size()>
bool random_operation(Keeper& keeper, std::mt19937& random, bool grow,
                      const std::array<OperationShare, N>& list = splits_collapses_flips) {
  const StripMesh& mesh = keeper.mesh();
  const DrawnOperation drawn = draw(mesh, random, list, trend_of(grow));
  const std::size_t before = keeper.strips();
  // Counting isolated triangles looks at the whole mesh.
  const bool counts_isolated = mesh.triangle_count() < 1000;
  const auto isolated = [&] { return counts_isolated ? static_cast<int>(check_coloring(mesh).isolated) : 0; };
  const int isolated_before = isolated();
  const Checked done = perform(keeper, drawn);
  if (!done) return false;
  EXPECT_EQ(static_cast<long>(keeper.strips()), static_cast<long>(before) + done.rewrite.strips);
  if (counts_isolated) {
    EXPECT_EQ(isolated(), isolated_before + done.rewrite.isolated);
  }
  return true;
}

}  // namespace restrip
