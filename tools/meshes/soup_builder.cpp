#include "meshes/soup_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/counted.hpp"

namespace restrip::tools {

void refuse_long_lines(std::string_view text, const std::string& name) {
  for (std::size_t line = 1; text.size() > longest_line; ++line) {
    const std::size_t stop = std::min(text.find_first_of("\n\r"), text.size());
    if (stop > longest_line)
      throw BadInput(fmt::format("{}:{}: a line of more than {}, the limit; write a line for each vertex and face",
                                 name, line, size_in_words(longest_line)));
    text.remove_prefix(stop + 1);
  }
}

void SoupBuilder::refuse(const std::string& why) const { throw BadInput(fmt::format("{}: {}", name_, why)); }

void SoupBuilder::add_point(double x, double y, double z, std::size_t line) {
  if (soup_.points.size() == max_vertices) refuse(fmt::format("more than {} vertices", max_vertices));
  Point point{x, y, z};
  if (!is_finite(in_32_bits(point))) {
    lost_points_.push_back({soup_.points.size(), line});
    point = {};
  }
  soup_.points.push_back(point);
}

Attribute::Value SoupBuilder::usable(const Attribute::Value& value, std::size_t vertex, const std::string& attribute) {
  if (is_finite(value)) return value;
  doubts_[attribute].push_back(vertex);
  return neutral_value(attribute);
}

void SoupBuilder::leave_out(const std::string& part) {
  constexpr std::size_t most_names = 64;
  note(soup_.left_out, soup_.left_out.size() < most_names ? part : "more parts of other kinds");
}

void SoupBuilder::settle_doubts() {
  if (doubts_.empty() && lost_points_.empty()) return;
  std::vector<bool> used(soup_.points.size(), false);
  for (const Corners& triangle : soup_.triangles)
    for (const std::uint32_t corner : triangle) used[corner] = true;
  const auto is_used = [&used](std::size_t vertex) { return used[vertex]; };
  const auto unused = [](std::size_t count) {
    return fmt::format("infinite or not a number, of {} in no triangle", counted(count, "vertex", "vertices"));
  };
  const auto lost = std::find_if(lost_points_.begin(), lost_points_.end(),
                                 [&used](const LostPoint& point) { return used[point.vertex]; });
  if (lost != lost_points_.end())
    throw BadInput(fmt::format("{}{}: vertex {} has a coordinate that is infinite or not a number; mend or remove it",
                               name_, lost->line == 0 ? "" : fmt::format(":{}", lost->line), lost->vertex));
  if (!lost_points_.empty()) leave_out("a coordinate that is " + unused(lost_points_.size()));
  for (const auto& [attribute, vertices] : doubts_) {
    const auto found = std::find_if(vertices.begin(), vertices.end(), is_used);
    if (found == vertices.end()) {
      leave_out(attribute + " that are " + unused(vertices.size()));
      continue;
    }
    leave_out(fmt::format("{} (infinite or not a number at vertex {})", attribute, *found));
    std::erase_if(soup_.attributes, [&name = attribute](const Attribute& one) { return one.name == name; });
  }
}

void SoupBuilder::add_face(std::span<const std::uint32_t> corners) {
  if (corners.size() < 3) {
    ++soup_.stubs;
    return;
  }
  const std::size_t first = soup_.triangles.size();
  for (std::size_t i = 2; i < corners.size(); ++i) add_triangle({corners[0], corners[i - 1], corners[i]});
  if (corners.size() == 3) return;
  ++soup_.polygons;
  polygons_.push_back({first, soup_.triangles.size(), 0});
}

void SoupBuilder::add_triangle(const Corners& corners) {
  if (soup_.triangles.size() == max_triangles)
    refuse(fmt::format("more than {} triangles; cut the mesh in pieces", max_triangles));
  soup_.triangles.push_back(corners);
}

void SoupBuilder::add_strip(std::span<const std::uint32_t> indices) {
  const std::size_t first = soup_.triangles.size();
  for (std::size_t i = 2; i < indices.size(); ++i) {
    const std::uint32_t third = indices[i];
    const Corners corners =
        i % 2 == 0 ? Corners{indices[i - 2], indices[i - 1], third} : Corners{indices[i - 1], indices[i - 2], third};
    if (!degenerate(corners)) add_triangle(corners);
  }
  if (soup_.triangles.size() == first) return;
  strip_runs_.push_back({first, soup_.triangles.size(), strips_.size()});
  strips_.insert(strips_.end(), indices.begin(), indices.end());
}

void SoupBuilder::cut_polygons() {
  PolygonCutter cutter(soup_.points);
  for (const Run& polygon : polygons_)
    if (!cutter.cut(std::span(soup_.triangles).subspan(polygon.first, polygon.end - polygon.first)))
      refuse(fmt::format("its polygons take too long to be cut into triangles (at one of {} corners); cut them before",
                         polygon.end - polygon.first + 2));
}

std::vector<std::uint32_t> SoupBuilder::all_strips() const {
  std::vector<std::uint32_t> made;
  if (strip_runs_.empty()) return made;
  made.reserve(strips_.size() + strip_runs_.size());
  const auto add = [&made](auto begin, auto end) {
    if (!made.empty()) made.push_back(strip_end);
    made.insert(made.end(), begin, end);
  };
  std::size_t t = 0;
  const auto add_triangles_to = [&](std::size_t end) {
    for (; t < end; ++t)
      if (!degenerate(soup_.triangles[t])) add(soup_.triangles[t].begin(), soup_.triangles[t].end());
  };
  for (std::size_t i = 0; i < strip_runs_.size(); ++i) {
    const Run& run = strip_runs_[i];
    const std::size_t end = i + 1 < strip_runs_.size() ? strip_runs_[i + 1].index : strips_.size();
    add_triangles_to(run.first);
    add(strips_.begin() + static_cast<std::ptrdiff_t>(run.index), strips_.begin() + static_cast<std::ptrdiff_t>(end));
    t = run.end;
  }
  add_triangles_to(soup_.triangles.size());
  return made;
}

Soup SoupBuilder::finish() && {
  const std::string others =
      soup_.left_out.empty() ? "" : fmt::format(" (left out: {})", left_out_in_words(soup_.left_out));
  if (soup_.points.empty())
    refuse("no vertices" + others + "; is the file empty, or of another format than its name says?");
  if (soup_.triangles.empty())
    refuse(fmt::format("{} but no triangles{}; strips need faces, not points or lines",
                       counted(soup_.points.size(), "vertex", "vertices"), others));
  const auto check = [this](std::uint32_t corner) {
    if (corner >= soup_.points.size())
      refuse(fmt::format("a face refers to vertex {} (counted from 0), but there are {}; is the file complete?", corner,
                         soup_.points.size()));
  };
  for (const Corners& triangle : soup_.triangles)
    for (const std::uint32_t corner : triangle) check(corner);
  for (const std::uint32_t index : strips_) check(index);
  settle_doubts();
  cut_polygons();
  soup_.strips = all_strips();
  if (std::all_of(soup_.triangles.begin(), soup_.triangles.end(), degenerate))
    refuse(fmt::format("{}, each with a corner twice; strips need triangles with three different corners",
                       counted(soup_.triangles.size(), "triangle")));
  return std::move(soup_);
}

// Ear cutting (Meisters 1975): a corner is an ear if the triangle with its two neighbours contains no other corner. An
// ear is cut off until three corners are left. A simple polygon always has two ears, also with corners on straight
// lines, because some triangulation uses all of them (its dual tree has two leaves).
//
// - Only corners that are not convex can lie in an ear. They are sorted by x, so that an ear is compared with those in
//   its range of x. Corners only become convex as others are cut.
// - A corner at the place of a corner of the ear does not block it: outlines of holes are joined to the outer one by an
//   edge that is passed twice. If its edges reach into the ear, another corner lies inside.
// - If no ear is found, the outline touches or crosses itself, or all that is left lies on a line: a corner without
//   area is cut, otherwise any convex corner.

namespace {

/// A polygon of a map with 50,000 corners needs a hundredth of this.
constexpr std::uint64_t most_tests = 1'000'000'000;

}  // namespace

bool PolygonCutter::flatten() {
  // Newell's normal; relative to the first corner, so that distant polygons keep their digits.
  Point normal;
  const Point& origin = points_[vertices_[0]];
  const auto relative = [&](std::uint32_t vertex) {
    const Point& p = points_[vertex];
    return Point{p.x - origin.x, p.y - origin.y, p.z - origin.z};
  };
  Point p = relative(vertices_.back());
  for (const std::uint32_t vertex : vertices_) {
    const Point q = relative(vertex);
    normal.x += p.y * q.z - p.z * q.y;
    normal.y += p.z * q.x - p.x * q.z;
    normal.z += p.x * q.y - p.y * q.x;
    p = q;
  }
  const double x = std::abs(normal.x);
  const double y = std::abs(normal.y);
  const double z = std::abs(normal.z);
  const double largest = std::max({x, y, z});
  if (!(largest > 0) || !std::isfinite(largest)) return false;
  flat_.clear();
  for (const std::uint32_t vertex : vertices_) {
    const Point q = relative(vertex);
    Flat flat = z == largest ? Flat{q.x, q.y} : y == largest ? Flat{q.z, q.x} : Flat{q.y, q.z};
    if ((z == largest ? normal.z : y == largest ? normal.y : normal.x) < 0) std::swap(flat.x, flat.y);
    flat_.push_back(flat);
  }
  return true;
}

double PolygonCutter::turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  return (flat_[b].x - flat_[a].x) * (flat_[c].y - flat_[a].y) - (flat_[b].y - flat_[a].y) * (flat_[c].x - flat_[a].x);
}

bool PolygonCutter::is_convex_fan() const {
  const auto size = static_cast<std::uint32_t>(flat_.size());
  for (std::uint32_t i = 0; i < size; ++i)
    if (turn(before_[i], i, after_[i]) < 0) return false;
  for (std::uint32_t i = 2; i < size; ++i)
    if (!(turn(0, i - 1, i) > 0)) return false;
  return true;
}

bool PolygonCutter::is_ear(std::uint32_t b) {
  const std::uint32_t a = before_[b];
  const std::uint32_t c = after_[b];
  if (!(turn(a, b, c) > 0)) return false;
  const auto [left, right] = std::minmax({flat_[a].x, flat_[b].x, flat_[c].x});
  const auto same = [this](std::uint32_t one, std::uint32_t other) {
    return flat_[one].x == flat_[other].x && flat_[one].y == flat_[other].y;
  };
  auto at = std::lower_bound(reflex_.begin(), reflex_.end(), left,
                             [this](std::uint32_t corner, double x) { return flat_[corner].x < x; });
  for (; at != reflex_.end() && flat_[*at].x <= right; ++at) {
    ++tests_;
    const std::uint32_t p = *at;
    if (p == a || p == b || p == c || after_[p] == p) continue;  // of the ear, or cut
    if (turn(a, b, p) < 0 || turn(b, c, p) < 0 || turn(c, a, p) < 0) continue;
    if (!same(p, a) && !same(p, b) && !same(p, c) && may_block(p)) return false;
  }
  return true;
}

bool PolygonCutter::cut(std::span<Corners> fan) {
  vertices_.assign({fan[0][0], fan[0][1]});
  for (const Corners& triangle : fan) vertices_.push_back(triangle[2]);
  if (!flatten()) return true;  // any triangles will do
  const auto size = static_cast<std::uint32_t>(vertices_.size());
  before_.resize(size);
  after_.resize(size);
  for (std::uint32_t i = 0; i < size; ++i) {
    before_[i] = i == 0 ? size - 1 : i - 1;
    after_[i] = i + 1 == size ? 0 : i + 1;
  }
  if (is_convex_fan()) return true;
  reflex_.clear();
  for (std::uint32_t i = 0; i < size; ++i)
    if (may_block(i)) reflex_.push_back(i);
  std::sort(reflex_.begin(), reflex_.end(),
            [this](std::uint32_t i, std::uint32_t j) { return flat_[i].x < flat_[j].x; });

  // `refused`: corners in succession that were not cut; after a whole round the demands fall by a step.
  enum class Demand { ear, flat, convex, none } demand = Demand::ear;
  std::vector<Corners> made;
  made.reserve(fan.size());
  std::uint32_t b = 0;
  for (std::uint32_t left = size, refused = 0; left > 2;) {
    if (tests_ > most_tests) return false;
    const std::uint32_t a = before_[b];
    const std::uint32_t c = after_[b];
    ++tests_;
    const bool granted = demand == Demand::ear      ? is_ear(b)
                         : demand == Demand::flat   ? turn(a, b, c) == 0
                         : demand == Demand::convex ? turn(a, b, c) > 0
                                                    : true;
    if (!granted) {
      b = c;
      if (++refused < left) continue;
      demand = Demand{static_cast<int>(demand) + 1};
      refused = 0;
      continue;
    }
    made.push_back({vertices_[a], vertices_[b], vertices_[c]});
    after_[a] = c;
    before_[c] = a;
    after_[b] = b;
    --left;
    refused = 0;
    demand = Demand::ear;
    b = after_[c];  // ears next to each other would become slivers
  }
  std::copy(made.begin(), made.end(), fan.begin());
  return true;
}

}  // namespace restrip::tools
