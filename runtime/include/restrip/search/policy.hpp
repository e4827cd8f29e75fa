// Policy: the effort of a Keeper (keeper.hpp) after an operation to keep a colouring good. Each policy is one row of
// `policies`: its name on every command line and in every interface, and its steps for either kind of cost.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "restrip/fwd.hpp"

namespace restrip {

/// The search from each strip end in a patch, under the cost of strips.
struct Search {
  std::uint32_t states = 0;  ///< state limit per search; 0 disables searching
  std::uint32_t enough = 0;  ///< triangles per strip: searches are smaller while strips are longer on average. 0: never
};

/// A search by chains of moves at strip ends, under costs that weigh swaps or isolated triangles. Each move of a chain
/// joins two strips or moves a strip end; the first may also cut a strip at a swap. A chain is made if it lowers the
/// cost.
struct ChainLimits {
  std::uint32_t looks = (std::numeric_limits<std::uint32_t>::max)();  ///< ends examined, with up to three dashed edges
  std::uint32_t length = 1;                                           ///< moves of a chain
  std::int32_t worse = 0;                                             ///< the highest rise of the cost within a chain
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
  ChainLimits limits{.looks = 0};  ///< 0 looks: no search; the cost is counted but not minimised
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
    PolicyRow{Policy::rules, "rules", "nothing", "nothing", "none", "1.9 to 2.4", {}, {}},
    PolicyRow{Policy::local,
              "local",
              "ends of strips that meet are joined",
              "3 looks at the strip ends of the patch",
              "none",
              "2.6 to 7.3",
              {},
              {IndexPlan::From::ends, {.looks = 3, .length = 3}}},
    PolicyRow{Policy::quick,
              "quick",
              "tunnelling",
              "10 looks, chains of 8 moves",
              "a locator of the strips",
              "15 to 61",
              {56, 150},
              {IndexPlan::From::patch, {.looks = 10, .length = 8, .worse = 1}}},
    PolicyRow{Policy::full,
              "full",
              "tunnelling",
              "70 looks, around the patch as well",
              "a locator of the strips",
              "49 to 290",
              {320, 0},
              {IndexPlan::From::ring, {.looks = 70, .length = 8, .worse = 2}}}};

[[nodiscard]] constexpr const PolicyRow& row_of(Policy policy) noexcept {
  std::size_t i = 0;
  while (policies[i].policy != policy) ++i;
  return policies[i];
}

}  // namespace restrip
