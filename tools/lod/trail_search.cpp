#include "lod/trail_search.hpp"

#include <algorithm>

#include "restrip/mesh/walks.hpp"

namespace restrip::tools {

ComponentStrips::ComponentStrips(const StripMesh& mesh) : component_(mesh.triangle_bound(), none) {
  std::vector<Triangle> met;
  for (Triangle start = 0; start < mesh.triangle_bound(); ++start) {
    if (!mesh.alive(start) || component_[start] != none) continue;
    const auto number = static_cast<std::uint32_t>(components_.size());
    met.assign(1, start);
    component_[start] = number;
    for (std::size_t i = 0; i < met.size(); ++i)
      for_each_neighbor(mesh, met[i], [&](Triangle t) {
        if (component_[t] == none) met.push_back(t);
        component_[t] = number;
      });
    components_.push_back({0, tips(mesh, met)});
    needed_ += components_.back().needed();
  }
  recount(mesh);
}

std::ptrdiff_t ComponentStrips::tips(const StripMesh& mesh, const std::vector<Triangle>& patch) {
  std::ptrdiff_t tips = 0;
  for (const Triangle t : patch) {
    unsigned neighbors = 0;
    for_each_neighbor(mesh, t, [&](Triangle) { ++neighbors; });
    tips += neighbors < 2 ? 1 : 0;
  }
  return tips;
}

void ComponentStrips::recount(const StripMesh& mesh) {
  std::vector<std::ptrdiff_t> ends(components_.size(), 0);
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.alive(t)) ends[component_[t]] += 2 - static_cast<std::ptrdiff_t>(mesh.solid_degree(t));
  for (std::size_t i = 0; i < components_.size(); ++i) components_[i].strips = ends[i] / 2;
}

void ComponentStrips::before_split(const StripMesh& mesh, const std::vector<Triangle>& patch) {
  split_ = component_[patch.front()];
  Component& component = components_[split_];
  needed_ -= component.needed();
  component.tips -= tips(mesh, patch);
}

void ComponentStrips::after_split(const StripMesh& mesh, const std::vector<Triangle>& patch) {
  component_.resize(mesh.triangle_bound(), none);
  for (const Triangle t : patch) component_[t] = split_;
  Component& component = components_[split_];
  component.tips += tips(mesh, patch);
  needed_ += component.needed();
}

namespace {

// Trails are measured up to this many solid edges first, then up to twice that number.
constexpr unsigned first_radius = 4;

}  // namespace

bool TrailSearch::join(StripMesh& mesh, StripLocator& locator, const std::vector<Triangle>& ends,
                       std::size_t max_states) {
  mesh_ = &mesh;
  locator_ = &locator;
  const std::size_t bound = mesh.triangle_bound();
  if (distances_.size() < bound) {
    distances_.resize(bound + bound / 2);
    on_trail_.resize(4 * distances_.size(), 0);
  }
  trail_.clear();
  last_state_ = states_ + max_states;
  bool joined = false;
  unsigned radius = 0;
  for (unsigned solid = 0; solid <= longest && !joined && states_ < last_state_; ++solid) {
    if (solid == 0 || solid > radius) {
      radius = std::min(longest, std::max(first_radius, 2 * radius));
      measure(ends, radius);
    }
    for (const Triangle end : ends) {
      if (mesh.solid_degree(end) > 1) continue;
      not_to_ = mesh.solid_degree(end) == 1 ? end : none;
      joined = solid_edges_from(end) <= solid && walk_on(end, solid);
      if (joined) break;
    }
  }
  forget_distances();
  if (!joined) return false;
  // Flips the trail in both colours and locator. Cuts come first, since any part of a valid colouring is valid.
  const std::vector<Halfedge> trail = trail_;
  while (!trail_.empty()) take_back();
  trail_ = trail;
  for (std::size_t i = 1; i < trail_.size(); i += 2) locator_->cut(mesh, trail_[i]);
  for (std::size_t i = 0; i < trail_.size(); i += 2) locator_->link(mesh, trail_[i]);
  return true;
}

// ---- distances to the ends

// Calls visit(x) for each triangle adjacent to t across a solid edge, or across a dashed edge.
template <class Visit>
void TrailSearch::for_each_neighbor(Triangle t, bool solid, Visit&& visit) const {
  const unsigned sides = solid ? mesh_->solid_sides(t) : 7U & ~mesh_->solid_sides(t);
  for (unsigned side = 0; side < 3; ++side) {
    if ((sides >> side & 1U) == 0) continue;
    const Halfedge there = mesh_->opposite(StripMesh::halfedge(t, side));
    if (!StripMesh::on_boundary(there) && StripMesh::triangle(there) != t) visit(StripMesh::triangle(there));
  }
}

// For each triangle that a trail of at most `radius` solid edges from one of `ends` leaves across a dashed edge: a
// lower bound of the solid edges still needed. It measures alternating walks, which may pass an edge twice, so
// breadth-first search suffices: one search from `ends` finds the ends that trails can reach, and one runs back from
// there.
void TrailSearch::measure(const std::vector<Triangle>& ends, unsigned radius) {
  forget_distances();
  targets_.clear();
  const auto reach = [this](Triangle t, unsigned solid) {
    if (distances_[t].here != far) return;
    distances_[t].here = static_cast<std::uint8_t>(solid);
    met_.push_back(t);
  };
  for (const Triangle end : ends)
    if (mesh_->solid_degree(end) < 2) reach(end, 0);
  for (std::size_t i = 0; i < met_.size() && states_ < last_state_; ++i, ++states_) {
    const Triangle y = met_[i];
    for_each_neighbor(y, false, [&](Triangle x) {
      if (mesh_->solid_degree(x) < 2) targets_.push_back(x);
      if (distances_[y].here < radius)
        for_each_neighbor(x, true, [&](Triangle z) { reach(z, distances_[y].here + 1U); });
    });
  }
  std::sort(targets_.begin(), targets_.end());
  targets_.erase(std::unique(targets_.begin(), targets_.end()), targets_.end());
  back_.clear();
  const auto lead = [&](Triangle t, unsigned solid, Triangle target) {
    EndDistances& known = distances_[t];
    if (known.here + solid > radius || known.second != far || (known.first != far && known.target == target)) return;
    if (known.first == far) known.target = target;
    (known.first == far ? known.first : known.second) = static_cast<std::uint8_t>(solid);
    back_.push_back({t, target, solid});
  };
  for (const Triangle target : targets_) for_each_neighbor(target, false, [&](Triangle y) { lead(y, 0, target); });
  for (std::size_t i = 0; i < back_.size() && states_ < last_state_; ++i, ++states_) {
    const Arrival at = back_[i];
    for_each_neighbor(at.triangle, true, [&](Triangle x) {
      for_each_neighbor(x, false, [&](Triangle y) { lead(y, at.solid + 1, at.target); });
    });
  }
}

void TrailSearch::forget_distances() {
  for (const Triangle t : met_) distances_[t] = {};
  met_.clear();
}

// A trail may return to the end at which it begins only if that end is an isolated triangle.
unsigned TrailSearch::solid_edges_from(Triangle t) const {
  const EndDistances& known = distances_[t];
  return known.target == not_to_ ? known.second : known.first;
}

// ---- trails

// Tries all trails that continue from `end` with at most `solid_left` more solid edges. True with the trail in trail_.
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
      if (solid_edges_from(y) >= solid_left) continue;
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

// The piece that contains a triangle, as an index into pieces_.
std::size_t TrailSearch::piece_of(Triangle t) {
  const Cut at = place_of(t);
  const auto number = static_cast<std::size_t>(std::upper_bound(cuts_.begin(), cuts_.end(), at) - cuts_.begin());
  std::size_t i = 0;
  while (i < pieces_.size() && (pieces_[i].strip != at.strip || pieces_[i].number != number)) ++i;
  if (i == pieces_.size()) pieces_.push_back({at.strip, number, i});
  while (pieces_[i].joined != i) i = pieces_[i].joined;
  return i;
}

// The locator has the strips as they were before the trail. This cuts them at the trail's solid edges and joins the
// pieces at its dashed ones.
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

}  // namespace restrip::tools
