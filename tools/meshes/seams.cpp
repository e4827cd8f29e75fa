#include "meshes/seams.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "common/disjoint_sets.hpp"
#include "meshes/edges.hpp"
#include "meshes/positions.hpp"

namespace restrip::tools {
namespace {

constexpr std::uint32_t no_vertex = 0xFFFF'FFFF;

double distance_of(const Point& a, const Point& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }

/// The places of vertices that are at borders, and by place the length of the shortest border there.
struct Borders {
  DisjointSets place;
  std::vector<bool> at_border;
  std::vector<double> shortest;
};

/// Places at exactly the same point.
Borders borders_of(const Soup& soup) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const std::size_t n = soup.points.size();
  Borders borders{DisjointSets(n), std::vector<bool>(n, false), std::vector<double>(n, infinite)};
  const std::vector<std::uint32_t> first = first_alike(n, soup.points);
  for (std::uint32_t v = 0; v < n; ++v) borders.place.unite(v, first[v]);
  for_each_edge(soup, [&](std::span<const Side> edge) {
    if (edge.size() != 1) return;
    const std::uint32_t from = vertex_at(soup, edge[0].corner);
    const std::uint32_t to = vertex_at(soup, next_corner(edge[0].corner));
    const double length = distance_of(soup.points[from], soup.points[to]);
    for (const std::uint32_t place : {first[from], first[to]}) {
      borders.at_border[place] = true;
      if (length > 0) borders.shortest[place] = std::min(borders.shortest[place], length);
    }
  });
  return borders;
}

/// Unites places that differ by rounding. A grid of cells of that size finds them; of a crowded cell only a few are
/// compared.
void unite_near_places(const Soup& soup, Borders& borders) {
  Point low{};
  Point high{};
  for (const Point& p : soup.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const double cell = 1e-6 * std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  if (!(cell > 0) || !std::isfinite(cell)) return;
  using Cell = std::array<std::int64_t, 3>;
  struct Entry {
    Cell cell{};
    std::uint32_t vertex = 0;
  };
  const auto index = [cell](double x) { return static_cast<std::int64_t>(std::floor(x / cell)); };
  std::vector<Entry> entries;
  for (std::uint32_t v = 0; v < soup.points.size(); ++v) {
    if (!borders.at_border[v]) continue;
    const Point& p = soup.points[v];
    entries.push_back({{index(p.x - low.x), index(p.y - low.y), index(p.z - low.z)}, v});
  }
  const auto before = [](const Entry& a, const Entry& b) {
    return a.cell != b.cell ? a.cell < b.cell : a.vertex < b.vertex;
  };
  std::sort(entries.begin(), entries.end(), before);
  constexpr std::ptrdiff_t few = 8;
  for (const Entry& entry : entries)
    for (int around = 0; around < 27; ++around) {
      const Cell there{entry.cell[0] + around % 3 - 1, entry.cell[1] + around / 3 % 3 - 1,
                       entry.cell[2] + around / 9 - 1};
      auto other = std::lower_bound(entries.begin(), entries.end(), Entry{there, 0}, before);
      for (std::ptrdiff_t i = 0; i < few && other != entries.end() && other->cell == there; ++i, ++other) {
        const double shortest = std::min(borders.shortest[entry.vertex], borders.shortest[other->vertex]);
        if (distance_of(soup.points[entry.vertex], soup.points[other->vertex]) <= std::min(cell, shortest / 1000))
          borders.place.unite(entry.vertex, other->vertex);
      }
    }
}

/// A side of a triangle by the places of its ends, the smaller one first.
struct PlacedSide {
  std::uint32_t low;
  std::uint32_t high;
  std::uint32_t corner;
  bool is_border;
};

}  // namespace

std::vector<std::uint32_t> first_across_seams(const Soup& soup) {
  Borders borders = borders_of(soup);
  unite_near_places(soup, borders);
  std::vector<bool> near_border(soup.points.size(), false);
  for (std::uint32_t v = 0; v < soup.points.size(); ++v)
    if (borders.at_border[v]) near_border[borders.place.find(v)] = true;
  const auto place = [&](std::uint32_t corner) { return borders.place.find(vertex_at(soup, corner)); };
  std::vector<PlacedSide> sides;
  for_each_edge(soup, [&](std::span<const Side> edge) {
    const std::uint32_t from = place(edge[0].corner);
    const std::uint32_t to = place(next_corner(edge[0].corner));
    if (!near_border[from] || !near_border[to]) return;
    for (const Side& side : edge)
      sides.push_back({std::min(from, to), std::max(from, to), side.corner, edge.size() == 1});
  });
  std::sort(sides.begin(), sides.end(), [](const PlacedSide& a, const PlacedSide& b) {
    return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.corner < b.corner;
  });

  DisjointSets vertices(soup.points.size());
  for (auto begin = sides.begin(); begin != sides.end();) {
    const auto end = std::find_if(
        begin, sides.end(), [&](const PlacedSide& side) { return side.low != begin->low || side.high != begin->high; });
    const std::span<const PlacedSide> edge(begin, end);
    begin = end;
    if (std::none_of(edge.begin(), edge.end(), [](const PlacedSide& side) { return side.is_border; })) continue;
    const auto third = [&](const PlacedSide& side) { return place(next_corner(next_corner(side.corner))); };
    const bool back_to_back = edge.size() == 2 && edge[0].low != edge[0].high && third(edge[0]) == third(edge[1]);
    if (back_to_back) continue;
    std::array<std::uint32_t, 2> ends{no_vertex, no_vertex};  // a vertex at `low`, and one at `high`
    for (const PlacedSide& side : edge)
      for (const std::uint32_t corner : {side.corner, next_corner(side.corner)}) {
        std::uint32_t& one = ends[place(corner) == side.low ? 0 : 1];
        if (one == no_vertex) one = vertex_at(soup, corner);
        vertices.unite(one, vertex_at(soup, corner));
      }
  }
  std::vector<std::uint32_t> first(soup.points.size());
  for (std::uint32_t v = 0; v < first.size(); ++v) first[v] = vertices.find(v);
  return first;
}

std::vector<std::uint32_t> vertices_on_seams(const Soup& soup) {
  const std::vector<std::uint32_t> first = first_across_seams(soup);
  std::vector<bool> on_seam(first.size(), false);
  for (std::uint32_t v = 0; v < first.size(); ++v)
    if (first[v] != v) on_seam[v] = on_seam[first[v]] = true;
  std::vector<std::uint32_t> found;
  for (std::uint32_t v = 0; v < first.size(); ++v)
    if (on_seam[v]) found.push_back(v);
  return found;
}

void close_seams(Soup& soup, Mended& mended) {
  mended.closed_seams += merge_vertices(soup, first_across_seams(soup), mended);
}

}  // namespace restrip::tools
