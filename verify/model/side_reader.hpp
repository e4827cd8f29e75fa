// Reads the sides of an operation: triangles (docs/reference/operation-file.md), or the fans of tables/families.json.
#pragma once

#include "common/json.hpp"
#include "model/operation.hpp"
#include "model/triangles.hpp"

namespace restrip::verify {

/// The numbers of a family with their values at one position.
struct NamedNumbers {
  const std::vector<std::string>& names;
  const Numbers& values;
};

/// "t[0,k)": the name and the range, whose end is exclusive.
struct NamedRange {
  std::string name;
  unsigned from = 0;
  unsigned to = 0;
};
/// Throws std::invalid_argument with a sentence.
NamedRange range_of(const std::string& text, const NamedNumbers& numbers);

/// Who wrote a file. Only restrip's has fans, and names of its tables are reserved for it.
enum class Author { user, restrip };

/// The sides of a description at one position. Throws files::FileError.
Sides read_sides(const JsonValue& description, const NamedNumbers& numbers, Author author);
/// The side after of a fan, which may depend on fewer numbers.
Side read_fan_after(const JsonValue& description, const NamedNumbers& numbers);

/// Reads sides given by triangles (docs/reference/operation-file.md, "Triangles"), which have indices in a family
/// ("Families"). Throws files::FileError if they are not an operation on a mesh.
Sides read_surface(const JsonValue& description, const NamedNumbers& numbers);

}  // namespace restrip::verify
