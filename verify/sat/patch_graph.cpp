#include "sat/patch_graph.hpp"

#include <fmt/format.h>

#include <sstream>
#include <utility>

#include "model/input.hpp"

namespace restrip::verify::sat {
namespace {

/// t_0 … t_{k-1}, with A and D before those named, in a row or a ring, and the chord when there are two of them.
PatchGraph fan(unsigned k, bool ring, const std::vector<unsigned>& insert_before) {
  PatchGraph graph;
  std::vector<unsigned> inserted;
  for (unsigned i = 0; i <= k; ++i) {
    for (const unsigned place : insert_before) {
      if (place != i) continue;
      inserted.push_back(graph.nodes++);
      graph.inserted.push_back(true);
    }
    if (i == k) break;
    graph.owner.push_back(graph.nodes++);
    graph.inserted.push_back(false);
  }
  for (unsigned node = 0; node + 1 < graph.nodes; ++node) graph.edges.push_back({node, node + 1});
  if (ring) graph.edges.push_back({graph.nodes - 1, 0});
  graph.has_chord = inserted.size() == 2;
  if (graph.has_chord) graph.edges.push_back({inserted[0], inserted[1]});
  return graph;
}

PatchGraph two_triangles(std::vector<unsigned> owner) { return {2, {{0, 1}}, std::move(owner), {false, false}, false}; }

/// The numbers of "k 5 gaps 1 3" without their names.
std::vector<unsigned> numbers_of(const std::string& position) {
  std::vector<unsigned> numbers;
  std::istringstream words(position);
  for (std::string word; words >> word;)
    if (word.find_first_not_of("0123456789") == std::string::npos)
      numbers.push_back(static_cast<unsigned>(std::stoul(word)));
  return numbers;
}

}  // namespace

Position position_of(const std::string& family, const std::string& position) {
  if (family == "flip") return {two_triangles({0, 0, 1, 1}), two_triangles({1, 0, 0, 1}), true};
  std::vector<unsigned> places = numbers_of(position);
  if (places.empty()) throw InputError(family, 0, fmt::format("no position \"{}\"", position));
  const unsigned k = places.front();
  places.erase(places.begin());
  const bool closed = family == "split" || family == "collapse";
  if (closed) places.insert(places.begin(), 0);  // A stands before t_0
  Position result{fan(k, closed, {}), fan(k, closed, places), false};
  if (family.ends_with("collapse"))
    std::swap(result.before, result.after);
  else if (!family.ends_with("split"))
    throw InputError(family, 0, "there is no such family");
  return result;
}

}  // namespace restrip::verify::sat
