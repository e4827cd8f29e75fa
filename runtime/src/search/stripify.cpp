// Strips from scratch.
//
// Outline. Under the cost of strips alone: greedy strips (greedy.cpp), then rounds of tunnelling (tunnel.cpp) until
// they are as few as the connected components or the limit is reached. Otherwise strips that grow one after the other
// (growing.cpp), or the ones just named if swaps cost nothing, and chains of moves at their ends (chain_search.cpp);
// then annealing (annealing.cpp) and longer chains, until no end has a chain that gains.
//
// Invariant. A step that ends with a higher cost than the step before it is undone, so no effort is worse than a lower
// one.
#include "restrip/search/stripify.hpp"

#include <algorithm>
#include <utility>

#include "restrip/mesh/walks.hpp"
#include "search/annealing.hpp"
#include "search/chain_search.hpp"
#include "search/greedy.hpp"
#include "search/poll.hpp"
#include "search/strip_locator.hpp"
#include "search/tunnel.hpp"

namespace restrip {

namespace detail {

void color_from_scratch(Annealing& annealing, Effort effort, Cost cost, std::uint64_t limit, Poll& poll) {
  const std::uint64_t triangles = annealing.triangle_count();
  ChainSearch chains(cost);
  if (cost.swap != 0) {
    annealing.grow();
    chains.run_everywhere(annealing.colors(), {.looks = 1, .length = 1}, poll);
  }
  if (effort == Effort::fast) return;
  annealing.keep();
  const auto take_the_cheapest = [&] {
    annealing.keep();
    annealing.go_back();
  };
  const auto make_chains = [&] {
    constexpr ChainLimits far{.looks = 70, .length = 16, .worse = 2};
    while (chains.run_everywhere(annealing.colors(), far, poll).price(cost) < 0 && effort == Effort::best &&
           !poll.stops()) {
    }
    take_the_cheapest();
  };
  // On regular meshes the strips of the first pass are hard to beat, so they are improved before they are forgotten.
  const std::uint64_t first = limit != 0 && effort == Effort::full ? limit : 100 * triangles;
  for (const auto& [moves, heat] : {std::pair{first / 5, 20U}, {first - first / 5, 100U}}) {
    annealing.cool(moves, heat, &poll);
    take_the_cheapest();
  }
  make_chains();
  if (effort == Effort::full) return;
  // Annealed strips are worse than the ones kept at times, but better after their chains. Small meshes take hardly any
  // time, so they are searched until luck does not matter.
  const std::uint64_t moves = limit != 0 ? limit : 900 * triangles;
  for (std::uint64_t done = 0; (done == 0 || (limit == 0 && done < 1'000'000)) && !poll.stops(); done += moves + 1) {
    for (const auto& [share, heat] : {std::pair{moves - moves / 9, 100U}, {moves / 9, 20U}}) {
      annealing.cool(share, heat, &poll);
      make_chains();
    }
  }
}

}  // namespace detail

std::size_t stripify(StripMesh& mesh, Effort effort, Cost cost, std::uint64_t limit, std::uint64_t seed,
                     const Interrupt& interrupt) {
  detail::Poll poll(interrupt);
  const std::uint64_t triangles = mesh.triangle_count();
  if (cost.swap == 0) {
    const std::size_t strips = stripify_fast(mesh);
    if (effort == Effort::fast) return strips;
    const bool strips_alone = cost.isolated == 0;
    StripLocator locator(mesh);
    Tunnel tunnel;
    TunnelRounds().run(mesh, locator, tunnel,
                       static_cast<std::size_t>(strips_alone && limit != 0 ? limit : 40 * triangles),
                       connected_components(mesh), {}, &poll);
    if (strips_alone) return locator.strips();
  }
  detail::Annealing annealing(detail::ColoringCopy(mesh), cost, seed);
  detail::color_from_scratch(annealing, effort, cost, limit, poll);
  annealing.give(mesh);
  return annealing.strips();
}

}  // namespace restrip
