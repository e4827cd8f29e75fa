// Distances between two surfaces of triangles, sampled evenly by area: from each sample of one to the nearest point of
// the other. The nearest triangle is found by a tree of boxes, halved at the median of the longest side, in O(log T) a
// sample on ordinary surfaces. Samples depend only on the surface.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <span>
#include <utility>
#include <vector>

namespace restrip::bench {

using Place = std::array<double, 3>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

inline Place operator-(const Place& a, const Place& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Place operator+(const Place& a, const Place& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Place operator*(double s, const Place& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Place& a, const Place& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline double length(const Place& a) { return std::sqrt(dot(a, a)); }

/// Squared, from p to a triangle: by the region of its plane in which p lies (Ericson, "Real-Time Collision Detection",
/// section 5.1.5).
inline double squared_distance(const Place& p, const Place& a, const Place& b, const Place& c) {
  const Place ab = b - a;
  const Place ac = c - a;
  const auto at = [&](double u, double v) {
    const Place way = a + u * ab + v * ac - p;
    return dot(way, way);
  };
  const double d1 = dot(ab, p - a);
  const double d2 = dot(ac, p - a);
  if (d1 <= 0 && d2 <= 0) return at(0, 0);
  const double d3 = dot(ab, p - b);
  const double d4 = dot(ac, p - b);
  if (d3 >= 0 && d4 <= d3) return at(1, 0);
  const double d5 = dot(ab, p - c);
  const double d6 = dot(ac, p - c);
  if (d6 >= 0 && d5 <= d6) return at(0, 1);
  const double at_c = d1 * d4 - d3 * d2;
  if (at_c <= 0 && d1 >= 0 && d3 <= 0) return at(d1 / (d1 - d3), 0);
  const double at_b = d5 * d2 - d1 * d6;
  if (at_b <= 0 && d2 >= 0 && d6 <= 0) return at(0, d2 / (d2 - d6));
  const double at_a = d3 * d6 - d5 * d4;
  if (at_a <= 0 && d4 >= d3 && d5 >= d6) {
    const double share = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return at(1 - share, share);
  }
  const double sum = at_a + at_b + at_c;
  return at(at_b / sum, at_c / sum);
}

class Surface {
 public:
  struct Sample {
    Place point;
    Place normal;
  };
  struct Nearest {
    double squared = std::numeric_limits<double>::infinity();
    std::uint32_t triangle = 0;
  };

  Surface(std::span<const Place> points, Triangles triangles)
      : points_(points), triangles_(std::move(triangles)), order_(triangles_.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    add_box(0, order_.size());
  }

  /// Stratified: one in each of `count` equal parts of the area, triangle after triangle.
  [[nodiscard]] std::vector<Sample> samples(std::size_t count) const {
    std::vector<double> sums;
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
      sums.push_back(length(normal(t)) + (sums.empty() ? 0 : sums.back()));
    std::mt19937 random(1);
    const auto unit = [&random] { return static_cast<double>(random()) / 4294967296.0; };
    std::vector<Sample> made;
    for (std::size_t i = 0; i < count; ++i) {
      const double place = (static_cast<double>(i) + unit()) / static_cast<double>(count) * sums.back();
      const auto t = static_cast<std::uint32_t>(std::lower_bound(sums.begin(), sums.end() - 1, place) - sums.begin());
      const double r = std::sqrt(unit());
      const double s = unit();
      const auto& [a, b, c] = corners(t);
      made.push_back({(1 - r) * a + r * (1 - s) * b + r * s * c, unit_normal(t)});
    }
    return made;
  }

  [[nodiscard]] Nearest nearest(const Place& p) const {
    Nearest best;
    search(0, p, best);
    return best;
  }
  [[nodiscard]] Place unit_normal(std::uint32_t t) const {
    const Place n = normal(t);
    return 1 / std::max(length(n), std::numeric_limits<double>::min()) * n;
  }
  /// Of the box of all triangles.
  [[nodiscard]] double diagonal() const { return length(boxes_[0].high - boxes_[0].low); }

 private:
  struct Box {
    Place low;
    Place high;
    std::size_t first = 0;  // triangles, in order_
    std::size_t last = 0;
    std::size_t left = 0;  // 0: none
    std::size_t right = 0;
  };

  [[nodiscard]] std::array<Place, 3> corners(std::uint32_t t) const {
    const auto& [a, b, c] = triangles_[t];
    return {points_[a], points_[b], points_[c]};
  }
  /// Twice the area long.
  [[nodiscard]] Place normal(std::uint32_t t) const {
    const auto [a, b, c] = corners(t);
    const Place u = b - a;
    const Place v = c - a;
    return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  }

  std::size_t add_box(std::size_t first, std::size_t last) {
    constexpr double far = std::numeric_limits<double>::infinity();
    Box box{{far, far, far}, {-far, -far, -far}, first, last};
    for (std::size_t i = first; i < last; ++i)
      for (const Place& p : corners(order_[i]))
        for (unsigned axis = 0; axis < 3; ++axis) {
          box.low[axis] = std::min(box.low[axis], p[axis]);
          box.high[axis] = std::max(box.high[axis], p[axis]);
        }
    const std::size_t number = boxes_.size();
    boxes_.push_back(box);
    if (last - first <= 4) return number;
    const Place sides = box.high - box.low;
    const auto axis = static_cast<std::size_t>(std::max_element(sides.begin(), sides.end()) - sides.begin());
    const auto center = [&](std::uint32_t t) {
      const auto [a, b, c] = corners(t);
      return a[axis] + b[axis] + c[axis];
    };
    const std::size_t middle = (first + last) / 2;
    const auto at = [this](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(first), at(middle), at(last),
                     [&](std::uint32_t s, std::uint32_t t) { return center(s) < center(t); });
    const std::size_t left = add_box(first, middle);
    const std::size_t right = add_box(middle, last);
    boxes_[number].left = left;
    boxes_[number].right = right;
    return number;
  }

  [[nodiscard]] double squared_to(std::size_t number, const Place& p) const {
    double sum = 0;
    for (unsigned axis = 0; axis < 3; ++axis) {
      const double way = std::max({boxes_[number].low[axis] - p[axis], 0.0, p[axis] - boxes_[number].high[axis]});
      sum += way * way;
    }
    return sum;
  }

  void search(std::size_t number, const Place& p, Nearest& best) const {
    const Box& box = boxes_[number];
    if (box.left == 0) {
      for (std::size_t i = box.first; i < box.last; ++i) {
        const auto [a, b, c] = corners(order_[i]);
        const double squared = squared_distance(p, a, b, c);
        if (squared < best.squared) best = {squared, order_[i]};
      }
      return;
    }
    const double left = squared_to(box.left, p);
    const double right = squared_to(box.right, p);
    const bool left_first = left <= right;
    if (std::min(left, right) < best.squared) search(left_first ? box.left : box.right, p, best);
    if (std::max(left, right) < best.squared) search(left_first ? box.right : box.left, p, best);
  }

  std::span<const Place> points_;
  Triangles triangles_;
  std::vector<std::uint32_t> order_;
  std::vector<Box> boxes_;
};

/// In shares of the diagonal of `whole`, from and to it; and the share of the coarse surface's area that faces away
/// from the nearest triangle of `whole`, by more than about 100 degrees.
struct Deviation {
  double mean = 0;
  double largest = 0;
  double turned = 0;
};
inline Deviation deviation(const Surface& whole, const Surface& coarse, std::size_t count) {
  constexpr double away = -0.2;  // a cosine
  Deviation found;
  const auto add = [&](double squared) {
    found.mean += std::sqrt(squared);
    found.largest = std::max(found.largest, std::sqrt(squared));
  };
  for (const Surface::Sample& sample : whole.samples(count)) add(coarse.nearest(sample.point).squared);
  for (const Surface::Sample& sample : coarse.samples(count)) {
    const Surface::Nearest nearest = whole.nearest(sample.point);
    add(nearest.squared);
    if (dot(sample.normal, whole.unit_normal(nearest.triangle)) < away) found.turned += 1;
  }
  const auto n = static_cast<double>(count);
  return {found.mean / (2 * n) / whole.diagonal(), found.largest / whole.diagonal(), found.turned / n};
}

}  // namespace restrip::bench
