// StripLocator, member by member. Included by strip_locator.hpp.
#pragma once

#include <algorithm>
#include <utility>

#include "restrip/output/strips.hpp"
#include "restrip/search/impl/strip_locator.hpp"

namespace restrip {

// Continues along the strip from t, which was entered over side `entry` (3: nowhere). While a patch is rewritten,
// strands that are not placed yet are skipped.
bool StripLocator::step(const SidedMesh auto& mesh, Triangle& t, unsigned& entry) const noexcept {
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
  const StripStep next = mesh.strip_step(StripMesh::halfedge(t, entry));
  t = StripMesh::triangle(next.in);
  entry = StripMesh::side(next.in);
  return next.continues;
}

// Whether labels of the chunk of h's triangle grow across the solid edge of h.
bool StripLocator::labels_grow(const SidedMesh auto& mesh, Halfedge h) const noexcept {
  const Address here = addresses_[StripMesh::triangle(h)];
  const Address there = addresses_[StripMesh::triangle(mesh.opposite(h))];
  if (here.chunk == there.chunk) return there.label > here.label;
  const auto& chunk = lists_[here.chunk];
  return (lists_[there.chunk].rank > chunk.rank) != chunk.backwards;
}

// Whether the end of a strip is its last triangle; true for an isolated triangle.
bool StripLocator::is_last(const SidedMesh auto& mesh, Triangle end) const noexcept {
  const Address address = addresses_[end];
  const auto& chunk = lists_[address.chunk];
  if (chunk.after != chunk.before) return chunk.after == none;
  Triangle before = end;
  unsigned entry = 3;
  if (!step(mesh, before, entry)) return true;
  return (addresses_[before].label < address.label) != chunk.backwards;
}

// Spreads the labels of a chunk evenly. Labels grow across h if `up`; h's triangle is a member.
void StripLocator::renumber(const SidedMesh auto& mesh, Halfedge h, bool up) {
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
  const Label gap = (std::min)(label_step, middle_label / (count + 1));
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
void StripLocator::separate(const SidedMesh auto& mesh, Halfedge a, bool up_a, Halfedge b) {
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
void StripLocator::divide(const SidedMesh auto& mesh, Triangle member) {
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
    const std::uint32_t piece = (std::min)(lists_[c].count / 2, chunk_limit_ / 2);
    moving_.clear();
    while (moving_.size() < piece) {
      moving_.push_back(t);
      step(mesh, t, entry);
    }
    const bool piece_first = (addresses_[last].label < addresses_[t].label) != lists_[c].backwards;
    move_to(lists_.add_next_to(c, !piece_first), c, moving_);
  }
}

void StripLocator::cut(SidedMesh auto& mesh, Halfedge h) {
  RESTRIP_ASSERT(mesh.alive(h), "StripLocator::cut", describe(Refusal::no_such_edge));
  RESTRIP_ASSERT(mesh.solid(h), "StripLocator::cut", "the dual edge is dashed already");
  const bool up = labels_grow(mesh, h);
  mesh.set_solid(h, false);
  separate(mesh, h, up, mesh.opposite(h));
}

void StripLocator::link(SidedMesh auto& mesh, Halfedge h) {
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
  // Two small chunks become one, the larger of them.
  Halfedge back = mesh.opposite(h);
  if (lists_[addresses_[a].chunk].count < lists_[addresses_[b].chunk].count) std::swap(h, back);
  const ChunkId keep = addresses_[StripMesh::triangle(h)].chunk;
  const ChunkId gone = addresses_[StripMesh::triangle(back)].chunk;
  if (lists_[keep].count + lists_[gone].count > chunk_limit_ * 3 / 4 || lists_[gone].count > chunk_limit_ / 8) return;
  const bool up = labels_grow(mesh, h);
  moving_.clear();
  Triangle t = StripMesh::triangle(back);
  unsigned entry = StripMesh::side(back);
  do moving_.push_back(t);
  while (step(mesh, t, entry) && addresses_[t].chunk == gone);
  lists_.erase(gone);
  if (!append(h, up, moving_)) renumber(mesh, h, up);
}

void StripLocator::rebuild(const SidedMesh auto& mesh) {
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

// ---- local rewrites
//
// Outside the patch nothing moves, and a rewrite joins nothing there that was not joined before. So a strip that passes
// through keeps its order, and its new triangles inside the patch get labels between the labels of its two outside
// neighbours. A strip that is interrupted is cut between them. A strand that ends in the patch is appended to its
// strip. A strand that lies entirely in the patch is a new strip.

// Splits the solid edges of a patch into paths.
void StripLocator::find_strands(const SidedMesh auto& mesh, std::span<const Triangle> patch,
                                std::vector<Strand>& strands) {
  strands.clear();
  strand_nodes_.clear();
  if (marks_.size() < mesh.triangle_bound()) marks_.resize(mesh.triangle_bound(), 0);
  const std::uint32_t waiting = ++mark_;
  const std::uint32_t done = ++mark_;
  for (const Triangle t : patch) marks_[t] = waiting;
  // Adds the nodes of a path after t, up to its end in the patch. Returns the halfedge that leads back into the patch,
  // if the path continues.
  const auto follow = [&](Triangle t, unsigned entry) -> Halfedge {
    while (step(mesh, t, entry)) {
      if (marks_[t] != waiting) return marks_[t] == done ? Halfedge{} : StripMesh::halfedge(t, entry);
      marks_[t] = done;
      strand_nodes_.push_back(t);
    }
    return {};
  };
  for (const Triangle start : patch) {
    if (marks_[start] == done) continue;
    Strand strand;
    strand.first = static_cast<std::uint32_t>(strand_nodes_.size());
    // One way to its end, then back through the start to the other end: the nodes come in order.
    marks_[start] = done;
    strand_nodes_.push_back(start);
    strand.in = follow(start, 3);
    std::reverse(strand_nodes_.begin() + static_cast<std::ptrdiff_t>(strand.first), strand_nodes_.end());
    if (mesh.solid_degree(start) == 2)
      strand.out = follow(start, StripMesh::side(detail::lowest_side(start, mesh.solid_sides(start))));
    strand.last = static_cast<std::uint32_t>(strand_nodes_.size());
    if (strand.in.id == none) {  // `in` is set if either is
      std::swap(strand.in, strand.out);
      std::reverse(strand_nodes_.begin() + static_cast<std::ptrdiff_t>(strand.first), strand_nodes_.end());
    }
    strands.push_back(strand);
  }
}

void StripLocator::before_patch(const SidedMesh auto& mesh, std::span<const Triangle> patch) {
  // Marks that this rewrite needs: two for the patch before and two after it, two for the ends of each strand.
  if ((none - mark_) / 2 < patch.size() + 2) {
    std::fill(marks_.begin(), marks_.end(), 0U);
    mark_ = 0;
  }
  find_strands(mesh, patch, strands_before_);
  first_end_ = mark_ + 1;
  ends_.clear();
  const auto add_end = [this](Halfedge at, std::uint32_t strand) {
    const auto name = static_cast<std::uint32_t>(ends_.size());
    std::uint32_t& mark = marks_[StripMesh::triangle(at)];
    ends_.push_back({at, strand, none});
    if (mark - first_end_ < name)
      ends_[mark - first_end_].other = name;
    else
      mark = first_end_ + name;
  };
  for (std::uint32_t i = 0; i < strands_before_.size(); ++i) {
    Strand& strand = strands_before_[i];
    if (strand.in.id == none) continue;
    strand.up_in = labels_grow(mesh, strand.in);
    add_end(strand.in, i);
    if (strand.out.id == none) continue;
    strand.up_out = labels_grow(mesh, strand.out);
    add_end(strand.out, i);
  }
  mark_ += static_cast<std::uint32_t>(ends_.size());
  touched_.clear();
  for (const Triangle t : patch) {
    const ChunkId c = addresses_[t].chunk;
    --lists_.count(c);
    addresses_[t].chunk = none;
    if (touched_.empty() || touched_.back() != c) touched_.push_back(c);
  }
}

// The strand before the rewrite that h led into, or null.
inline StripLocator::Strand* StripLocator::strand_at(Halfedge h) noexcept {
  std::uint32_t e = marks_[StripMesh::triangle(h)] - first_end_;
  if (e >= ends_.size()) return nullptr;
  while (e != none && !(ends_[e].at == h)) e = ends_[e].other;
  return e == none ? nullptr : &strands_before_[ends_[e].strand];
}

// Once for each chunk, when all strands have their addresses: until then only labels outside the patch are read.
inline void StripLocator::renumber_later(Halfedge h, bool up) {
  bool& crowded = lists_.crowded(addresses_[StripMesh::triangle(h)].chunk);
  if (crowded) return;
  crowded_.emplace_back(h, up);
  crowded = true;
}

inline void StripLocator::place_strand(const Strand& strand) {
  const std::span<const Triangle> nodes{strand_nodes_.data() + strand.first, strand_nodes_.data() + strand.last};
  if (strand.in.id == none) {
    const ChunkId c = lists_.add();
    const auto count = static_cast<std::uint32_t>(nodes.size());
    lists_.count(c) = count;
    const Label step_size = std::min<Label>(label_step, ~Label{0} / (count + 1));
    Label label = middle_label - step_size * (count / 2);
    for (const Triangle t : nodes) {
      addresses_[t] = {c, label};
      label += step_size;
    }
    return;
  }
  const Address from = addresses_[StripMesh::triangle(strand.in)];
  // Whether labels grew across `in`, into the patch, before the rewrite.
  const Strand* const old = strand_at(strand.in);
  const bool up = old != nullptr && (old->in == strand.in ? old->up_in : old->up_out);
  if (strand.out.id == none || addresses_[StripMesh::triangle(strand.out)].chunk != from.chunk) {
    if (!append(strand.in, up, nodes)) renumber_later(strand.in, up);
    return;
  }
  const Label to = addresses_[StripMesh::triangle(strand.out)].label;
  const Label gap = (up ? to - from.label : from.label - to) / static_cast<Label>(nodes.size() + 1);
  Label label = from.label;
  for (const Triangle t : nodes) {
    label = up ? label + gap : label - gap;
    addresses_[t] = {from.chunk, label};
  }
  lists_.count(from.chunk) += static_cast<std::uint32_t>(nodes.size());
  if (gap == 0) renumber_later(strand.in, up);
}

void StripLocator::after_patch(const SidedMesh auto& mesh, std::span<const Triangle> patch) {
  if (addresses_.size() < mesh.triangle_bound()) addresses_.resize(mesh.triangle_bound());
  find_strands(mesh, patch, strands_after_);
  pending_ = 0;
  for (Strand& old : strands_before_) {
    old.pending = old.out.id != none;
    pending_ += old.pending ? 1U : 0U;
  }
  const auto placed = [this](Strand& old) {
    old.pending = false;
    --pending_;
  };
  // The strand that led from the one end to the other before the rewrite, too.
  const auto same_before = [this](const Strand& strand) -> Strand* {
    Strand* const old = strand.out.id == none ? nullptr : strand_at(strand.in);
    const bool same = old != nullptr && (old->in == strand.in ? old->out == strand.out : old->in == strand.out);
    return same ? old : nullptr;
  };
  for (const Strand& strand : strands_after_)
    if (Strand* const old = same_before(strand)) old->passes = true;
  // Strips that the patch cuts.
  for (Strand& old : strands_before_) {
    if (!old.pending || old.passes) continue;
    placed(old);
    separate(mesh, old.in, old.up_in, old.out);
  }
  // Strips that pass through as before.
  for (const Strand& strand : strands_after_) {
    if (strand.out.id == none) continue;
    if (Strand* const old = same_before(strand)) placed(*old);
    place_strand(strand);
  }
  for (const Strand& strand : strands_after_)
    if (strand.out.id == none) place_strand(strand);
  ends_.clear();
  for (const auto& [h, up] : crowded_) {
    lists_.crowded(addresses_[StripMesh::triangle(h)].chunk) = false;
    renumber(mesh, h, up);
  }
  crowded_.clear();
  for (const ChunkId c : touched_)
    if (lists_[c].count == 0 && lists_.in_use(c)) lists_.erase(c);
  for (const Triangle t : patch)
    if (lists_[addresses_[t].chunk].count > chunk_limit_) divide(mesh, t);
}

}  // namespace restrip
