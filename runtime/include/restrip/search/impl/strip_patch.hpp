// StripLocator: local rewrites. Included by strip_locator.hpp.
//
// Outside the patch nothing moves, and a rewrite joins nothing there that was not joined before. So a strip that passes
// through keeps its order, and its new triangles inside the patch get labels between the labels of its two outside
// neighbours. A strip that is interrupted is cut between them. A strand that ends in the patch is appended to its
// strip. A strand that lies entirely in the patch is a new strip.
#pragma once

#include <algorithm>
#include <utility>

#include "restrip/search/strip_locator.hpp"

namespace restrip {

// Splits the solid edges of a patch into paths.
template <SidedMesh Mesh>
void StripLocator::find_strands(const Mesh& mesh, std::span<const Triangle> patch, std::vector<Strand>& strands) {
  strands.clear();
  strand_nodes_.clear();
  if (marks_.size() < mesh.triangle_bound()) marks_.resize(mesh.triangle_bound(), 0);
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
    std::reverse(strand_nodes_.begin() + static_cast<std::ptrdiff_t>(strand.first), strand_nodes_.end());
    // Over the start's other solid side.
    if (mesh.solid_degree(start) == 2) {
      t = start;
      entry = StripMesh::side(detail::lowest_side(start, mesh.solid_sides(start)));
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
    if (strand.in.id == none) {  // `in` is set if either is
      std::swap(strand.in, strand.out);
      std::reverse(strand_nodes_.begin() + static_cast<std::ptrdiff_t>(strand.first), strand_nodes_.end());
    }
    strands.push_back(strand);
  }
}

template <SidedMesh Mesh>
void StripLocator::before_patch(const Mesh& mesh, std::span<const Triangle> patch) {
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

template <SidedMesh Mesh>
void StripLocator::after_patch(const Mesh& mesh, std::span<const Triangle> patch) {
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
