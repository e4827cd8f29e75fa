#pragma once
// Reads a side of an operation in any of the forms of docs/operation-file.md.

#include "model/json_value.hpp"
#include "model/operation.hpp"

namespace restrip::verify {

/// The numbers of a family with their values at one position.
struct NamedNumbers {
  const std::vector<std::string>& names;
  const Numbers& values;
};

/// The two sides of an operation.
struct Sides {
  Side before;
  Side after;
  unsigned vertices = 0;  ///< of triangles with named vertices; 0 for the other forms
  std::vector<PlacedTriangle> placed_before;
  std::vector<PlacedTriangle> placed_after;
};

/// The sides of a description, at one position.
Sides read_sides(const JsonValue& description, const NamedNumbers& numbers);

/// A graph, or triangles around rings and along paths. InputError, also when it is larger than the limits.
Side read_side(const JsonValue& value, const NamedNumbers& numbers);

}  // namespace restrip::verify
