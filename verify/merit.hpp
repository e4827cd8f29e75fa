#pragma once
// The order of preference among sound recolourings (docs/notation.md), as far as it has to be believed.

#include <compare>

#include "slice.hpp"

namespace restrip::verify {

/// Ascending: a greater merit is preferred.
struct Merit {
  int solid = 0;           ///< solid edges after the operation, ports included
  int fewer_isolated = 0;  ///< minus the isolated triangles; every port given up counts as one
  int ports_kept = 0;
  friend constexpr auto operator<=>(Merit, Merit) = default;
};

inline Merit merit_of(const Survey& after, Coloring colors, Mask ports_before) {
  const int kept = static_cast<int>(solid_count(colors.ports));
  const int given_up = static_cast<int>(solid_count(ports_before)) - kept;
  return {after.solid + kept, -(after.isolated + given_up), kept};
}

/// What an operation did to the number of strips and of isolated triangles.
struct Change {
  int strips = 0;
  int isolated = 0;
};

inline Change change_of(const Operation& operation, const SurveyedColoring& before, Merit after) {
  const int nodes =
      static_cast<int>(operation.after.triangles().size()) - static_cast<int>(operation.before.triangles().size());
  const int solid_before = before.survey.solid + static_cast<int>(solid_count(before.colors.ports));
  return {nodes - (after.solid - solid_before), -after.fewer_isolated - before.survey.isolated};
}

}  // namespace restrip::verify
