// The simplifier: half-edge collapses in the order of their quadric errors.
//
// Every vertex proposes its cheapest permitted collapse to a queue (propose). run() takes the cheapest of all,
// collapses it, and lets the vertices around propose again. Versions mark proposals that are out of date. When the
// queue is empty, the next stage begins, in which more collapses are permitted.
//
// Invariant. The proposal of a vertex depends on its fan, on its quadric and on the places of its neighbours. A
// collapse changes fans of v_s and its neighbours only, and these propose again. Whether check_collapse() grants a
// collapse may change further away, by the valence of an apex, so it is asked when a proposal is taken; when it
// refuses, the vertex proposes its next one.
//
// Sizes. The points are scaled by a power of two, so that the whole mesh is about 1 and squares of areas do not
// overflow. A detail may be smaller by any factor: where a square would lose digits to underflow, the vectors are
// enlarged by a power of two first (enlargement_of), which changes no other result.
//
// Cost. A proposal walks one fan and evaluates a quadric for each spoke, then compares triangles for one or two of
// them. A collapse makes about seven proposals, each with one entry of the heap.
//
// Source: Garland and Heckbert, "Surface simplification using quadric error metrics", SIGGRAPH 1997.
#include "lod/simplifier.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "restrip/mesh/checks.hpp"
#include "restrip/mesh/walks.hpp"

namespace restrip::tools {

namespace simplifying {

using Halfedge = StripMesh::Halfedge;
using Point = Simplifier::Point;
using Vector = Simplifier::Point;

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
/// Below this, the square of a squared length has lost digits to underflow.
constexpr double least_exact = 1e-140;

[[nodiscard]] Vector minus(const Vector& a, const Vector& b) noexcept {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
[[nodiscard]] Vector plus(const Vector& a, const Vector& b) noexcept { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
[[nodiscard]] double dot(const Vector& a, const Vector& b) noexcept { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
[[nodiscard]] Vector cross(const Vector& a, const Vector& b) noexcept {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The exponent of the power of two that makes the largest component about 1; 0 for zero.
[[nodiscard]] int enlargement_of(const Vector& a) noexcept {
  int exponent = 0;
  const double largest = (std::max)({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])});
  if (largest > 0) (void)std::frexp(largest, &exponent);
  return -exponent;
}
[[nodiscard]] Vector enlarged(const Vector& a, int exponent) noexcept {
  return {std::ldexp(a[0], exponent), std::ldexp(a[1], exponent), std::ldexp(a[2], exponent)};
}
[[nodiscard]] double length_of(const Vector& a) noexcept {
  if (const double squared = dot(a, a); !(squared < least_exact)) return std::sqrt(squared);
  const int exponent = enlargement_of(a);
  const Vector b = enlarged(a, exponent);
  return std::ldexp(std::sqrt(dot(b, b)), -exponent);
}

/// Whether the angle between two vectors is larger than the angle with this squared cosine, at most 90 degrees.
[[nodiscard]] bool turns_by_more(const Vector& a, const Vector& b, double squared_cosine) noexcept {
  const double d = dot(a, b);
  const double squares = dot(a, a) * dot(b, b);
  if (!(squares < least_exact * least_exact)) return d <= 0 || d * d <= squared_cosine * squares;
  const Vector c = enlarged(a, enlargement_of(a));
  const Vector e = enlarged(b, enlargement_of(b));
  const double f = dot(c, e);
  return f <= 0 || f * f <= squared_cosine * dot(c, c) * dot(e, e);
}

/// The shape of a triangle with these two sides, counter-clockwise from their common corner. A triangle that is too
/// small for the squares is enlarged by 2^exponent.
struct Shape {
  Vector normal;         ///< twice the area long
  double squared = 0;    ///< the normal's squared length
  double side = 0;       ///< the squared length of the longest side
  int exponent = 0;      ///< 0 but for tiny triangles
  double true_side = 0;  ///< `side` without enlargement
};
[[nodiscard]] Shape shape_of(const Vector& a, const Vector& b) noexcept {
  const auto measured = [](const Vector& p, const Vector& q) {
    const Vector rim = minus(q, p);
    Shape shape{cross(p, q)};
    shape.squared = dot(shape.normal, shape.normal);
    shape.side = shape.true_side = (std::max)({dot(p, p), dot(q, q), dot(rim, rim)});
    return shape;
  };
  Shape shape = measured(a, b);
  if (!(shape.squared < least_exact)) return shape;
  const int exponent = (std::min)(enlargement_of(a), enlargement_of(b));
  if (exponent <= 0) return shape;
  const double true_side = shape.side;
  shape = measured(enlarged(a, exponent), enlarged(b, exponent));
  shape.exponent = exponent;
  shape.true_side = true_side;
  return shape;
}

/// The weighted squared distances to some planes, x'Ax + 2 b'x + c, as a function of the way x from a vertex. Being
/// relative to the vertex it loses no digits to the distance from the origin.
struct Quadric {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
  Vector linear{};
  double constant = 0;
  double area = 0;

  /// Adds a plane through the vertex, with the weight weight · |normal|².
  void add_plane(const Vector& normal, double weight) noexcept {
    const Vector n{weight * normal[0], weight * normal[1], weight * normal[2]};
    xx += n[0] * normal[0];
    xy += n[0] * normal[1];
    xz += n[0] * normal[2];
    yy += n[1] * normal[1];
    yz += n[1] * normal[2];
    zz += n[2] * normal[2];
  }
  [[nodiscard]] Vector times(const Vector& x) const noexcept {
    return {xx * x[0] + xy * x[1] + xz * x[2], xy * x[0] + yy * x[1] + yz * x[2], xz * x[0] + yz * x[1] + zz * x[2]};
  }
  [[nodiscard]] double at(const Vector& x) const noexcept { return dot(x, times(x)) + 2 * dot(linear, x) + constant; }
  /// Sums grow with the area; this factor takes back a quarter power of it, so that large flat regions are not spared.
  [[nodiscard]] double scale() const noexcept { return area > 0 ? 1 / std::sqrt(std::sqrt(area)) : 1; }
  /// The cost of a collapse along x.
  [[nodiscard]] double cost_at(const Vector& x) const noexcept {
    return ((std::max)(0.0, at(x)) + tie_weight * dot(x, x) * area) * scale();
  }
  /// Adds the quadric of the vertex from which `way` leads here.
  void add_moved(const Quadric& other, const Vector& way) noexcept {
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

/// What each vertex carries.
struct Site {
  Point point{};
  Quadric quadric;
  std::uint32_t version = 0;
  std::uint32_t neighbors = 0;
  std::uint32_t mark = 0;
  bool fixed = false;     ///< never removed
  bool corner = false;    ///< of the outline
  bool proposed = false;  ///< its newest proposal is in the queue
  bool changed = false;   ///< since that proposal, its fan has
  bool hindered = false;  ///< a cheaper collapse than that proposal was not permitted
  double cost = 0;        ///< of that proposal
};

/// A neighbour of the vertex that is being judged, and the triangle from there to the next neighbour.
struct Spoke {
  Halfedge h;
  Vertex to = none;
  Vector way{};     ///< from the vertex
  Shape shape{};    ///< of the triangle to the left
  double cost = 0;  ///< of the collapse into `to`, without the shape of triangles
};

/// The cheapest collapse of a vertex. It is out of date if the vertex has another version by now.
struct Candidate {
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
constexpr auto later = [](const Candidate& a, const Candidate& b) { return b < a; };

/// The collapses that are permitted, from the preferred ones to all.
enum class Stage : std::uint8_t { careful, any_turn, corners };
constexpr std::array stages{Stage::careful, Stage::any_turn, Stage::corners};

class Engine {
 public:
  Engine(StripMesh mesh, std::span<const Point> points, BoundaryPolicy boundary, std::span<const Vertex> fixed)
      : mesh_(std::move(mesh)), boundary_(boundary), sites_(mesh_.vertex_bound()), original_(mesh_.triangle_bound()) {
    RESTRIP_ASSERT(points.size() >= mesh_.vertex_bound(), "Simplifier", "a vertex of the mesh has no point");
    for (const Vertex v : fixed)
      if (v < sites_.size()) sites_[v].fixed = true;
    place(points);
    find_normals();
    find_directions();
    add_planes();
    find_corners();
    begin(Stage::careful);
  }

  bool run(std::size_t wanted, std::size_t most);
  [[nodiscard]] const StripMesh& mesh() const noexcept { return mesh_; }
  [[nodiscard]] const std::vector<SplitRecord>& collapses() const noexcept { return collapses_; }
  [[nodiscard]] std::vector<Obstacle> obstacles();
  [[nodiscard]] std::size_t large_vertices() const noexcept;

 private:
  void place(std::span<const Point> points);
  void find_normals();
  void find_directions();
  void add_planes();
  void find_corners();
  [[nodiscard]] Shape shape_of(Triangle t) const;
  [[nodiscard]] Vector direction_of(Triangle t) const;
  void begin(Stage stage);
  void propose(Vertex v, const Candidate* after = nullptr);
  void gather(Vertex v);
  [[nodiscard]] double cost_of(const Quadric& quadric, std::size_t to) const;
  [[nodiscard]] bool keeps_direction(Triangle t, const Shape& before, const Shape& after) const;
  void collapse(Halfedge chord);

  StripMesh mesh_;
  BoundaryPolicy boundary_;
  Stage stage_ = Stage::careful;
  std::vector<Site> sites_;             // by vertices
  std::vector<Vector> original_;        // normals, by triangles; of tiny triangles enlarged
  std::vector<Vector> directions_;      // that the triangles of some components face
  std::vector<std::uint32_t> faces_;    // by triangles: their component, if any has a direction
  std::vector<std::uint32_t> first_;    // by components: the first of its directions
  std::vector<Candidate> queue_;        // a heap
  std::vector<SplitRecord> collapses_;  // the finest first
  std::uint32_t mark_ = 0;
  // The fan of the vertex that is being judged.
  std::vector<Spoke> fan_;
  std::size_t fan_triangles_ = 0;
  std::vector<Vertex> around_;
};

bool Engine::run(std::size_t wanted, std::size_t most) {
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
    if (check_collapse(mesh_, chord) != Refusal::granted) {
      propose(best.v_t, &best);
      continue;
    }
    collapse(chord);
    --most;
  }
  return true;
}

// ---- the beginning

/// Scales the points by a power of two, which is exact, so that their box is about 1 wide. They stay where they are,
/// since only differences of points are used.
void Engine::place(std::span<const Point> points) {
  Point low{infinite, infinite, infinite};
  Point high{-infinite, -infinite, -infinite};
  for (Triangle t = 0; t < mesh_.triangle_bound(); ++t) {
    if (!mesh_.alive(t)) continue;
    for (const Vertex v : mesh_.corners(t)) {
      ++sites_[v].neighbors;
      const Point& p = points[v];
      if (!std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); })) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        low[i] = (std::min)(low[i], p[i]);
        high[i] = (std::max)(high[i], p[i]);
      }
    }
  }
  int exponent = -1;
  const double half = (std::max)({high[0] / 2 - low[0] / 2, high[1] / 2 - low[1] / 2, high[2] / 2 - low[2] / 2});
  if (half > 0 && std::isfinite(half)) (void)std::frexp(half, &exponent);
  for (Vertex v = 0; v < sites_.size(); ++v) sites_[v].point = enlarged(points[v], -exponent - 1);
}

Shape Engine::shape_of(Triangle t) const {
  const auto corners = mesh_.corners(t);
  const Point& a = sites_[corners[0]].point;
  return simplifying::shape_of(minus(sites_[corners[1]].point, a), minus(sites_[corners[2]].point, a));
}

void Engine::find_normals() {
  for (Triangle t = 0; t < mesh_.triangle_bound(); ++t)
    if (mesh_.alive(t)) original_[t] = shape_of(t).normal;
  // A triangle without area shall face as its neighbours do, once it has one.
  for (Triangle t = 0; t < mesh_.triangle_bound(); ++t) {
    if (!mesh_.alive(t) || dot(original_[t], original_[t]) > 0) continue;
    for_each_neighbor(mesh_, t, [&](Triangle other) { original_[t] = plus(original_[t], original_[other]); });
  }
}

/// Finds, for each component, the directions that all its triangles face: it is a height field along these.
void Engine::find_directions() {
  faces_.assign(mesh_.triangle_bound(), none);
  first_.assign(1, 0);
  std::vector<Triangle> component;
  for (Triangle start = 0; start < mesh_.triangle_bound(); ++start) {
    if (!mesh_.alive(start) || faces_[start] != none) continue;
    const auto number = static_cast<std::uint32_t>(first_.size() - 1);
    component.assign(1, start);
    faces_[start] = number;
    Vector sum{};
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

/// The direction from which the outline at a triangle is seen: height fields from above, others along the normal.
Vector Engine::direction_of(Triangle t) const {
  const std::uint32_t first = first_[faces_[t]];
  return first < first_[faces_[t] + 1] ? directions_[first] : original_[t];
}

void Engine::add_planes() {
  for (Triangle t = 0; t < mesh_.triangle_bound(); ++t) {
    if (!mesh_.alive(t)) continue;
    const Vector& normal = original_[t];
    const double squared = dot(normal, normal);
    const int exponent = squared > 0 ? shape_of(t).exponent : 0;
    for (unsigned side = 0; side < 3; ++side) {
      const Halfedge h = StripMesh::halfedge(t, side);
      const bool on_boundary = StripMesh::on_boundary(mesh_.opposite(h));
      if (on_boundary) ++sites_[mesh_.from(h)].neighbors;
      if (!(squared > 0)) continue;
      Site& from = sites_[mesh_.from(h)];
      Site& to = sites_[mesh_.to(h)];
      const double length = std::sqrt(squared);
      // normal / length is 1 long, the area is length / 2, but for what was enlarged
      from.quadric.add_plane(normal, std::ldexp(0.5 / length, -2 * exponent));
      from.quadric.area += std::ldexp(length / 2, -2 * exponent);
      if (!on_boundary) continue;
      const Vector up = direction_of(t);
      const Vector across = cross(minus(to.point, from.point), up);  // edge length times the length of `up` long
      const double weight = boundary_weight / dot(up, up);
      from.quadric.add_plane(across, weight);
      to.quadric.add_plane(across, weight);
    }
  }
}

/// Walks along the outlines; height fields are seen from above. A corner must be one both for its neighbours
/// and from afar, so that steps of a jagged outline, and points of a finely divided curve, are not corners.
void Engine::find_corners() {
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
      return minus(way, Vector{share * up[0], share * up[1], share * up[2]});
    };
    Vertex v = start;
    for (; on_outline(v) && sites_[v].mark != mark_; v = after(v)) {
      sites_[v].mark = mark_;
      loop.push_back(v);
      length.push_back(length.back() + length_of(seen(minus(sites_[after(v)].point, sites_[v].point))));
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

// ---- proposals

void Engine::begin(Stage stage) {
  stage_ = stage;
  queue_.clear();
  for (Vertex v = 0; v < sites_.size(); ++v)
    if (mesh_.spoke(v).id != none) propose(v);
}

/// Queues the cheapest permitted collapse of v, or the cheapest after one that was refused.
void Engine::propose(Vertex v, const Candidate* after) {
  Site& site = sites_[v];
  ++site.version;
  site.proposed = false;
  site.changed = false;
  site.hindered = after != nullptr;
  if (site.fixed || mesh_.non_manifold(v) || site.neighbors > Simplifier::most_neighbors) return;
  const bool on_outline = mesh_.leaves_boundary(mesh_.spoke(v));
  if (on_outline && (boundary_ == BoundaryPolicy::lock || (site.corner && stage_ != Stage::corners))) return;
  gather(v);
  for (std::size_t i = 0; i < fan_.size(); ++i) {
    Spoke& spoke = fan_[i];
    spoke.cost = infinite;
    if (on_outline && i != 0 && i + 1 != fan_.size()) continue;
    if (mesh_.non_manifold(spoke.to) || sites_[spoke.to].neighbors > Simplifier::most_neighbors) continue;
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
  std::push_heap(queue_.begin(), queue_.end(), later);
}

/// Fills fan_, counter-clockwise. The last spoke on the boundary has no triangle.
void Engine::gather(Vertex v) {
  fan_.clear();
  const Point& center = sites_[v].point;
  for_each_spoke(mesh_, v, [&](Halfedge h) {
    const Vertex to = mesh_.to(h);
    fan_.push_back({h, to, minus(sites_[to].point, center)});
  });
  fan_triangles_ = StripMesh::on_boundary(fan_.back().h) ? fan_.size() - 1 : fan_.size();
  for (std::size_t i = 0; i < fan_triangles_; ++i)
    fan_[i].shape = simplifying::shape_of(fan_[i].way, fan_[i + 1 < fan_.size() ? i + 1 : 0].way);
}

/// The cost of the collapse into a neighbour, or infinite if a triangle would turn over or lose its area.
double Engine::cost_of(const Quadric& quadric, std::size_t to) const {
  const Vector& way = fan_[to].way;
  const double turn = stage_ == Stage::careful ? careful_turn : 0;
  double worst = 1;
  double longest = 0;
  for (std::size_t i = 0; i < fan_triangles_; ++i) {
    const std::size_t j = i + 1 < fan_.size() ? i + 1 : 0;
    if (i == to || j == to) continue;  // is removed
    const Shape& before = fan_[i].shape;
    const Shape after = simplifying::shape_of(minus(fan_[i].way, way), minus(fan_[j].way, way));
    if (!(after.squared > flat * after.side * after.side)) {
      if (!(after.squared > 0)) {
        if (!(before.squared <= 0)) return infinite;
        continue;
      }
      if (before.squared > flat * before.side * before.side) return infinite;
    }
    if (before.squared > 0 && turns_by_more(after.normal, before.normal, turn)) return infinite;
    const Triangle t = StripMesh::triangle(fan_[i].h);
    const Vector& original = original_[t];
    if (dot(after.normal, original) <= 0 && dot(original, original) > 0) return infinite;
    if (!directions_.empty() && !keeps_direction(t, before, after)) return infinite;
    worst = (std::min)(worst, after.squared / (after.side * after.side));
    longest = (std::max)(longest, after.true_side);
  }
  return fan_[to].cost + shape_weight * longest / worst * quadric.area * quadric.scale();
}

/// Whether a triangle faces the directions of its component after a change, as far as it did before.
bool Engine::keeps_direction(Triangle t, const Shape& before, const Shape& after) const {
  for (std::uint32_t i = first_[faces_[t]]; i < first_[faces_[t] + 1]; ++i) {
    const double scale = parallel * dot(directions_[i], directions_[i]);
    const double d = dot(after.normal, directions_[i]);
    const double was = dot(before.normal, directions_[i]);
    const bool is_parallel = d * d <= scale * after.squared;
    const bool was_parallel = was * was <= scale * before.squared;
    if (is_parallel ? !was_parallel : d < 0) return false;
  }
  return true;
}

// ---- collapses

void Engine::collapse(Halfedge chord) {
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

std::vector<Obstacle> Engine::obstacles() {
  std::vector<Obstacle> found;
  const auto note = [&found](const char* why) {
    const auto same = std::find_if(found.begin(), found.end(), [&](const Obstacle& one) { return one.why == why; });
    ++(same == found.end() ? found.emplace_back(Obstacle{why}) : *same).edges;
  };
  const auto why = [this](Halfedge h) -> const char* {
    const Halfedge back = mesh_.opposite(h);
    const Site& from = sites_[mesh_.from(h)];
    const Site& to = sites_[mesh_.to(h)];
    if (mesh_.non_manifold(mesh_.from(h)) || mesh_.non_manifold(mesh_.to(h)))
      return describe(Refusal::non_manifold_vertex);
    if (from.neighbors > Simplifier::most_neighbors || to.neighbors > Simplifier::most_neighbors)
      return "a vertex has more than 256 neighbours";
    if (boundary_ == BoundaryPolicy::lock && (mesh_.leaves_boundary(h) || mesh_.leaves_boundary(back)))
      return "the boundary is locked";
    if (from.fixed && to.fixed) return "both ends stay where they are";
    const Refusal refusal = check_collapse(mesh_, h);
    return refusal != Refusal::granted ? describe(refusal) : "a triangle would turn over or lose its area";
  };
  static_assert(Simplifier::most_neighbors == 256);
  for (Triangle t = 0; t < mesh_.triangle_bound(); ++t)
    for (unsigned side = 0; side < 3 && mesh_.alive(t); ++side) {
      const Halfedge h = StripMesh::halfedge(t, side);
      if (h.id < mesh_.opposite(h).id) note(why(h));
    }
  std::stable_sort(found.begin(), found.end(), [](const Obstacle& a, const Obstacle& b) { return a.edges > b.edges; });
  return found;
}

std::size_t Engine::large_vertices() const noexcept {
  std::size_t n = 0;
  for (Vertex v = 0; v < sites_.size(); ++v)
    n += static_cast<std::size_t>(mesh_.spoke(v).id != none && sites_[v].neighbors > Simplifier::most_neighbors);
  return n;
}

}  // namespace simplifying

// ---- the interface

Simplifier::Simplifier(StripMesh mesh, std::span<const Point> points, BoundaryPolicy boundary,
                       std::span<const Vertex> fixed)
    : engine_(std::make_unique<simplifying::Engine>(std::move(mesh), points, boundary, fixed)) {}
Simplifier::~Simplifier() = default;
Simplifier::Simplifier(Simplifier&& other) noexcept = default;
Simplifier& Simplifier::operator=(Simplifier&& other) noexcept = default;

bool Simplifier::run(std::size_t wanted, std::size_t most) { return engine_->run(wanted, most); }
const StripMesh& Simplifier::mesh() const noexcept { return engine_->mesh(); }
const std::vector<SplitRecord>& Simplifier::collapses() const noexcept { return engine_->collapses(); }
std::vector<Obstacle> Simplifier::obstacles() { return engine_->obstacles(); }
std::size_t Simplifier::large_vertices() const noexcept { return engine_->large_vertices(); }

}  // namespace restrip::tools
