// The indices of a strip, out of triangles that are new and stretches that stay. Included by strip_buffer.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "restrip/output/strip_buffer.hpp"

namespace restrip {

// The strip of pieces_ as runs that are not too long.
template <class Index>
void BasicStripBuffer<Index>::assemble() {
  std::size_t total = 0;
  for (const Piece& piece : pieces_) total += weight(piece);
  constexpr std::size_t most = 4 * detail::longest_run - 20;
  if (total <= most) return emit(0, pieces_.size());
  const std::size_t parts = total / (most * 3 / 4) + 1;
  const std::size_t wanted = total / parts + 1;
  std::size_t begin = 0;
  std::size_t sum = 0;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const std::size_t more = weight(pieces_[i]);
    if (sum + more > wanted + wanted / 8 && pieces_[i].triangle == nothing && wanted > sum + 40) {
      // Divide the stretch.
      Piece& piece = pieces_[i];
      const auto part = static_cast<std::uint32_t>((wanted - sum) / 4);
      const std::uint32_t* whose = whose_.data() + places_.first(piece.place);
      std::uint32_t cut = piece.forward ? piece.from + part : piece.to - part;
      while (cut > piece.from && whose[cut] == nothing) --cut;
      std::uint32_t after = cut + 1;
      while (after < piece.to && whose[after] == nothing) ++after;
      Piece rest = piece;
      if (after <= piece.to) {
        if (piece.forward) {
          piece.to = cut;
          rest.from = after;
        } else {
          piece.from = after;
          rest.to = cut;
        }
        pieces_.insert(pieces_.begin() + static_cast<std::ptrdiff_t>(i) + 1, rest);
        sum += weight(pieces_[i]);
        emit(begin, i + 1);
        begin = i + 1;
        sum = 0;
        continue;
      }
    }
    if (sum != 0 && sum + more > wanted) {
      emit(begin, i);
      begin = i;
      sum = 0;
    }
    sum += more;
  }
  if (begin < pieces_.size()) emit(begin, pieces_.size());
}

template <class Index>
void BasicStripBuffer<Index>::emit(std::size_t begin, std::size_t end) {
  const auto pieces_begin = pieces_.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto pieces_end = pieces_.begin() + static_cast<std::ptrdiff_t>(end);
  const auto turn_around = [&] {
    std::reverse(pieces_begin, pieces_end);
    std::for_each(pieces_begin, pieces_end, flip);
  };
  Fresh fresh;
  std::size_t largest = 0;
  bool forward = true;
  bool any = false;
  for (auto piece = pieces_begin; piece != pieces_end; ++piece) {
    if (piece->triangle != nothing) continue;
    any = true;
    const std::size_t size = piece->to - piece->from + 1;
    if (size <= largest) continue;
    largest = size;
    fresh.target = piece->place;
    forward = piece->forward;
  }
  if (!forward) turn_around();
  fresh.begin = static_cast<std::uint32_t>(text_.size());
  begin_ = text_.size();
  fresh_.push_back(fresh);
  generate(begin, end, fresh.target);
  if (!any && end - begin >= 3 && names_[begin_ + 3] == nothing) {
    // Perhaps shorter from the other end.
    const std::size_t length = text_.size() - begin_;
    for (int again = 0; again < 2; ++again) {
      turn_around();
      text_.resize(begin_);
      names_.resize(begin_);
      generate(begin, end, fresh.target);
      if (text_.size() - begin_ <= length) break;
    }
  }
  if (!any) {
    // Where a run has gone, another may come.
    for (const std::uint32_t place : touched_)
      if (!places_.claimed(place) && places_.limit(place) - places_.first(place) > text_.size() - begin_) {
        fresh_.back().target = place;
        fresh_.back().wish = places_.first(place);
        break;
      }
  }
  put(restart, nothing);
  fresh_.back().length = static_cast<std::uint32_t>(text_.size() - begin_);
  fresh_.back().cuts =
      is_cut(pieces_[begin].enters, begin != 0) + is_cut(pieces_[end - 1].leaves, end != pieces_.size());
  if (fresh_.back().target != nothing) places_.set_claimed(fresh_.back().target, true);
}

template <class Index>
void BasicStripBuffer<Index>::generate(std::size_t begin, std::size_t end, std::uint32_t target) {
  std::uint32_t pads = 0;
  std::size_t total = 0;
  for (std::size_t i = begin; i < end; ++i) {
    total += weight(pieces_[i]) / 4;
    if (pieces_[i].triangle == nothing) pads += pieces_[i].pads;
  }
  const auto most_pads = static_cast<std::uint32_t>(total / detail::pads_in_a_run);
  const bool squeeze = pads > most_pads;
  std::uint32_t may_pad = squeeze ? 0 : most_pads - pads;
  fresh_.back().pads = 0;
  fresh_.back().aligned = false;
  fresh_.back().shift = 0;
  for (std::size_t i = begin; i < end; ++i) {
    if (pieces_[i].triangle != nothing)
      append(pieces_[i], i + 1 != end);
    else
      append_stretch(pieces_[i], target, squeeze, may_pad);
  }
}

// A triangle. Where a strip is left over the edge that its indices do not end with, one is repeated.
template <class Index>
void BasicStripBuffer<Index>::append(const Piece& piece, bool leaves) {
  const unsigned out = leaves ? piece.leaves : 3;
  const auto& corner = piece.corner;
  if (text_.size() == begin_) {
    const unsigned first = out % 3;
    put(static_cast<Index>(corner[first]), nothing);
    put(static_cast<Index>(corner[(first + 1) % 3]), nothing);
    put(static_cast<Index>(corner[(first + 2) % 3]), piece.triangle);
    return;
  }
  const Index p = text_[text_.size() - 2];
  const Index q = text_[text_.size() - 1];
  // p and q are corners; of the three, one is left.
  const std::uint32_t third = corner[0] ^ corner[1] ^ corner[2] ^ p ^ q;
  if (out < 3 && corner[out] == q) put(p, nothing);
  put(static_cast<Index>(third), piece.triangle);
}

template <class Index>
void BasicStripBuffer<Index>::append_stretch(Piece piece, std::uint32_t target, bool squeeze, std::uint32_t& may_pad) {
  const Index* cells = cells_.data() + places_.first(piece.place);
  const std::uint32_t* whose = whose_.data() + places_.first(piece.place);
  if (text_.size() == begin_) {
    // The first triangle begins the run.
    const std::uint32_t at = piece.forward ? piece.from : piece.to;
    Piece start;
    start.corner = {cells[at - 2], cells[at - 1], cells[at]};
    start.leaves = piece.forward ? 0 : 2;
    if (at % 2 != 0) std::swap(start.corner[0], start.corner[1]);
    if (at % 2 != 0 && piece.forward) start.leaves = 1;
    start.triangle = whose[at];
    append(start, true);
    if (piece.from == piece.to) return;
    if (piece.forward)
      while (whose[++piece.from] == nothing) {
      }
    else
      while (whose[--piece.to] == nothing) {
      }
  }
  if (piece.forward) {
    const Index q = cells[piece.from - 1];
    if (text_.back() != q) put(text_[text_.size() - 2], nothing);
    const auto length = static_cast<std::uint32_t>(text_.size() - begin_);
    std::uint32_t shift = 0;  // how much of it is to be squeezed out; only an even number can
    const std::uint32_t old = places_.first(piece.place) + piece.from;
    if (piece.place == target && !fresh_.back().aligned) {
      fresh_.back().aligned = true;
      fresh_.back().head = piece.to - piece.from;
      fresh_.back().wish = old - length;  // modulo 2^32 where the text begins before the buffer
      if (squeeze) shift = nothing;
    } else if (piece.place == target && !squeeze) {
      const std::uint32_t wanted = old - fresh_.back().wish;
      if (length <= wanted) {
        const std::uint32_t pads = wanted - length;
        if (pads <= may_pad) {
          may_pad -= pads;
          fresh_.back().pads += pads;
          for (std::uint32_t i = 0; i < pads; ++i) put(text_[text_.size() - 2], nothing);
        }
      } else {
        shift = length - wanted;
      }
    } else {
      shift = nothing;
    }
    if (piece.place == target && shift != nothing && shift != 0) {
      fresh_.back().tail = piece.to - piece.from;
      fresh_.back().shift = shift;
    }
    if (shift == 0 || piece.pads == 0) {
      text_.insert(text_.end(), cells + piece.from, cells + piece.to + 1);
      names_.insert(names_.end(), whose + piece.from, whose + piece.to + 1);
      fresh_.back().pads += piece.pads;
      return;
    }
    for (std::uint32_t k = piece.from; k <= piece.to;) {
      put(cells[k], whose[k]);
      std::uint32_t between = 0;
      while (k + 1 + between <= piece.to && whose[k + 1 + between] == nothing) ++between;
      const std::uint32_t drop = std::min(between & ~1U, shift & ~1U);
      for (std::uint32_t i = 0; i < between - drop; ++i) put(cells[k + 1 + i], nothing);
      fresh_.back().pads += (between - drop) & ~1U;
      if (shift != nothing) shift -= drop;
      k += between + 1;
    }
    if (piece.place == target && shift != nothing) fresh_.back().shift = shift;
  } else {
    const Index q = cells[piece.to - 1];
    if (text_.back() != q) put(text_[text_.size() - 2], nothing);
    for (std::uint32_t k = piece.to; k + 1 > piece.from;) {
      put(cells[k - 2], whose[k]);
      std::uint32_t between = 0;
      while (k > piece.from + between && whose[k - 1 - between] == nothing) ++between;
      if (between % 2 != 0) put(cells[k - 3], nothing);
      k -= between + 1;
    }
  }
}

}  // namespace restrip
