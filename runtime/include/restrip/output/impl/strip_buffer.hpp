// BasicStripBuffer, member by member. Included by strip_buffer.hpp.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "restrip/output/strip_buffer.hpp"
#include "restrip/precondition.hpp"

namespace restrip {

namespace detail {
// Chosen by measurement on the ways of keeping strips (bench/buffer.cpp); all in indices but where said.
inline constexpr std::uint32_t longest_run = 200;         // below RunPlaces::largest_gap
inline constexpr std::uint32_t longest_merged_run = 144;  // runs of one strip that meet become one up to this
inline constexpr std::size_t wasted_soft = 80;            // per mille of what is needed: from here on gaps are closed
inline constexpr std::size_t wasted_hard = 90;            // from here on at any price
inline constexpr std::uint32_t worth_filling = 16;        // gaps for which the last run is divided
inline constexpr std::uint32_t easily_moved = 12;         // runs that are moved out of the way
inline constexpr std::uint32_t pads_in_a_run = 16;        // one index in so many may be there for alignment alone
inline constexpr std::size_t compaction_base = 160;       // moved by a compaction, at most, and
inline constexpr std::size_t compaction_times = 4;        // so many times what the update wrote
inline constexpr std::size_t compaction_steps = 64;       // runs looked at, and one for four indices of new text

template <class Vector>
void make_buffer_room(Vector& vector, std::size_t more) {
  if (vector.capacity() - vector.size() < more) vector.reserve(std::max(vector.size() + more, 2 * vector.capacity()));
}
}  // namespace detail

template <class Index>
template <NumberedMesh Mesh>
void BasicStripBuffer<Index>::rebuild(const Mesh& mesh) {
  stale_ = true;
  places_.clear();
  cells_.clear();
  whose_.clear();
  at_.assign(mesh.triangle_bound(), At{});
  written_.clear();
  cursor_ = 0;
  touched_.clear();
  const auto bound = static_cast<std::uint32_t>(mesh.triangle_bound());
  for (std::uint32_t t = 0; t < bound; ++t) {
    if (!mesh.has_triangle(t) || at_[t].place != nothing) continue;
    const auto h = mesh.halfedge(t);
    const int degree = static_cast<int>(mesh.solid(h)) + static_cast<int>(mesh.solid(mesh.next(h))) +
                       static_cast<int>(mesh.solid(mesh.next(mesh.next(h))));
    if (degree > 1) continue;
    text_.clear();
    names_.clear();
    fresh_.clear();
    collect(mesh, t);
    assemble();
    prepare();
    for (const Fresh& fresh : fresh_) place_anew(fresh);
    written_.clear();
  }
  written_.assign(1, {0, cells_.size()});
  marked_ = 0;
  stale_ = false;
}

template <class Index>
template <NumberedMesh Mesh>
std::span<const IndexRange> BasicStripBuffer<Index>::update(const Mesh& mesh, std::span<const std::uint32_t> changed) {
  if (stale_) {
    rebuild(mesh);
    return written_;
  }
  stale_ = true;
  written_.clear();
  touched_.clear();
  text_.clear();
  names_.clear();
  fresh_.clear();
  if (at_.size() < mesh.triangle_bound()) {
    detail::make_buffer_room(at_, mesh.triangle_bound() - at_.size());
    at_.resize(mesh.triangle_bound());
  }
  for (const std::uint32_t t : changed)
    if (t < at_.size()) forget(t);
  for (const std::uint32_t t : changed) {
    if (t >= mesh.triangle_bound() || at_[t].place != nothing || !mesh.has_triangle(t)) continue;
    collect(mesh, t);
    assemble();
  }
  prepare();
  store();
  compact();
  trim();
  merge_ranges();
  stale_ = false;
  return written_;
}

// The triangle has to be written anew.
template <class Index>
void BasicStripBuffer<Index>::forget(std::uint32_t t) {
  At& at = at_[t];
  if (at.place >= pending) return;
  whose_[places_.first(at.place) + at.offset] = gone;
  touch(at.place);
  at.place = nothing;
}

template <class Index>
void BasicStripBuffer<Index>::touch(std::uint32_t place) {
  if (places_.touched(place)) return;
  touched_.push_back(place);
  places_.set_touched(place, true);
}

// ---- the strip around a triangle

template <class Index>
template <class Mesh>
typename BasicStripBuffer<Index>::Piece BasicStripBuffer<Index>::load(const Mesh& mesh,
                                                                      typename Mesh::Halfedge in) const {
  Piece piece;
  const auto second = mesh.next(in);
  piece.corner = {static_cast<std::uint32_t>(mesh.from(in)), static_cast<std::uint32_t>(mesh.from(second)),
                  static_cast<std::uint32_t>(mesh.from(mesh.next(second)))};
  for (const std::uint32_t v : piece.corner)
    if (v >= restart) RESTRIP_THROW(std::length_error, "restrip: a vertex does not fit into the indices of the buffer");
  piece.triangle = static_cast<std::uint32_t>(mesh.triangle(in));
  return piece;
}

template <class Index>
template <class Mesh>
void BasicStripBuffer<Index>::collect(const Mesh& mesh, std::uint32_t start) {
  pieces_.clear();
  seen_ = 0;
  const auto first = mesh.halfedge(start);
  Piece middle = load(mesh, first);
  at_[start].place = pending;
  auto h = first;
  for (std::uint8_t side = 0; side < 3; ++side, h = mesh.next(h)) {
    if (!mesh.solid(h)) continue;
    const auto opposite_corner = static_cast<std::uint8_t>((side + 2) % 3);
    if (middle.enters == 3) {
      middle.enters = opposite_corner;
      follow(mesh, mesh.opposite(h));
      std::reverse(pieces_.begin(), pieces_.end());
      for (Piece& piece : pieces_) flip(piece);
      pieces_.push_back(middle);
    } else {
      pieces_[pieces_.size() - 1].leaves = opposite_corner;
      follow(mesh, mesh.opposite(h));
      return;
    }
  }
  if (middle.enters == 3) pieces_.push_back(middle);
}

// Repeated indices that could go: of each gap between two triangles all, or all but one.
template <class Index>
std::uint32_t BasicStripBuffer<Index>::pads_within(const std::uint32_t* whose, std::uint32_t from,
                                                   std::uint32_t to) noexcept {
  std::uint32_t pads = 0;
  std::uint32_t gap = 0;
  for (std::uint32_t i = from; i < to; ++i) {
    gap = whose[i] == nothing ? gap + 1 : 0;
    pads += gap != 0 && gap % 2 == 0 ? 2 : 0;
  }
  return pads;
}

template <class Index>
template <class Mesh>
void BasicStripBuffer<Index>::follow(const Mesh& mesh, typename Mesh::Halfedge in) {
  for (;;) {
    const auto t = static_cast<std::uint32_t>(mesh.triangle(in));
    const At at = at_[t];
    if (at.place == pending) return;
    std::uint32_t far = nothing;   // offset of the last triangle of the stretch that begins here
    std::uint32_t last = nothing;  // the triangle before it
    if (at.place != nothing) {
      const std::uint32_t used = places_.used(at.place);
      if (!places_.touched(at.place)) {
        if (seen_ + used > detail::longest_merged_run) return;
        touch(at.place);
      }
      const std::uint32_t* whose = whose_.data() + places_.first(at.place);
      std::uint32_t right = at.offset + 1;
      while (right + 1 < used && whose[right] == nothing) ++right;
      std::uint32_t left = at.offset - 1;
      while (left > 1 && whose[left] == nothing) --left;
      const bool goes_right = right + 1 < used && whose[right] < gone;
      const bool goes_left = left > 1 && whose[left] < gone;
      if (goes_right && goes_left) return;  // the colouring is not valid
      Piece stretch;
      stretch.place = at.place;
      // The stretch ends before the last triangle that stays, `far`; `last` is the one before that.
      if (goes_right) {
        std::uint32_t end = right + 1;
        while (end + 1 < used && whose[end] != gone) ++end;
        while (whose[--end] == nothing) {
        }
        stretch.from = right;
        if (end != right) {
          far = stretch.to = end;
          while (whose[--stretch.to] == nothing) {
          }
          last = whose[stretch.to];
        }
      } else if (goes_left) {
        std::uint32_t begin = left - 1;
        while (begin > 1 && whose[begin] != gone) --begin;
        while (whose[++begin] == nothing) {
        }
        stretch.to = left;
        stretch.forward = false;
        if (begin != left) {
          far = stretch.from = begin;
          while (whose[++stretch.from] == nothing) {
          }
          last = whose[stretch.from];
        }
      }
      if (far != nothing) stretch.pads = pads_within(whose, stretch.from, stretch.to);
      const std::uint32_t far_triangle = far == nothing ? nothing : whose[far];
      forget(t);
      if (far != nothing) {
        Piece end = load(mesh, in);
        end.enters = 2;
        const auto second = mesh.next(in);
        const bool over_second = mesh.solid(second);
        end.leaves = over_second ? 0 : 1;
        at_[t].place = pending;
        pieces_.push_back(end);
        pieces_.push_back(stretch);
        seen_ += stretch.to - stretch.from + 3;
        // Into the last triangle of the stretch, from the one before it.
        auto h = mesh.halfedge(far_triangle);
        for (int side = 0; side < 3; ++side, h = mesh.next(h))
          if (mesh.solid(h) && static_cast<std::uint32_t>(mesh.triangle(mesh.opposite(h))) == last) break;
        in = h;
        forget(far_triangle);
        at_[far_triangle].place = nothing;
      }
    }
    Piece piece = load(mesh, in);
    piece.enters = 2;
    at_[piece.triangle].place = pending;
    seen_ += 2;
    const auto second = mesh.next(in);
    const auto third = mesh.next(second);
    if (mesh.solid(second)) {
      piece.leaves = 0;
      in = mesh.opposite(second);
    } else if (mesh.solid(third)) {
      piece.leaves = 1;
      in = mesh.opposite(third);
    }
    pieces_.push_back(piece);
    if (piece.leaves == 3) return;
  }
}

// ---- what has been written

template <class Index>
void BasicStripBuffer<Index>::merge_ranges() noexcept {
  marked_ = 0;
  std::sort(written_.begin(), written_.end(), [](const Range& a, const Range& b) { return a.first < b.first; });
  std::size_t kept = 0;
  for (Range range : written_) {
    if (range.first >= cells_.size()) continue;
    range.count = std::min(range.count, cells_.size() - range.first);
    if (kept != 0 && range.first <= written_[kept - 1].first + written_[kept - 1].count) {
      Range& last = written_[kept - 1];
      last.count = std::max(last.count, range.first + range.count - last.first);
    } else {
      written_[kept++] = range;
    }
  }
  written_.resize(kept);
}

template <class Index>
void BasicStripBuffer<Index>::reserve(std::size_t triangles) {
  at_.reserve(triangles);
  cells_.reserve(2 * triangles);
  whose_.reserve(2 * triangles);
}

}  // namespace restrip
