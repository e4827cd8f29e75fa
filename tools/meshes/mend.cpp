#include "meshes/mend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "common/disjoint_sets.hpp"
#include "meshes/edges.hpp"
#include "meshes/soup.hpp"

namespace restrip::tools {
namespace {

/// The triangles to turn. Throws if the surface cannot be oriented.
std::vector<bool> to_be_turned(const Soup& soup, const std::string& name) {
  // Disjoint sets of triangles t as they are, and turned: t + triangles. What is in one set goes together.
  const auto triangles = static_cast<std::uint32_t>(soup.triangles.size());
  DisjointSets sets(2 * std::size_t{triangles});
  for_each_edge(soup, [&](std::span<const Side> edge) {
    if (edge.size() != 2) return;  // at an edge of three triangles, it is unknown which two belong together
    const std::uint32_t from = vertex_at(soup, edge[0].corner);
    const std::uint32_t one = edge[0].corner / 3;
    const std::uint32_t other = edge[1].corner / 3;
    const bool differ = from == vertex_at(soup, edge[1].corner);
    sets.unite(one, differ ? other + triangles : other);
    sets.unite(one + triangles, differ ? other : other + triangles);
    if (sets.find(one) == sets.find(one + triangles))
      throw BadInput(fmt::format(
          "{}: --orient: the surface of triangle {} (its edge from vertex {} to {}, counted from 0) has only one "
          "side, like a Moebius strip, and no orientation; leave the option out, or cut it there",
          name, other, std::min(from, vertex_at(soup, next_corner(edge[0].corner))), edge[0].high));
  });
  // A part of the surface is named by its first triangle, the smallest of its two sets.
  std::vector<std::uint32_t> all(triangles, 0);
  std::vector<std::uint32_t> turned(triangles, 0);
  for (std::uint32_t t = 0; t < triangles; ++t) {
    const std::uint32_t part = std::min(sets.find(t), sets.find(t + triangles));
    ++all[part];
    if (part != sets.find(t)) ++turned[part];
  }
  std::vector<bool> turn(triangles);
  for (std::uint32_t t = 0; t < triangles; ++t) {
    const std::uint32_t part = std::min(sets.find(t), sets.find(t + triangles));
    turn[t] = (part != sets.find(t)) == (2 * std::uint64_t{turned[part]} <= all[part]);
  }
  return turn;
}

/// The strips after these triangles have been turned.
std::vector<std::uint32_t> turned_strips(const Soup& soup, const std::vector<bool>& turn) {
  std::vector<std::uint32_t> made;
  const auto add = [&made](std::span<const std::uint32_t> strip) {
    if (!made.empty()) made.push_back(strip_end);
    made.insert(made.end(), strip.begin(), strip.end());
  };
  std::size_t triangle = 0;
  std::vector<Corners> drawn;
  std::vector<bool> over;
  for (auto from = soup.strips.begin(); from != soup.strips.end();) {
    const auto to = std::find(from, soup.strips.end(), strip_end);
    drawn.clear();
    over.clear();
    for (auto third = from + 2; third < to; ++third) {
      if (degenerate({third[-2], third[-1], third[0]})) continue;
      while (degenerate(soup.triangles[triangle])) ++triangle;
      drawn.push_back(soup.triangles[triangle]);
      over.push_back(turn[triangle++]);
    }
    const auto turned = static_cast<std::size_t>(std::count(over.begin(), over.end(), true));
    if (turned == 0) {
      add({from, to});
    } else if (turned == over.size()) {  // one more index in front turns the whole strip
      std::vector<std::uint32_t> longer{*from};
      longer.insert(longer.end(), from, to);
      add(longer);
    } else {
      for (std::size_t i = 0; i < drawn.size(); ++i) {
        if (over[i]) std::swap(drawn[i][1], drawn[i][2]);
        add(drawn[i]);
      }
    }
    from = to == soup.strips.end() ? to : to + 1;
  }
  return made;
}

/// Used vertices at the position of an earlier one that has the same value of each of these attributes.
std::size_t repeated(const Soup& soup, std::span<const Attribute> attributes) {
  std::vector<bool> used(soup.points.size(), false);
  for (const Corners& t : soup.triangles)
    for (const std::uint32_t corner : t) used[corner] = true;
  const std::vector<std::uint32_t> first = first_alike(used.size(), soup.points, attributes);
  std::vector<bool> taken(used.size(), false);
  std::size_t count = 0;
  for (std::uint32_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    if (taken[first[v]]) ++count;
    taken[first[v]] = true;
  }
  return count;
}

}  // namespace

Mended mend(Soup& soup, const std::string& name, const MendingOptions& options) {
  Mended mended{.asked = options, .left_out = soup.left_out};
  if (options.weld) weld(soup, mended);
  if (std::all_of(soup.triangles.begin(), soup.triangles.end(), degenerate))
    throw BadInput(fmt::format("{}: --weld leaves no triangle: each has two corners at one place", name));
  if (options.orient) orient(soup, name, mended);
  return mended;
}

void refuse_mending(const std::string& file, const MendingOptions& options) {
  if (options.weld || options.orient)
    throw BadInput(
        fmt::format("{}: a progressive mesh is taken as it is, so --weld and --orient do not apply; leave them out, or "
                    "give the mesh that it was made from",
                    file));
}

std::size_t merge_vertices(Soup& soup, std::vector<std::uint32_t> number, Mended& mended) {
  const std::vector<std::uint32_t> kept = renumber(number);
  const std::size_t merged = number.size() - kept.size();
  for (std::size_t i = 0; i < kept.size(); ++i) soup.points[i] = soup.points[kept[i]];
  soup.points.resize(kept.size());
  for (Attribute& attribute : soup.attributes) attribute = selected(attribute, kept);
  const auto vanished = std::remove_if(soup.triangles.begin(), soup.triangles.end(), [&](Corners& t) {
    const bool was = degenerate(t);
    for (std::uint32_t& corner : t) corner = number[corner];
    return !was && degenerate(t);
  });
  mended.vanished_triangles += static_cast<std::size_t>(soup.triangles.end() - vanished);
  soup.triangles.erase(vanished, soup.triangles.end());
  for (std::uint32_t& index : soup.strips)
    if (index != strip_end) index = number[index];
  return merged;
}

void weld(Soup& soup, Mended& mended) {
  mended.welded_vertices += merge_vertices(soup, first_alike(soup.points.size(), soup.points, soup.attributes), mended);
}

void orient(Soup& soup, const std::string& name, Mended& mended) {
  const std::vector<bool> turn = to_be_turned(soup, name);
  const auto turned = static_cast<std::size_t>(std::count(turn.begin(), turn.end(), true));
  if (turned == 0) return;
  if (!soup.strips.empty()) soup.strips = turned_strips(soup, turn);
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    if (turn[t]) std::swap(soup.triangles[t][1], soup.triangles[t][2]);
  mended.turned_triangles += turned;
}

std::size_t coincident_vertices(const Soup& soup) { return repeated(soup, soup.attributes); }

std::size_t vertices_at_seams(const Soup& soup) { return repeated(soup, {}) - repeated(soup, soup.attributes); }

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
