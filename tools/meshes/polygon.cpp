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
#include "meshes/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace restrip::tools {
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
