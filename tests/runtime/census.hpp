// Strips and isolated triangles, counted in the whole mesh: what operations report must add up to it.
#pragma once

#include <gtest/gtest.h>

#include "restrip/output/strips.hpp"

namespace restrip {

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

}  // namespace restrip
