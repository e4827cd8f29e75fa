#include "judge/isomorphism.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace restrip::verify {
namespace {

constexpr unsigned nowhere = 0xffffffff;

/// One connected component after the other, those with fixed nodes first. What a component is taken to does not matter
/// to the others: it leaves components of the same kinds over. So only within a component choices are taken back.
class IsomorphismSearch {
 public:
  IsomorphismSearch(const ColoredGraph& from, const ColoredGraph& to)
      : from_(from), to_(to), image_(from.size(), nowhere), used_(to.size()) {}

  std::optional<Permutation> found(const Permutation& fixed) {
    for (unsigned node = 0; node < fixed.size(); ++node)
      if (!assign(node, fixed[node])) return {};
    for (unsigned node = 0; node < from_.size(); ++node) {
      if (node >= fixed.size() && image_[node] != nowhere) continue;
      const std::vector<unsigned> rest = rest_of_component(node);
      if (!extend(rest, 0)) return {};
    }
    return image_;
  }

 private:
  bool assign(unsigned node, unsigned image) {
    if (image >= to_.size() || used_[image] || from_.color(node) != to_.color(image)) return false;
    for (unsigned other = 0; other < from_.size(); ++other)
      if (image_[other] != nowhere && from_.edge(node, other) != to_.edge(image, image_[other])) return false;
    image_[node] = image;
    used_[image] = true;
    return true;
  }
  void take_back(unsigned node) {
    used_[image_[node]] = false;
    image_[node] = nowhere;
  }

  /// The nodes of its component that are still to be assigned, each beside one before it or beside an assigned one; a
  /// component without any assigned node begins with `node`.
  std::vector<unsigned> rest_of_component(unsigned node) const {
    std::vector<bool> seen(from_.size());
    std::vector<unsigned> all = {node};
    seen[node] = true;
    for (std::size_t i = 0; i < all.size(); ++i)
      for (unsigned next = 0; next < from_.size(); ++next)
        if (!seen[next] && from_.edge(all[i], next) != 0) {
          seen[next] = true;
          all.push_back(next);
        }
    std::vector<unsigned> rest;
    for (const unsigned member : all)
      if (image_[member] == nowhere) rest.push_back(member);
    return rest;
  }

  bool extend(const std::vector<unsigned>& rest, std::size_t next) {
    if (next == rest.size()) return true;
    for (unsigned image = 0; image < to_.size(); ++image) {
      if (!assign(rest[next], image)) continue;
      if (extend(rest, next + 1)) return true;
      take_back(rest[next]);
    }
    return false;
  }

  const ColoredGraph& from_;
  const ColoredGraph& to_;
  Permutation image_;
  std::vector<bool> used_;
};

/// A node's colour, and in order the colours of its edges with those of the nodes behind them.
using Surroundings = std::pair<unsigned, std::vector<std::pair<unsigned, unsigned>>>;

Surroundings surroundings(const ColoredGraph& graph, unsigned node) {
  Surroundings found{graph.color(node), {}};
  for (unsigned other = 0; other < graph.size(); ++other)
    if (const unsigned edge = graph.edge(node, other); edge != 0) found.second.emplace_back(edge, graph.color(other));
  std::sort(found.second.begin(), found.second.end());
  return found;
}

std::size_t color_count(const ColoredGraph& graph) {
  std::set<unsigned> colors;
  for (unsigned node = 0; node < graph.size(); ++node) colors.insert(graph.color(node));
  return colors.size();
}

/// Gives nodes of both graphs new colours, the same where their surroundings are the same, as long as that helps.
void refine(ColoredGraph& one, ColoredGraph& other) {
  for (std::size_t before = 0, now = color_count(one); now != before;) {
    std::map<Surroundings, unsigned> numbers;
    std::vector<std::pair<ColoredGraph*, std::vector<unsigned>>> colors = {{&one, {}}, {&other, {}}};
    for (auto& [graph, numbered] : colors)
      for (unsigned node = 0; node < graph->size(); ++node)
        numbered.push_back(
            numbers.try_emplace(surroundings(*graph, node), static_cast<unsigned>(numbers.size())).first->second);
    for (auto& [graph, numbered] : colors)
      for (unsigned node = 0; node < graph->size(); ++node) graph->set_color(node, numbered[node]);
    before = std::exchange(now, color_count(one));
  }
}

}  // namespace

void ColoredGraph::add_node(unsigned color) {
  colors_.push_back(color);
  for (std::vector<unsigned>& row : edges_) row.push_back(0);
  edges_.emplace_back(colors_.size());
}

void ColoredGraph::add_edge(unsigned one, unsigned other, unsigned color) {
  edges_[one][other] = edges_[other][one] = color;
}

std::vector<unsigned> refined_colors(const ColoredGraph& graph) {
  ColoredGraph one = graph;
  ColoredGraph other = graph;
  refine(one, other);
  std::vector<unsigned> colors;
  for (unsigned node = 0; node < one.size(); ++node) colors.push_back(one.color(node));
  return colors;
}

std::optional<Permutation> isomorphism(const ColoredGraph& from, const ColoredGraph& to, const Permutation& fixed) {
  ColoredGraph one = from;
  ColoredGraph other = to;
  if (one.size() != other.size()) return {};
  for (unsigned node = 0; node < fixed.size(); ++node) {  // colours of their own, the same at both places
    if (fixed[node] >= other.size() || from.color(node) != to.color(fixed[node])) return {};
    one.set_color(node, nowhere - 1 - node);
    other.set_color(fixed[node], nowhere - 1 - node);
  }
  refine(one, other);
  return IsomorphismSearch(one, other).found(fixed);
}

}  // namespace restrip::verify
