// Bodies of simplify.hpp.
//
// Every vertex proposes its cheapest permitted collapse to a queue (propose). run() takes the cheapest of all,
// collapses it, and lets the vertices around propose again. Versions mark proposals that are out of date.
//
// Invariant. The proposal of a vertex depends on its fan, on its quadric and on the places of its neighbours. A
// collapse changes fans of v_s and its neighbours only, and these propose again. Whether check_collapse() grants a
// collapse may change further away, by the valence of an apex, so it is asked when a proposal is taken; when it
// refuses, the vertex proposes its next one.
//
// Cost. A proposal walks one fan and evaluates a quadric for each spoke, then compares triangles for one or two of
// them. A collapse makes about seven proposals, each with one entry of the heap.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "restrip/mesh/checks.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/search/simplify.hpp"

namespace restrip {

namespace detail::simplify {

constexpr double infinite = std::numeric_limits<double>::infinity();
/// The weight of a boundary edge's plane, compared with a square of the same side.
constexpr double boundary_weight = 10;
/// Squared lengths that break ties on flat regions are weighted as this share of a squared distance.
constexpr double tie_weight = 1e-9;
/// The same for lengths of badly shaped triangles, divided by the squared ratio of area to squared side.
constexpr double shape_weight = 1e-10;
/// The squared cosine of the largest turn of a triangle while others are possible.
constexpr double careful_turn = 0.5 * 0.5;
/// A triangle has no area if the square of its double area is below this share of its longest side's fourth power.
constexpr double flat = 1e-14;
/// The squared sine up to which a triangle counts as parallel to a direction.
constexpr double parallel = 1e-18;
/// Squared cosines: the outline turns at a corner by more than 30 degrees, and seen from afar by more than 45.
constexpr double corner_turn = 0.75;
constexpr double corner_turn_from_afar = 0.5;
/// From afar: from a sixteenth of the outline's length.
constexpr double afar = 1.0 / 16;

template <class V>
[[nodiscard]] V minus(const V& a, const V& b) noexcept {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class V>
[[nodiscard]] V plus(const V& a, const V& b) noexcept {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class V>
[[nodiscard]] double dot(const V& a, const V& b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class V>
[[nodiscard]] V cross(const V& a, const V& b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// Whether the angle between two vectors is larger than the angle with this squared cosine, at most 90 degrees.
template <class V>
[[nodiscard]] bool turns_by_more(const V& a, const V& b, double squared_cosine) noexcept {
  const double d = dot(a, b);
  return d <= 0 || d * d <= squared_cosine * dot(a, a) * dot(b, b);
}

}  // namespace detail::simplify

struct Simplifier::Quadric {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
  Vector linear;
  double constant = 0;
  double area = 0;

  /// Adds a plane through the vertex, with the weight weight · |normal|².
  void add_plane(const Vector& normal, double weight) noexcept {
    const Vector n{weight * normal.x, weight * normal.y, weight * normal.z};
    xx += n.x * normal.x;
    xy += n.x * normal.y;
    xz += n.x * normal.z;
    yy += n.y * normal.y;
    yz += n.y * normal.z;
    zz += n.z * normal.z;
  }
  [[nodiscard]] Vector times(const Vector& x) const noexcept {
    return {xx * x.x + xy * x.y + xz * x.z, xy * x.x + yy * x.y + yz * x.z, xz * x.x + yz * x.y + zz * x.z};
  }
  [[nodiscard]] double at(const Vector& x) const noexcept {
    return detail::simplify::dot(x, times(x)) + 2 * detail::simplify::dot(linear, x) + constant;
  }
  /// Sums grow with the area; this factor takes back a quarter power of it, so that large flat regions are not spared.
  [[nodiscard]] double scale() const noexcept { return area > 0 ? 1 / std::sqrt(std::sqrt(area)) : 1; }
  /// The cost of a collapse along x.
  [[nodiscard]] double cost_at(const Vector& x) const noexcept {
    using namespace detail::simplify;
    return ((std::max)(0.0, at(x)) + tie_weight * dot(x, x) * area) * scale();
  }
  /// Adds the quadric of the vertex from which `way` leads here.
  void add_moved(const Quadric& other, const Vector& way) noexcept {
    using namespace detail::simplify;
    const Vector product = other.times(way);
    constant += dot(way, product) + 2 * dot(other.linear, way) + other.constant;
    linear = plus(linear, plus(product, other.linear));
    xx += other.xx;
    xy += other.xy;
    xz += other.xz;
    yy += other.yy;
    yz += other.yz;
    zz += other.zz;
    area += other.area;
  }
};

struct Simplifier::Site {
  Vector point;
  Quadric quadric;
  std::uint32_t version = 0;
  std::uint32_t neighbors = 0;
  std::uint32_t mark = 0;
  bool corner = false;    ///< of the outline
  bool proposed = false;  ///< its newest proposal is in the queue
  bool changed = false;   ///< since that proposal, its fan has
  bool hindered = false;  ///< a cheaper collapse than that proposal was not permitted
  double cost = 0;        ///< of that proposal
};

struct Simplifier::Spoke {
  Halfedge h;
  Vertex to = none;
  Vector way;          ///< from the vertex
  Vector normal;       ///< of the triangle to the left, twice its area long
  double squared = 0;  ///< the normal's squared length
  double cost = 0;     ///< of the collapse into `to`, without the shape of triangles
};

struct Simplifier::Candidate {
  double cost = 0;
  Vertex v_s = none;
  Vertex v_t = none;
  std::uint32_t version = 0;
  Halfedge h{};  ///< v_t -> v_s

  /// A total order of the proposals of one vertex, and of the newest proposals of all.
  [[nodiscard]] bool operator<(const Candidate& other) const noexcept {
    if (cost != other.cost) return cost < other.cost;
    return v_t != other.v_t ? v_t < other.v_t : v_s < other.v_s;
  }
};

inline Simplifier::Simplifier(StripMesh mesh, std::span<const Point> points, BoundaryPolicy boundary)
    : mesh_(std::move(mesh)), boundary_(boundary), sites_(mesh_.vertex_bound()), original_(mesh_.triangle_bound()) {
  RESTRIP_ASSERT(points.size() >= mesh_.vertex_bound(), "Simplifier", "a vertex of the mesh has no point");
  place(points);
  find_normals();
  find_directions();
  add_planes();
  find_corners();
  begin(Stage::careful);
}

inline bool Simplifier::run(std::size_t wanted, std::size_t most) {
  const auto later = [](const Candidate& a, const Candidate& b) { return b < a; };
  while (mesh_.triangle_count() > wanted) {
    if (queue_.empty()) {
      if (stage_ == stages.back()) return true;
      begin(stages[static_cast<std::size_t>(stage_) + 1]);
      continue;
    }
    if (most == 0) return false;
    std::pop_heap(queue_.begin(), queue_.end(), later);
    const Candidate best = queue_.back();
    queue_.pop_back();
    Site& site = sites_[best.v_t];
    if (best.version != site.version) continue;
    site.proposed = false;
    if (site.changed) {
      propose(best.v_t);
      continue;
    }
    const Halfedge chord = mesh_.opposite(best.h);
    if (refusal_of(chord) != Refusal::granted) {
      propose(best.v_t, &best);
      continue;
    }
    collapse(chord);
    --most;
  }
  return true;
}

// ---- the beginning

/// Moves the box of the points to the origin and scales it to about 1, by powers of two: differences of coordinates
/// with 32 bits stay exact, and nothing overflows.
inline void Simplifier::place(std::span<const Point> points) {
  const auto for_each_vertex = [this](auto&& visit) {
    for (Triangle t = 0; t < mesh_.triangle_bound(); ++t)
      if (mesh_.alive(t))
        for (const Vertex v : mesh_.corners(t)) visit(v);
  };
  const auto finite = [](const Point& p) {
    return std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); });
  };
  const auto exponent = [](double x) {
    int e = 0;
    (void)std::frexp(x, &e);
    return x > 0 ? e : 0;
  };
  double largest = 0;
  for_each_vertex([&](Vertex v) {
    ++sites_[v].neighbors;
    if (!finite(points[v])) return;
    for (const double x : points[v]) largest = (std::max)(largest, std::abs(x));
  });
  const int first_scale = -exponent(largest);
  Point low{1, 1, 1};
  Point high{-1, -1, -1};
  for_each_vertex([&](Vertex v) {
    if (!finite(points[v])) return;
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = std::ldexp(points[v][i], first_scale);
      low[i] = (std::min)(low[i], x);
      high[i] = (std::max)(high[i], x);
    }
  });
  const int second_scale = -exponent((std::max)({high[0] - low[0], high[1] - low[1], high[2] - low[2]}));
  for (Vertex v = 0; v < sites_.size(); ++v) {
    const auto at = [&](std::size_t i) {
      return std::ldexp(std::ldexp(points[v][i], first_scale) - low[i], second_scale);
    };
    sites_[v].point = {at(0), at(1), at(2)};
  }
}

inline void Simplifier::find_normals() {
  using namespace detail::simplify;
  for (Triangle t = 0; t < mesh_.triangle_bound(); ++t) {
    if (!mesh_.alive(t)) continue;
    const auto corners = mesh_.corners(t);
    const Vector& a = sites_[corners[0]].point;
    original_[t] = cross(minus(sites_[corners[1]].point, a), minus(sites_[corners[2]].point, a));
  }
  // A triangle without area shall face as its neighbours do, once it has one.
  for (Triangle t = 0; t < mesh_.triangle_bound(); ++t) {
    if (!mesh_.alive(t) || dot(original_[t], original_[t]) > 0) continue;
    for_each_neighbor(mesh_, t, [&](Triangle other) { original_[t] = plus(original_[t], original_[other]); });
  }
}

inline void Simplifier::add_planes() {
  using namespace detail::simplify;
  for (Triangle t = 0; t < mesh_.triangle_bound(); ++t) {
    if (!mesh_.alive(t)) continue;
    const Vector& normal = original_[t];
    const double squared = dot(normal, normal);
    for (unsigned side = 0; side < 3; ++side) {
      const Halfedge h = StripMesh::halfedge(t, side);
      const bool on_boundary = StripMesh::on_boundary(mesh_.opposite(h));
      if (on_boundary) ++sites_[mesh_.from(h)].neighbors;
      if (!(squared > 0)) continue;
      Site& from = sites_[mesh_.from(h)];
      Site& to = sites_[mesh_.to(h)];
      const double length = std::sqrt(squared);
      from.quadric.add_plane(normal, 0.5 / length);  // normal / length is 1 long, the area is length / 2
      from.quadric.area += length / 2;
      if (!on_boundary) continue;
      const Vector up = direction_of(t);
      const Vector across = cross(minus(to.point, from.point), up);  // edge length times the length of `up` long
      const double weight = boundary_weight / dot(up, up);
      from.quadric.add_plane(across, weight);
      to.quadric.add_plane(across, weight);
    }
  }
}

/// The direction from which the outline at a triangle is seen: height fields from above, others along the normal.
inline Simplifier::Vector Simplifier::direction_of(Triangle t) const {
  const std::uint32_t first = first_[faces_[t]];
  return first < first_[faces_[t] + 1] ? directions_[first] : original_[t];
}

/// Walks along the outlines; height fields are seen from above. A corner must be one both for its neighbours
/// and from afar, so that steps of a jagged outline, and points of a finely divided curve, are not corners.
inline void Simplifier::find_corners() {
  using namespace detail::simplify;
  const auto on_outline = [this](Vertex v) {
    return mesh_.spoke(v).id != none && !mesh_.non_manifold(v) && mesh_.leaves_boundary(mesh_.spoke(v));
  };
  const auto after = [this](Vertex v) { return mesh_.to(mesh_.spoke(v)); };
  ++mark_;
  std::vector<Vertex> loop;
  std::vector<double> length;  // from the loop's first vertex to each, and around
  for (Vertex start = 0; start < sites_.size(); ++start) {
    if (!on_outline(start) || sites_[start].mark == mark_) continue;
    loop.clear();
    length.assign(1, 0);
    const Triangle first_triangle = StripMesh::triangle(mesh_.spoke(start));
    const bool from_above = first_[faces_[first_triangle]] < first_[faces_[first_triangle] + 1];
    const Vector up = direction_of(first_triangle);
    const auto seen = [&](const Vector& way) {  // without what is along `up`
      if (!from_above) return way;
      const double share = dot(way, up) / dot(up, up);
      return minus(way, Vector{share * up.x, share * up.y, share * up.z});
    };
    Vertex v = start;
    for (; on_outline(v) && sites_[v].mark != mark_; v = after(v)) {
      sites_[v].mark = mark_;
      loop.push_back(v);
      const Vector way = seen(minus(sites_[after(v)].point, sites_[v].point));
      length.push_back(length.back() + std::sqrt(dot(way, way)));
    }
    if (v != start) continue;  // it ends at a vertex that never moves
    const std::size_t n = loop.size();
    const double distance = length.back() * afar;
    const auto point = [&](std::size_t i) { return sites_[loop[i % n]].point; };
    const auto place_of = [&](std::size_t i) { return length[i % n] + (i >= n ? length.back() : 0); };
    std::size_t back = 0;
    std::size_t front = 0;
    for (std::size_t i = n; i < 2 * n; ++i) {  // one turn later, so that there are vertices before
      while (back + 1 < i && place_of(i) - place_of(back + 1) >= distance) ++back;
      front = (std::max)(front, i + 1);
      while (front + 1 < i + n &&
             place_of(front % (2 * n)) + (front >= 2 * n ? 2 * length.back() : 0) - place_of(i) < distance)
        ++front;
      const auto turns = [&](std::size_t from, std::size_t to, double squared_cosine) {
        return turns_by_more(seen(minus(point(i), point(from))), seen(minus(point(to), point(i))), squared_cosine);
      };
      sites_[loop[i % n]].corner = turns(i - 1, i + 1, corner_turn) && turns(back, front, corner_turn_from_afar);
    }
  }
}

inline void Simplifier::find_directions() {
  using namespace detail::simplify;
  faces_.assign(mesh_.triangle_bound(), none);
  first_.assign(1, 0);
  std::vector<Triangle> component;
  for (Triangle start = 0; start < mesh_.triangle_bound(); ++start) {
    if (!mesh_.alive(start) || faces_[start] != none) continue;
    const auto number = static_cast<std::uint32_t>(first_.size() - 1);
    component.assign(1, start);
    faces_[start] = number;
    Vector sum;
    for (std::size_t i = 0; i < component.size(); ++i) {
      sum = plus(sum, original_[component[i]]);
      for_each_neighbor(mesh_, component[i], [&](Triangle t) {
        if (faces_[t] == none) component.push_back(t);
        faces_[t] = number;
      });
    }
    for (const Vector& direction : {Vector{1, 0, 0}, Vector{-1, 0, 0}, Vector{0, 1, 0}, Vector{0, -1, 0},
                                    Vector{0, 0, 1}, Vector{0, 0, -1}, sum}) {
      const double scale = parallel * dot(direction, direction);
      bool along = false;
      bool against = false;
      for (const Triangle t : component) {
        const double d = dot(original_[t], direction);
        if (d * d <= scale * dot(original_[t], original_[t])) continue;
        along = along || d > 0;
        against = against || d < 0;
      }
      if (along && !against) directions_.push_back(direction);
    }
    first_.push_back(static_cast<std::uint32_t>(directions_.size()));
  }
}

// ---- proposals

inline void Simplifier::begin(Stage stage) {
  stage_ = stage;
  queue_.clear();
  for (Vertex v = 0; v < sites_.size(); ++v)
    if (mesh_.spoke(v).id != none) propose(v);
}

/// Queues the cheapest permitted collapse of v, or the cheapest after one that was refused.
inline void Simplifier::propose(Vertex v, const Candidate* after) {
  using namespace detail::simplify;
  Site& site = sites_[v];
  ++site.version;
  site.proposed = false;
  site.changed = false;
  site.hindered = after != nullptr;
  if (mesh_.non_manifold(v) || site.neighbors > most_neighbors) return;
  const bool on_outline = mesh_.leaves_boundary(mesh_.spoke(v));
  if (on_outline && (boundary_ == BoundaryPolicy::lock || (site.corner && stage_ != Stage::corners))) return;
  gather(v);
  for (std::size_t i = 0; i < fan_.size(); ++i) {
    Spoke& spoke = fan_[i];
    spoke.cost = infinite;
    if (on_outline && i != 0 && i + 1 != fan_.size()) continue;
    if (mesh_.non_manifold(spoke.to) || sites_[spoke.to].neighbors > most_neighbors) continue;
    if (boundary_ == BoundaryPolicy::lock && mesh_.leaves_boundary(mesh_.opposite(spoke.h))) continue;
    spoke.cost = site.quadric.cost_at(spoke.way);
  }
  Candidate best{infinite, none, v, site.version, {}};
  while (true) {
    std::size_t cheapest = fan_.size();
    for (std::size_t i = 0; i < fan_.size(); ++i)
      if (fan_[i].cost < (cheapest < fan_.size() ? fan_[cheapest].cost : best.cost)) cheapest = i;
    if (cheapest == fan_.size()) break;
    const Candidate next{cost_of(site.quadric, cheapest), fan_[cheapest].to, v, site.version, fan_[cheapest].h};
    fan_[cheapest].cost = infinite;
    if (!(next.cost < infinite)) site.hindered = true;
    if (next < best && (after == nullptr || *after < next)) best = next;
  }
  if (!(best.cost < infinite)) return;
  site.proposed = true;
  site.cost = best.cost;
  queue_.push_back(best);
  std::push_heap(queue_.begin(), queue_.end(), [](const Candidate& a, const Candidate& b) { return b < a; });
}

/// Fills fan_, counter-clockwise. The last spoke on the boundary has no triangle.
inline void Simplifier::gather(Vertex v) {
  using namespace detail::simplify;
  fan_.clear();
  const Vector& center = sites_[v].point;
  for_each_spoke(mesh_, v, [&](Halfedge h) {
    const Vertex to = mesh_.to(h);
    fan_.push_back({h, to, minus(sites_[to].point, center), {}});
  });
  fan_triangles_ = StripMesh::on_boundary(fan_.back().h) ? fan_.size() - 1 : fan_.size();
  for (std::size_t i = 0; i < fan_triangles_; ++i) {
    fan_[i].normal = cross(fan_[i].way, fan_[i + 1 < fan_.size() ? i + 1 : 0].way);
    fan_[i].squared = dot(fan_[i].normal, fan_[i].normal);
  }
}

/// The cost of the collapse into a neighbour, or infinite if a triangle would turn over or lose its area.
inline double Simplifier::cost_of(const Quadric& quadric, std::size_t to) const {
  using namespace detail::simplify;
  const Vector& way = fan_[to].way;
  const double turn = stage_ == Stage::careful ? careful_turn : 0;
  double worst = 1;
  double longest = 0;
  for (std::size_t i = 0; i < fan_triangles_; ++i) {
    const std::size_t j = i + 1 < fan_.size() ? i + 1 : 0;
    if (i == to || j == to) continue;  // is removed
    const Spoke& spoke = fan_[i];
    const Vector a = minus(spoke.way, way);
    const Vector b = minus(fan_[j].way, way);
    const Vector rim = minus(fan_[j].way, spoke.way);
    const Vector normal = cross(a, b);
    const double squared = dot(normal, normal);
    const double side = (std::max)({dot(a, a), dot(b, b), dot(rim, rim)});
    if (!(squared > flat * side * side)) {
      if (!(squared > 0)) {
        if (!(spoke.squared <= 0)) return infinite;
        continue;
      }
      const double before = (std::max)({dot(spoke.way, spoke.way), dot(fan_[j].way, fan_[j].way), dot(rim, rim)});
      if (spoke.squared > flat * before * before) return infinite;
    }
    if (spoke.squared > 0 && turns_by_more(normal, spoke.normal, turn)) return infinite;
    const Triangle t = StripMesh::triangle(spoke.h);
    const Vector& original = original_[t];
    if (dot(normal, original) <= 0 && dot(original, original) > 0) return infinite;
    if (!directions_.empty() && !keeps_direction(t, spoke.normal, normal, squared)) return infinite;
    worst = (std::min)(worst, squared / (side * side));
    longest = (std::max)(longest, side);
  }
  return fan_[to].cost + shape_weight * longest / worst * quadric.area * quadric.scale();
}

/// Whether a triangle faces the directions of its component after a change, as far as it did before.
inline bool Simplifier::keeps_direction(Triangle t, const Vector& before, const Vector& after, double squared) const {
  using namespace detail::simplify;
  for (std::uint32_t i = first_[faces_[t]]; i < first_[faces_[t] + 1]; ++i) {
    const double scale = parallel * dot(directions_[i], directions_[i]);
    const double d = dot(after, directions_[i]);
    const double was = dot(before, directions_[i]);
    const bool is_parallel = d * d <= scale * squared;
    const bool was_parallel = was * was <= scale * dot(before, before);
    if (is_parallel ? !was_parallel : d < 0) return false;
  }
  return true;
}

// ---- collapses

inline Refusal Simplifier::refusal_of(Halfedge chord) {
  return detail::check_collapse_with(mesh_, chord, [this](Vertex v_s, Vertex v_t, Vertex v_l, Vertex v_r) {
    ++mark_;
    for_each_spoke(mesh_, v_t, [this](Halfedge h) { sites_[mesh_.to(h)].mark = mark_; });
    bool shared = false;
    for_each_spoke(mesh_, v_s, [&](Halfedge h) {
      const Vertex w = mesh_.to(h);
      shared = shared || (sites_[w].mark == mark_ && w != v_l && w != v_r);
    });
    return shared;
  });
}

inline void Simplifier::collapse(Halfedge chord) {
  using namespace detail::simplify;
  const SplitRecord record = record_of_collapse(mesh_, chord);
  Site& stays = sites_[record.v_s];
  Site& gone = sites_[record.v_t];
  stays.quadric.add_moved(gone.quadric, minus(stays.point, gone.point));
  stays.neighbors += gone.neighbors - 2;
  for (const Vertex apex : {record.v_l, record.v_r}) {
    if (apex == none) continue;
    --sites_[apex].neighbors;
    --stays.neighbors;
  }
  ++gone.version;
  collapses_.push_back(record);
  mesh_.remove_vertex(chord);
  around_.clear();
  for_each_spoke(mesh_, record.v_s, [this](Halfedge h) { around_.push_back(mesh_.to(h)); });
  propose(record.v_s);
  for (const Vertex v : around_) {
    Site& site = sites_[v];
    if (site.proposed && !site.hindered && site.quadric.cost_at(minus(stays.point, site.point)) >= site.cost)
      site.changed = true;
    else
      propose(v);
  }
}

// ---- reports

inline std::vector<Obstacle> Simplifier::obstacles() {
  std::vector<Obstacle> found;
  const auto note = [&found](const char* why) {
    const auto same = std::find_if(found.begin(), found.end(), [&](const Obstacle& one) { return one.why == why; });
    ++(same == found.end() ? found.emplace_back(Obstacle{why}) : *same).edges;
  };
  const auto why = [this](Halfedge h) -> const char* {
    const Halfedge back = mesh_.opposite(h);
    const Vertex from = mesh_.from(h);
    const Vertex to = mesh_.to(h);
    if (mesh_.non_manifold(from) || mesh_.non_manifold(to)) return describe(Refusal::non_manifold_vertex);
    if (sites_[from].neighbors > most_neighbors || sites_[to].neighbors > most_neighbors)
      return "a vertex has more than 256 neighbours";
    if (boundary_ == BoundaryPolicy::lock && (mesh_.leaves_boundary(h) || mesh_.leaves_boundary(back)))
      return "the boundary is locked";
    const Refusal refusal = refusal_of(h);
    return refusal != Refusal::granted ? describe(refusal) : "a triangle would turn over or lose its area";
  };
  static_assert(most_neighbors == 256);
  for (Triangle t = 0; t < mesh_.triangle_bound(); ++t)
    for (unsigned side = 0; side < 3 && mesh_.alive(t); ++side) {
      const Halfedge h = StripMesh::halfedge(t, side);
      if (h.id < mesh_.opposite(h).id) note(why(h));
    }
  std::stable_sort(found.begin(), found.end(), [](const Obstacle& a, const Obstacle& b) { return a.edges > b.edges; });
  return found;
}

inline std::size_t Simplifier::large_vertices() const noexcept {
  std::size_t n = 0;
  for (Vertex v = 0; v < sites_.size(); ++v)
    n += static_cast<std::size_t>(mesh_.spoke(v).id != none && sites_[v].neighbors > most_neighbors);
  return n;
}

}  // namespace restrip
