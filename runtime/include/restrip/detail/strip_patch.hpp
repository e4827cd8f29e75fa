// StripIndex: local rewrites. Included by strip_index.hpp.
//
// Outside the patch nothing moves, and a rewrite joins nothing there that was not joined before. So a strip that passed
// through keeps its order, and the triangles it now has inside the patch get labels between those of its two outside
// neighbours; a strip that is interrupted is cut between them; what ends in the patch is appended to its strip; and
// what lies in the patch altogether is a new strip.
#pragma once

#include <algorithm>
#include <utility>

#include "restrip/strip_index.hpp"

namespace restrip {

// Splits the solid edges of a patch into paths.
inline void StripIndex::find_strands(const StripMesh& mesh, std::span<const Triangle> patch,
                                     std::vector<Strand>& strands) {
  strands.clear();
  strand_nodes_.clear();
  if (marks_.size() < mesh.triangle_bound()) marks_.resize(mesh.triangle_bound(), 0);
  if (mark_ > none - 2) {  // marks are about to begin anew: forget the old ones
    std::fill(marks_.begin(), marks_.end(), 0U);
    mark_ = 0;
  }
  const std::uint32_t waiting = ++mark_;
  const std::uint32_t done = ++mark_;
  for (const Triangle t : patch) marks_[t] = waiting;
  for (const Triangle start : patch) {
    if (marks_[start] == done) continue;
    Strand strand;
    strand.first = static_cast<std::uint32_t>(strand_nodes_.size());
    // One way to its end, then back through the start to the other end: the nodes come in order.
    Triangle t = start;
    unsigned entry = 3;
    for (;;) {
      const Triangle here = t;
      marks_[here] = done;
      strand_nodes_.push_back(here);
      if (!step(mesh, t, entry)) break;
      if (marks_[t] != waiting) {
        if (marks_[t] != done) strand.in = StripMesh::halfedge(t, entry);
        break;
      }
    }
    std::reverse(strand_nodes_.begin() + strand.first, strand_nodes_.end());
    // The start's other solid side.
    unsigned sides[2];
    unsigned n = 0;
    for (unsigned s = 0; s < 3; ++s)
      if (mesh.solid(StripMesh::halfedge(start, s))) sides[n++ & 1U] = s;
    if (n == 2) {
      t = start;
      entry = sides[0];
      while (step(mesh, t, entry)) {
        if (marks_[t] != waiting) {
          strand.out = StripMesh::halfedge(t, entry);
          break;
        }
        marks_[t] = done;
        strand_nodes_.push_back(t);
      }
    }
    strand.last = static_cast<std::uint32_t>(strand_nodes_.size());
    if (strand.in.id == none) {  // `in` is there if either is
      std::swap(strand.in, strand.out);
      std::reverse(strand_nodes_.begin() + strand.first, strand_nodes_.end());
    }
    strands.push_back(strand);
  }
}

inline void StripIndex::before_patch(const StripMesh& mesh, std::span<const Triangle> patch) {
  find_strands(mesh, patch, strands_before_);
  for (Strand& strand : strands_before_) {
    if (strand.in.id != none) strand.up_in = labels_grow(mesh, strand.in);
    if (strand.out.id != none) strand.up_out = labels_grow(mesh, strand.out);
  }
  touched_.clear();
  for (const Triangle t : patch) {
    const ChunkId c = places_[t].chunk;
    --lists_.count(c);
    places_[t].chunk = none;
    if (touched_.empty() || touched_.back() != c) touched_.push_back(c);
  }
}

// Did labels grow across h, into the patch, before the rewrite?
inline bool StripIndex::grew(Halfedge h) const noexcept {
  for (const Strand& strand : strands_before_) {
    if (strand.in == h) return strand.up_in;
    if (strand.out == h) return strand.up_out;
  }
  return false;
}

inline void StripIndex::place_strand(const StripMesh& mesh, const Strand& strand) {
  const std::span<const Triangle> nodes{strand_nodes_.data() + strand.first, strand_nodes_.data() + strand.last};
  if (strand.in.id == none) {
    const ChunkId c = lists_.add();
    const auto count = static_cast<std::uint32_t>(nodes.size());
    lists_.count(c) = count;
    const Label step_size = std::min<Label>(label_step, ~Label{0} / (count + 1));
    Label label = middle_label - step_size * (count / 2);
    for (const Triangle t : nodes) {
      places_[t] = {c, label};
      label += step_size;
    }
    return;
  }
  const Place from = places_[StripMesh::triangle(strand.in)];
  const bool up = grew(strand.in);
  if (strand.out.id == none || places_[StripMesh::triangle(strand.out)].chunk != from.chunk) {
    append(mesh, strand.in, up, nodes);
    return;
  }
  const Label to = places_[StripMesh::triangle(strand.out)].label;
  const Label gap = (up ? to - from.label : from.label - to) / static_cast<Label>(nodes.size() + 1);
  Label label = from.label;
  for (const Triangle t : nodes) {
    label = up ? label + gap : label - gap;
    places_[t] = {from.chunk, label};
  }
  lists_.count(from.chunk) += static_cast<std::uint32_t>(nodes.size());
  if (gap == 0) renumber(mesh, strand.in, up);
}

inline void StripIndex::after_patch(const StripMesh& mesh, std::span<const Triangle> patch) {
  if (places_.size() < mesh.triangle_bound()) places_.resize(mesh.triangle_bound());
  find_strands(mesh, patch, strands_after_);
  const auto same = [](const Strand& a, const Strand& b) {
    return (a.in == b.in && a.out == b.out) || (a.in == b.out && a.out == b.in);
  };
  const auto no_longer_pending = [this](std::uint32_t i) { std::erase(pending_, i); };
  pending_.clear();
  for (std::uint32_t i = 0; i < strands_before_.size(); ++i)
    if (strands_before_[i].out.id != none) pending_.push_back(i);
  // Strips that the patch cuts.
  for (std::uint32_t i = 0; i < strands_before_.size(); ++i) {
    const Strand& old = strands_before_[i];
    if (old.out.id == none) continue;
    bool kept = false;
    for (const Strand& strand : strands_after_) kept = kept || same(strand, old);
    if (kept) continue;
    no_longer_pending(i);
    separate(mesh, old.in, old.up_in, old.out);
  }
  // Strips that pass through as before.
  for (const Strand& strand : strands_after_) {
    if (strand.out.id == none) continue;
    for (std::uint32_t i = 0; i < strands_before_.size(); ++i)
      if (same(strand, strands_before_[i])) no_longer_pending(i);
    place_strand(mesh, strand);
  }
  for (const Strand& strand : strands_after_)
    if (strand.out.id == none) place_strand(mesh, strand);
  for (const ChunkId c : touched_)
    if (lists_[c].count == 0 && lists_.in_use(c)) lists_.erase(c);
  for (const Triangle t : patch)
    if (lists_[places_[t].chunk].count > chunk_limit_) divide(mesh, t);
}

}  // namespace restrip
