// Policy: how far a Keeper (keeper.hpp) looks after an operation to keep a colouring good. One row of `policies` says
// all there is about each: its name on every command line and in every interface, and what it does for either kind of
// cost.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "restrip/search/end_search.hpp"

namespace restrip {

/// Each looks further than the one before it.
enum class Policy : std::uint8_t { bare, rules, local, linked, quick, full, best };

/// The search from each strip end in a patch, where the cost is that of strips.
struct Search {
  std::uint32_t states = 0;  ///< state limit per search; 0 disables searching
  std::uint32_t enough = 0;  ///< triangles per strip: searches get smaller while strips are longer on average. 0: never
};

/// The search that follows an operation, where swaps or isolated triangles cost something.
struct IndexPlan {
  /// Where the search begins.
  enum class From : std::uint8_t {
    joints,  ///< where strips do not go on: new triangles of a split, those that a collapse joins, the two of a flip
    patch,   ///< all triangles of the patch
    ring     ///< the same and their neighbours
  };
  From from = From::patch;
  EndLimits limits{.looks = 0};  ///< without looks there is no search, and the cost is counted but not kept low
  std::uint32_t window = 0;      ///< triangles of an exact window that is laid around the operation last; 0: none
};

struct PolicyRow {
  Policy policy;
  const char* name;
  const char* says;  ///< what it does, where the cost is that of strips
  Search search;
  IndexPlan plan;
};

/// Searches of n states keep about 3 n triangles per strip, where holes and connected components of the mesh allow it.
inline constexpr std::array policies{
    PolicyRow{Policy::bare, "bare", "the mesh update alone; strips fall apart", {}, {}},
    PolicyRow{Policy::rules, "rules", "the rules of the tables, and nothing else", {}, {}},
    PolicyRow{Policy::local,
              "local",
              "the rules, then ends of strips that meet are joined",
              {},
              {IndexPlan::From::joints, {.looks = 4}}},
    PolicyRow{Policy::linked,
              "linked",
              "rules that follow the strips around the patch, then joins and exchanges",
              {},
              {IndexPlan::From::patch, {.looks = 5, .length = 2}}},
    PolicyRow{Policy::quick,
              "quick",
              "the rules, then tunnelling",
              {56, 150},
              {IndexPlan::From::patch, {.looks = 12, .length = EndSearch::max_length, .worse = 1}}},
    PolicyRow{Policy::full,
              "full",
              "the rules, then tunnelling",
              {320, 0},
              {IndexPlan::From::ring, {.looks = 70, .length = EndSearch::max_length, .worse = 2}}},
    PolicyRow{Policy::best,
              "best",
              "the rules, then tunnelling",
              {1024, 0},
              {IndexPlan::From::ring, {.looks = 70, .length = EndSearch::max_length, .worse = 2}, 40}}};

[[nodiscard]] constexpr const PolicyRow& row_of(Policy policy) noexcept {
  return policies[static_cast<std::size_t>(policy)];
}
/// Null when there is none of that name.
[[nodiscard]] constexpr const PolicyRow* policy_named(std::string_view name) noexcept {
  for (const PolicyRow& row : policies)
    if (name == row.name) return &row;
  return nullptr;
}
static_assert([] {
  for (std::size_t i = 0; i < policies.size(); ++i)
    if (policies[i].policy != static_cast<Policy>(i)) return false;
  return true;
}());

}  // namespace restrip
