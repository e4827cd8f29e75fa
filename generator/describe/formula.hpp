// The formulas in descriptions of families: sums of numbers, conditions, and triangles by name and index
// (docs/reference/operation-file.md, "Families").
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace restrip::generator {

/// The numbers of a position, the valence first; unused ones are 0.
using PositionNumbers = std::array<unsigned, 3>;

/// "2 a + k - 1": a factor for each number and a constant; and a factor for the index, if several triangles are meant.
struct Sum {
  std::array<int, 3> factors{};
  int of_index = 0;
  int constant = 0;
  [[nodiscard]] int at(const PositionNumbers& place, int index = 0) const;
};

struct Comparison {
  Sum left;
  std::string sign;  ///< "<", "<=", ">=" or "="
  Sum right;
};

/// All must hold.
using Conditions = std::vector<Comparison>;
[[nodiscard]] bool hold(const Conditions& conditions, const PositionNumbers& place);

inline constexpr std::size_t longest_word = 20;  ///< names of vertices, triangles and numbers

/// Triangles of a side: one by its name, or x_from … x_(to - 1).
struct Stretch {
  struct Range {
    Sum from;
    Sum to;
  };
  std::string name;
  std::optional<Range> range;
};

/// A vertex: "v", or "u[i+1]".
struct IndexedName {
  std::string name;
  std::optional<Sum> index;
};

/// These throw std::runtime_error with what was expected, and where in the text.
[[nodiscard]] Conditions parse_conditions(std::string_view text, const std::vector<std::string>& numbers);
[[nodiscard]] Stretch parse_stretch(std::string_view text, const std::vector<std::string>& numbers);
/// `index` is the name of an index, or empty.
[[nodiscard]] IndexedName parse_vertex(std::string_view text, const std::vector<std::string>& numbers,
                                       const std::string& index);

}  // namespace restrip::generator
