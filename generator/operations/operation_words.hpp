// The words of operation files for what operation.hpp knows.
#pragma once

#include <array>
#include <span>
#include <string>

#include "operations/operation.hpp"

namespace restrip::generator {

/// By the most solid edges of a triangle, from one.
inline constexpr std::array<const char*, 3> constraint_words{"matching", "strips", "forest"};

/// What a count can be told to choose among.
enum class Among { nothing, edges, triangles, ports };

struct CountWord {
  const char* word;
  Count count;
  Among among;
};

/// Every count that a file can name.
[[nodiscard]] std::span<const CountWord> count_words();

/// std::logic_error for a count that files do not have.
[[nodiscard]] const CountWord& word_of(Count count);

/// The member that chooses: "edges", "triangles", "ports"; and what one of them is called.
[[nodiscard]] std::string member_of(Among among);
[[nodiscard]] std::string one_of(Among among);

/// How many there are to choose among, and all of them as a mask.
[[nodiscard]] std::size_t how_many(Among among, const Side& after);
[[nodiscard]] Mask everything(Among among, const Side& after);

}  // namespace restrip::generator
