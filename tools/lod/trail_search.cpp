#include "lod/trail_search.hpp"

#include <algorithm>

#include "restrip/mesh/walks.hpp"

namespace restrip::tools {
namespace {

constexpr std::uint8_t far = 255;
static_assert(2 * TrailSearch::longest + 1 < far);

// Up to here measuring distances costs more than it saves.
constexpr unsigned short_trail = 7;

}  // namespace

bool TrailSearch::join(StripMesh& mesh, StripLocator& locator, const std::vector<Triangle>& ends,
                       std::size_t max_states) {
  mesh_ = &mesh;
  locator_ = &locator;
  const std::size_t bound = mesh.triangle_bound();
  if (distance_.size() < bound) {
    distance_.resize(bound + bound / 2, far);
    on_trail_.resize(4 * distance_.size(), 0);
  }
  trail_.clear();
  last_state_ = states_ + max_states;
  bool joined = false;
  pruning_ = false;
  for (unsigned solid = 0; solid <= longest && !joined && states_ < last_state_; ++solid) {
    if (solid == short_trail + 1) measure_distances(ends);
    for (const Triangle end : ends) {
      joined = mesh.solid_degree(end) < 2 && walk_on(end, solid);
      if (joined) break;
    }
  }
  for (const Triangle t : measured_) distance_[t] = far;
  measured_.clear();
  if (joined) commit();
  return joined;
}

// Distances to the strip ends within reach of the longest trail from `ends`.
void TrailSearch::measure_distances(const std::vector<Triangle>& ends) {
  pruning_ = true;
  std::vector<Triangle> targets;
  const auto spread = [&](const std::vector<Triangle>& from) {
    for (const Triangle t : measured_) distance_[t] = far;
    measured_.clear();
    for (const Triangle t : from) {
      if (distance_[t] == 0) continue;
      distance_[t] = 0;
      measured_.push_back(t);
    }
    for (std::size_t i = 0; i < measured_.size(); ++i) {
      const Triangle t = measured_[i];
      if (distance_[t] == 2 * longest + 1) break;
      for_each_neighbor(*mesh_, t, [&](Triangle u) {
        if (distance_[u] != far) return;
        distance_[u] = static_cast<std::uint8_t>(distance_[t] + 1);
        measured_.push_back(u);
      });
    }
  };
  spread(ends);
  for (const Triangle t : measured_)
    if (mesh_->solid_degree(t) < 2) targets.push_back(t);
  spread(targets);
}

// All trails that go on from `end` with at most that many solid edges more. True with the trail in trail_.
bool TrailSearch::walk_on(Triangle end, unsigned solid_left) {
  if (states_ >= last_state_) return false;
  for (unsigned side = 0; side < 3; ++side) {
    const Halfedge link = StripMesh::halfedge(end, side);
    if (mesh_->solid(link) || on_trail_[link.id] != 0) continue;
    const Halfedge there = mesh_->opposite(link);
    if (StripMesh::on_boundary(there)) continue;
    const Triangle x = StripMesh::triangle(there);
    const bool arrives = mesh_->solid_degree(x) < 2;
    if (x == end || (!arrives && solid_left == 0)) continue;
    ++states_;
    toggle(link);
    if (arrives && closes_no_cycle()) return true;
    for (unsigned turn = 1; turn < 3 && solid_left != 0; ++turn) {
      const Halfedge cut = StripMesh::halfedge(x, (StripMesh::side(there) + turn) % 3);
      if (!mesh_->solid(cut) || on_trail_[cut.id] != 0) continue;
      const Triangle y = StripMesh::triangle(mesh_->opposite(cut));
      if (pruning_ && distance_[y] > 2 * solid_left - 1) continue;
      toggle(cut);
      if (walk_on(y, solid_left - 1)) return true;
      take_back();
    }
    take_back();
  }
  return false;
}

void TrailSearch::toggle(Halfedge h) {
  mesh_->set_solid(h, !mesh_->solid(h));
  on_trail_[h.id] = on_trail_[mesh_->opposite(h).id] = 1;
  trail_.push_back(h);
}

void TrailSearch::take_back() {
  const Halfedge h = trail_.back();
  trail_.pop_back();
  mesh_->set_solid(h, !mesh_->solid(h));
  on_trail_[h.id] = on_trail_[mesh_->opposite(h).id] = 0;
}

TrailSearch::Cut TrailSearch::place_of(Triangle t) const {
  const StripLocator::Position at = locator_->position(t);
  return {at.strip, at.order};
}

// The piece that a triangle is in, as a number into pieces_.
std::size_t TrailSearch::piece_of(Triangle t) {
  const Cut at = place_of(t);
  const auto number = static_cast<std::size_t>(std::upper_bound(cuts_.begin(), cuts_.end(), at) - cuts_.begin());
  std::size_t i = 0;
  while (i < pieces_.size() && (pieces_[i].strip != at.strip || pieces_[i].number != number)) ++i;
  if (i == pieces_.size()) pieces_.push_back({at.strip, number, i});
  while (pieces_[i].joined != i) i = pieces_[i].joined;
  return i;
}

// The locator has the strips as they were before the trail: cut them at its solid edges, and join the pieces at its
// dashed ones.
bool TrailSearch::closes_no_cycle() {
  cuts_.clear();
  pieces_.clear();
  for (std::size_t i = 1; i < trail_.size(); i += 2)
    cuts_.push_back(
        std::max(place_of(StripMesh::triangle(trail_[i])), place_of(StripMesh::triangle(mesh_->opposite(trail_[i])))));
  std::sort(cuts_.begin(), cuts_.end());
  for (std::size_t i = 0; i < trail_.size(); i += 2) {
    const std::size_t a = piece_of(StripMesh::triangle(trail_[i]));
    const std::size_t b = piece_of(StripMesh::triangle(mesh_->opposite(trail_[i])));
    if (a == b) return false;
    pieces_[a].joined = b;
  }
  return true;
}

// Flips the trail in colours and locator alike. Whatever part of a valid colouring is linked first is valid.
void TrailSearch::commit() {
  const std::vector<Halfedge> trail = trail_;
  while (!trail_.empty()) take_back();
  trail_ = trail;
  for (std::size_t i = 1; i < trail_.size(); i += 2) locator_->cut(*mesh_, trail_[i]);
  for (std::size_t i = 0; i < trail_.size(); i += 2) locator_->link(*mesh_, trail_[i]);
}

}  // namespace restrip::tools
