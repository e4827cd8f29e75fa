// From a mesh to a progressive mesh: the edge with the least quadric error is collapsed, again and again (Garland and
// Heckbert, "Surface simplification using quadric error metrics", 1997). One end of the edge keeps its place, so points
// never move. Vertices on the boundary are never removed. For meshes that a visitor drops on the page; programs use
// `restrip simplify`.
#pragma once

#include <cmath>
#include <queue>

#include "progressive.hpp"

namespace restrip::web {

using Vec = Vector<double>;

/// The squared distances to some planes, as a function of a point.
struct Quadric {
  std::array<double, 10> q{};
  void add_plane(const Vec& n, double d) noexcept {
    const std::array<double, 4> p{n.x, n.y, n.z, d};
    std::size_t at = 0;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i; j < 4; ++j) q[at++] += p[i] * p[j];
  }
  void add(const Quadric& other) noexcept {
    for (std::size_t i = 0; i < q.size(); ++i) q[i] += other.q[i];
  }
  [[nodiscard]] double at(const Vec& v) const noexcept {
    return q[0] * v.x * v.x + q[4] * v.y * v.y + q[7] * v.z * v.z + q[9] +
           2 * (q[1] * v.x * v.y + q[2] * v.x * v.z + q[3] * v.x + q[5] * v.y * v.z + q[6] * v.y + q[8] * v.z);
  }
};

class Simplifier {
 public:
  /// `points`: three coordinates each.
  Simplifier(std::vector<float> points, std::span<const Corners> triangles)
      : points_(std::move(points)), mesh_(StripMesh::build(triangles, points_.size() / 3, &report_)) {
    quadrics_.resize(points_.size() / 3);
    version_.resize(points_.size() / 3, 0);
    for (Triangle t = 0; t < mesh_.triangle_bound(); ++t) {
      const auto [a, b, c] = mesh_.corners(t);
      const Vec n = normal(a, b, c);
      for (const Vertex v : {a, b, c}) quadrics_[v].add_plane(n, -dot(n, at(a)));
    }
    for (Vertex v = 0; v < mesh_.vertex_bound(); ++v)
      if (mesh_.spoke(v).id != none) propose(v);
  }

  /// Collapses edges until `wanted` triangles are left, or no edge can be collapsed; at most `most` attempts. Returns
  /// the excess of triangles; 0 when it has ended.
  [[nodiscard]] std::size_t run(std::size_t wanted, std::size_t most) {
    while (mesh_.triangle_count() > wanted && !queue_.empty()) {
      if (most-- == 0) return mesh_.triangle_count() - wanted;
      const Candidate best = queue_.top();
      queue_.pop();
      if (best.version != version_[best.v_t] || mesh_.spoke(best.v_t).id == none) continue;
      const Halfedge chord = mesh_.spoke(best.v_s, best.v_t);
      if (chord.id == none || !allowed(chord)) {
        // Another edge of v_t may still be possible; after the next change around it v_t is proposed again.
        if (best.tries + 1 < spoke_count(mesh_, best.v_t)) propose(best.v_t, best.tries + 1);
        continue;
      }
      splits_.push_back(
          {best.v_s, best.v_t, mesh_.to(StripMesh::next(chord)), mesh_.to(StripMesh::next(mesh_.opposite(chord)))});
      quadrics_[best.v_s].add(quadrics_[best.v_t]);
      mesh_.remove_vertex(chord);
      around_.clear();
      around_.push_back(best.v_s);
      for_each_spoke(mesh_, best.v_s, [&](Halfedge h) { around_.push_back(mesh_.to(h)); });
      for (const Vertex v : around_) {
        ++version_[v];
        propose(v);
      }
    }
    return 0;
  }
  /// The simplified mesh.
  [[nodiscard]] Progressive result() const {
    Progressive out{{}, {splits_.rbegin(), splits_.rend()}, points_.size() / 3};
    for (Triangle t = 0; t < mesh_.triangle_bound(); ++t)
      if (mesh_.alive(t)) out.base.push_back(mesh_.corners(t));
    return out;
  }
  [[nodiscard]] const std::vector<float>& points() const noexcept { return points_; }
  [[nodiscard]] const BuildReport& report() const noexcept { return report_; }

 private:
  struct Candidate {
    double error = 0;
    Vertex v_s = none;
    Vertex v_t = none;
    std::uint32_t version = 0;
    std::size_t tries = 0;
    friend bool operator<(const Candidate& a, const Candidate& b) noexcept {
      return a.error != b.error ? a.error > b.error : a.v_t > b.v_t;  // the queue's top is the least
    }
  };
  static constexpr std::size_t most_spokes = 32;

  [[nodiscard]] Vec at(Vertex v) const noexcept {
    return {points_[3 * std::size_t{v}], points_[3 * std::size_t{v} + 1], points_[3 * std::size_t{v} + 2]};
  }
  [[nodiscard]] Vec normal(Vertex a, Vertex b, Vertex c) const noexcept {
    const Vec n = cross(at(b) - at(a), at(c) - at(a));
    const double length = std::sqrt(dot(n, n));
    return length > 0 ? Vec{n.x / length, n.y / length, n.z / length} : Vec{};
  }
  /// Queues the cheapest edge over which v may be removed, or the next one after `skip` have failed.
  void propose(Vertex v, std::size_t skip = 0) {
    if (mesh_.non_manifold(v) || mesh_.leaves_boundary(mesh_.spoke(v))) return;
    costs_.clear();
    for_each_spoke(mesh_, v, [&](Halfedge h) {
      Quadric both = quadrics_[v];
      both.add(quadrics_[mesh_.to(h)]);
      const Vec edge = at(mesh_.to(h)) - at(v);
      costs_.push_back({both.at(at(mesh_.to(h))) + 1e-9 * dot(edge, edge), mesh_.to(h), v, version_[v], skip});
    });
    std::sort(costs_.begin(), costs_.end(), [](const Candidate& a, const Candidate& b) {
      return a.error != b.error ? a.error < b.error : a.v_s < b.v_s;
    });
    if (skip < costs_.size()) queue_.push(costs_[skip]);
  }
  [[nodiscard]] bool allowed(Halfedge chord) const {
    if (check_collapse(mesh_, chord) != Refusal::granted) return false;
    const Vertex v_s = mesh_.from(chord);
    const Vertex v_t = mesh_.to(chord);
    if (spoke_count(mesh_, v_s) + spoke_count(mesh_, v_t) > most_spokes + 4) return false;
    bool turned = false;
    for_each_spoke(mesh_, v_t, [&](Halfedge h) {
      const Vertex a = mesh_.to(h);
      const Vertex b = mesh_.to(StripMesh::next(h));
      if (a == v_s || b == v_s) return;
      const Vec before = normal(v_t, a, b);
      const Vec after = normal(v_s, a, b);
      if (dot(before, after) < 0.2 && dot(before, before) > 0) turned = true;
    });
    return !turned;
  }

  std::vector<float> points_;
  BuildReport report_;
  StripMesh mesh_;
  std::vector<Record> splits_;  // the finest first
  std::vector<Quadric> quadrics_;
  std::vector<std::uint32_t> version_;
  std::priority_queue<Candidate> queue_;
  std::vector<Candidate> costs_;
  std::vector<Vertex> around_;
};

}  // namespace restrip::web
