// StripLocator: labels and chunks. Included by strip_locator.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "restrip/mesh/invalid_coloring.hpp"
#include "restrip/search/strip_locator.hpp"

namespace restrip {

// Continues along the strip from t, which was entered over side `entry` (3: nowhere). While a patch is rewritten,
// strands that are not placed yet are skipped.
template <SidedMesh Mesh>
bool StripLocator::step(const Mesh& mesh, Triangle& t, unsigned& entry) const noexcept {
  if (pending_ != 0 && marks_[t] - first_end_ < ends_.size()) {
    for (std::uint32_t e = marks_[t] - first_end_; e != none; e = ends_[e].other) {
      const Strand& strand = strands_before_[ends_[e].strand];
      if (!strand.pending || StripMesh::side(ends_[e].at) == entry) continue;
      const Halfedge to = ends_[e].at == strand.in ? strand.out : strand.in;
      t = StripMesh::triangle(to);
      entry = StripMesh::side(to);
      return true;
    }
  }
  const StripStep<Halfedge> next = mesh.strip_step(StripMesh::halfedge(t, entry));
  t = StripMesh::triangle(next.in);
  entry = StripMesh::side(next.in);
  return next.goes_on;
}

inline StripLocator::Position StripLocator::position(Triangle t) const noexcept {
  RESTRIP_ASSERT(knows(t), "StripLocator::position", "the locator does not know the triangle");
  const Address address = addresses_[t];
  const auto& chunk = lists_[address.chunk];
  const Label label = chunk.backwards ? ~address.label : address.label;
  return {chunk.list, std::uint64_t{chunk.rank} << 32 | label};
}

// Whether labels of the chunk of h's triangle grow across the solid edge of h.
template <SidedMesh Mesh>
bool StripLocator::labels_grow(const Mesh& mesh, Halfedge h) const noexcept {
  const Address here = addresses_[StripMesh::triangle(h)];
  const Address there = addresses_[StripMesh::triangle(mesh.opposite(h))];
  if (here.chunk == there.chunk) return there.label > here.label;
  const auto& chunk = lists_[here.chunk];
  return (lists_[there.chunk].rank > chunk.rank) != chunk.backwards;
}

// Whether the end of a strip is its last triangle; true for an isolated triangle.
template <SidedMesh Mesh>
bool StripLocator::is_last(const Mesh& mesh, Triangle end) const noexcept {
  const Address address = addresses_[end];
  const auto& chunk = lists_[address.chunk];
  if (chunk.after != chunk.before) return chunk.after == none;
  Triangle before = end;
  unsigned entry = 3;
  if (!step(mesh, before, entry)) return true;
  return (addresses_[before].label < address.label) != chunk.backwards;
}

// Spreads the labels of a chunk evenly. Labels grow across h if `up`; h's triangle is a member.
template <SidedMesh Mesh>
void StripLocator::renumber(const Mesh& mesh, Halfedge h, bool up) {
  Triangle t = StripMesh::triangle(h);
  unsigned entry = StripMesh::side(h);
  const ChunkId c = addresses_[t].chunk;
  renumbered_.clear();
  do renumbered_.push_back(t);  // away from h, to the chunk's end
  while (step(mesh, t, entry) && addresses_[t].chunk == c);
  std::reverse(renumbered_.begin(), renumbered_.end());
  const Halfedge back = mesh.opposite(h);
  t = StripMesh::triangle(back);
  entry = StripMesh::side(back);
  while (addresses_[t].chunk == c) {
    renumbered_.push_back(t);
    if (!step(mesh, t, entry)) break;
  }
  const auto count = static_cast<Label>(renumbered_.size());
  const Label gap = std::min(label_step, middle_label / (count + 1));
  Label label = up ? middle_label - gap * (count / 2) : middle_label + gap * (count / 2);
  for (const Triangle member : renumbered_) {
    addresses_[member].label = label;
    label = up ? label + gap : label - gap;
  }
}

// Places nodes that follow h's triangle across h, one after the other, in its chunk. False if their labels do not fit,
// and the chunk must be renumbered.
inline bool StripLocator::append(Halfedge h, bool up, std::span<const Triangle> nodes) {
  const Triangle at = StripMesh::triangle(h);
  const ChunkId c = addresses_[at].chunk;
  lists_.count(c) += static_cast<std::uint32_t>(nodes.size());
  const std::uint64_t space = up ? ~addresses_[at].label : addresses_[at].label;
  const bool fits = space / label_step > nodes.size();
  Label label = addresses_[at].label;
  for (const Triangle t : nodes) {
    label = up ? label + label_step : label - label_step;
    addresses_[t] = {c, label};
  }
  return fits;
}

// Cuts the strip between the triangles of a and b: b's follows a's across a, though triangles of a patch may have been
// between them.
template <SidedMesh Mesh>
void StripLocator::separate(const Mesh& mesh, Halfedge a, bool up_a, Halfedge b) {
  const ChunkId c = addresses_[StripMesh::triangle(a)].chunk;
  const bool a_first = up_a != lists_[c].backwards;
  if (c != addresses_[StripMesh::triangle(b)].chunk) return lists_.cut(c, a_first);
  // Inside one chunk: the smaller part, found by walking both ways at once, moves to a new chunk.
  Triangle at[2] = {StripMesh::triangle(a), StripMesh::triangle(b)};
  unsigned entry[2] = {StripMesh::side(a), StripMesh::side(b)};
  std::vector<Triangle>* const part[2] = {&moving_, &renumbered_};
  part[0]->clear();
  part[1]->clear();
  unsigned smaller = 0;
  for (;; smaller ^= 1U) {
    part[smaller]->push_back(at[smaller]);
    if (!step(mesh, at[smaller], entry[smaller]) || addresses_[at[smaller]].chunk != c) break;
  }
  move_to(lists_.cut_off(c, a_first != (smaller == 0)), c, *part[smaller]);
}

inline void StripLocator::move_to(ChunkId to, ChunkId from, std::span<const Triangle> nodes) noexcept {
  for (const Triangle t : nodes) addresses_[t].chunk = to;
  lists_.count(to) += static_cast<std::uint32_t>(nodes.size());
  lists_.count(from) -= static_cast<std::uint32_t>(nodes.size());
}

// Divides a chunk that has grown too large into pieces, in one pass from one of its ends to the other.
template <SidedMesh Mesh>
void StripLocator::divide(const Mesh& mesh, Triangle member) {
  const ChunkId c = addresses_[member].chunk;
  Triangle t = member;
  Triangle last = none;
  unsigned entry = 3;
  do {
    last = t;
  } while (step(mesh, t, entry) && addresses_[t].chunk == c);
  // `last` is an end of the chunk; come back from it over the side towards the chunk.
  t = last;
  const auto inside = [&](unsigned side) {
    const Halfedge h = StripMesh::halfedge(t, side);
    return mesh.solid(h) && addresses_[StripMesh::triangle(mesh.opposite(h))].chunk == c;
  };
  unsigned s = 0;
  while (!inside(s)) ++s;
  entry = (s + 1) % 3;
  if (!mesh.solid(StripMesh::halfedge(t, entry))) entry = (s + 2) % 3;
  while (lists_[c].count > chunk_limit_) {
    const std::uint32_t piece = std::min(lists_[c].count / 2, chunk_limit_ / 2);
    moving_.clear();
    while (moving_.size() < piece) {
      moving_.push_back(t);
      step(mesh, t, entry);
    }
    const bool piece_first = (addresses_[last].label < addresses_[t].label) != lists_[c].backwards;
    move_to(lists_.add_next_to(c, !piece_first), c, moving_);
  }
}

// Merges the two chunks at the solid edge of h if they are small, into the chunk of h's triangle.
template <SidedMesh Mesh>
void StripLocator::join_chunks(const Mesh& mesh, Halfedge h) {
  const Halfedge back = mesh.opposite(h);
  const ChunkId keep = addresses_[StripMesh::triangle(h)].chunk;
  const ChunkId gone = addresses_[StripMesh::triangle(back)].chunk;
  if (keep == gone || lists_[keep].count + lists_[gone].count > chunk_limit_ * 3 / 4) return;
  if (lists_[keep].count < lists_[gone].count) {
    join_chunks(mesh, back);
    return;
  }
  if (lists_[gone].count > chunk_limit_ / 8) return;
  const bool up = labels_grow(mesh, h);
  moving_.clear();
  Triangle t = StripMesh::triangle(back);
  unsigned entry = StripMesh::side(back);
  do moving_.push_back(t);
  while (step(mesh, t, entry) && addresses_[t].chunk == gone);
  lists_.erase(gone);
  if (!append(h, up, moving_)) renumber(mesh, h, up);
}

template <SidedMesh Mesh>
void StripLocator::cut(Mesh& mesh, Halfedge h) {
  RESTRIP_ASSERT(mesh.alive(h), "StripLocator::cut", describe(Refusal::no_such_edge));
  RESTRIP_ASSERT(mesh.solid(h), "StripLocator::cut", "the dual edge is dashed already");
  const bool up = labels_grow(mesh, h);
  mesh.set_solid(h, false);
  separate(mesh, h, up, mesh.opposite(h));
}

template <SidedMesh Mesh>
void StripLocator::link(Mesh& mesh, Halfedge h) {
  RESTRIP_ASSERT(mesh.alive(h), "StripLocator::link", describe(Refusal::no_such_edge));
  RESTRIP_ASSERT(!StripMesh::on_boundary(h) && !StripMesh::on_boundary(mesh.opposite(h)), "StripLocator::link",
                 describe(Refusal::boundary_edge));
  RESTRIP_ASSERT(!mesh.solid(h), "StripLocator::link", "the dual edge is solid already");
  RESTRIP_ASSERT(
      mesh.solid_degree(StripMesh::triangle(h)) < 2 && mesh.solid_degree(StripMesh::triangle(mesh.opposite(h))) < 2,
      "StripLocator::link", "a triangle at the dual edge is not the end of a strip");
  RESTRIP_ASSERT(position(StripMesh::triangle(h)).strip != position(StripMesh::triangle(mesh.opposite(h))).strip,
                 "StripLocator::link", "the dual edge joins the two ends of one strip");
  const Triangle a = StripMesh::triangle(h);
  const Triangle b = StripMesh::triangle(mesh.opposite(h));
  lists_.join(addresses_[a].chunk, is_last(mesh, a), addresses_[b].chunk, is_last(mesh, b));
  mesh.set_solid(h, true);
  join_chunks(mesh, h);
}

inline std::uint32_t StripLocator::chunk_limit_for_long_strips(std::size_t triangles) noexcept {
  return std::clamp(static_cast<std::uint32_t>(std::sqrt(static_cast<double>(triangles)) / 2), default_chunk_limit,
                    room_for_labels);
}

inline void StripLocator::reserve(std::size_t triangles) {
  addresses_.reserve(triangles);
  marks_.reserve(triangles);
  lists_.reserve(triangles / 16, triangles / 16);
}

template <SidedMesh Mesh>
void StripLocator::rebuild(const Mesh& mesh) {
  addresses_.assign(mesh.triangle_bound(), {});
  marks_.assign(mesh.triangle_bound(), 0);
  mark_ = 0;
  ends_.clear();
  crowded_.clear();
  pending_ = 0;
  lists_.clear();
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.alive(t) && mesh.solid_degree(t) > 2) detail::throw_three_solid_edges();
  std::vector<Triangle> strip;
  std::size_t placed = 0;
  for (Triangle start = 0; start < mesh.triangle_bound(); ++start) {
    if (!mesh.alive(start) || addresses_[start].chunk != none || mesh.solid_degree(start) > 1) continue;
    strip.clear();
    Triangle t = start;
    unsigned entry = 3;
    do strip.push_back(t);
    while (step(mesh, t, entry));
    placed += strip.size();
    ChunkId last = none;
    for (std::size_t i = 0; i < strip.size();) {
      const std::size_t n = std::min<std::size_t>(chunk_limit_ / 2, strip.size() - i);
      const ChunkId c = last == none ? lists_.add() : lists_.add_next_to(last, true);
      lists_.count(c) = static_cast<std::uint32_t>(n);
      for (std::size_t j = 0; j < n; ++j)
        addresses_[strip[i + j]] = {c, static_cast<Label>(middle_label + label_step * (j - n / 2))};
      last = c;
      i += n;
    }
  }
  // If no triangle has three solid edges, a strip without an end is a cycle.
  if (placed != mesh.triangle_count()) detail::throw_solid_cycle();
}

}  // namespace restrip
