// Policy: the effort of a Keeper (keeper.hpp) after an operation to keep a colouring good. Each policy is one row of
// `policies`: its name on every command line and in every interface, and its steps for either kind of cost.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "restrip/fwd.hpp"
#include "restrip/search/impl/end_search.hpp"

namespace restrip {

/// The search from each strip end in a patch, under the cost of strips.
struct Search {
  std::uint32_t states = 0;  ///< state limit per search; 0 disables searching
  std::uint32_t enough = 0;  ///< triangles per strip: searches are smaller while strips are longer on average. 0: never
};

/// The search that follows an operation, under costs that weigh swaps or isolated triangles.
struct IndexPlan {
  /// Where the search begins.
  enum class From : std::uint8_t {
    ends,   ///< the strip ends among the triangles of the patch
    patch,  ///< all triangles of the patch
    ring    ///< the same and their neighbours
  };
  From from = From::patch;
  EndLimits limits{.looks = 0};  ///< 0 looks: no search; the cost is counted but not minimised
  std::uint32_t window = 0;      ///< triangles of a final window around the operation; 0: no window
};

/// The most that an operation adds to the cost, for every mesh, valence and history (docs/explanation/theory.md, "What
/// an operation adds"). Cost of strips: one strip. Cost of indices, 3 strips + swaps: this much under policies that
/// search; under `rules` about half the valence more.
inline constexpr int most_strips_added = 1;
inline constexpr int most_indices_added = 6;

/// Every operation begins with its rule, except under `bare`. The other columns say what follows it.
struct PolicyRow {
  Policy policy;
  const char* name;
  const char* description;  ///< what follows the rule, under the cost of strips
  const char* for_indices;  ///< the same under the cost of indices, after the choice between rule and previous colours
  const char* state;        ///< in addition to colours, under the cost of strips; none under the cost of indices
  const char* price;        ///< times the mesh update alone, under either cost, on meshes of some 50,000 triangles
  Search search;
  IndexPlan plan;
};

/// Each searches further than the one before it. Searches of n states keep about 3 n triangles per strip, if holes and
/// connected components of the mesh allow it. scripts/policies.py copies the table into the other interfaces.
inline constexpr std::array policies{
    PolicyRow{
        Policy::bare, "bare", "the mesh update alone, no rule; strips fall apart", "the same", "none", "1", {}, {}},
    PolicyRow{Policy::rules, "rules", "nothing", "nothing", "none", "2", {}, {}},
    PolicyRow{Policy::local,
              "local",
              "ends of strips that meet are joined",
              "4 looks at the strip ends of the patch",
              "none",
              "3 to 5",
              {},
              {IndexPlan::From::ends, {.looks = 4}}},
    PolicyRow{Policy::quick,
              "quick",
              "tunnelling",
              "12 looks, chains of 8 moves",
              "a locator of the strips",
              "10 to 30",
              {56, 150},
              {IndexPlan::From::patch, {.looks = 12, .length = EndSearch::max_length, .worse = 1}}},
    PolicyRow{Policy::full,
              "full",
              "tunnelling",
              "70 looks, around the patch as well",
              "a locator of the strips",
              "40 to 200",
              {320, 0},
              {IndexPlan::From::ring, {.looks = 70, .length = EndSearch::max_length, .worse = 2}}},
    PolicyRow{Policy::best,
              "best",
              "tunnelling",
              "the same, then a window of 40 triangles",
              "a locator of the strips",
              "300 to 600",
              {1024, 0},
              {IndexPlan::From::ring, {.looks = 70, .length = EndSearch::max_length, .worse = 2}, 40}}};

[[nodiscard]] constexpr const PolicyRow& row_of(Policy policy) noexcept {
  std::size_t i = 0;
  while (policies[i].policy != policy) ++i;
  return policies[i];
}

}  // namespace restrip
