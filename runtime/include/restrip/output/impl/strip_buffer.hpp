// Strips read and written as runs. Included by strip_buffer.hpp.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "restrip/output/strip_buffer.hpp"
#include "restrip/precondition.hpp"

namespace restrip {

namespace detail {
// Chosen by measurement under all policies; in triangles.
inline constexpr std::uint32_t longest_joined_run = 28;  // runs of one strip that meet become one up to this
inline constexpr std::uint32_t cut_window = 4;           // the distance by which a cut may be off
inline constexpr std::uint32_t longest_run = longest_joined_run + 2 * cut_window;

// A triangle entered over a halfedge; the edge is the exclusive or of its vertices.
struct SeenTriangle {
  std::uint32_t edge;
  std::uint32_t apex;  // the corner opposite to it
};
template <NumberedMesh Mesh>
SeenTriangle seen_over(const Mesh& mesh, typename Mesh::Halfedge h) {
  const auto second = mesh.next(h);
  return {from_of(mesh, h) ^ from_of(mesh, second), from_of(mesh, mesh.next(second))};
}
inline SeenTriangle seen_over(const StripMesh& mesh, StripMesh::Halfedge h) noexcept {
  const Vertex apex = mesh.from(StripMesh::next(StripMesh::next(h)));
  const std::array<Vertex, 3> corner = mesh.corners(StripMesh::triangle(h));
  return {corner[0] ^ corner[1] ^ corner[2] ^ apex, apex};
}
}  // namespace detail

template <class Index>
template <NumberedMesh Mesh>
void BasicStripBuffer<Index>::rebuild(const Mesh& mesh) {
  stale_ = true;
  places_ = {};
  cells_.clear();
  run_of_.assign(mesh.triangle_bound(), nothing);
  const auto bound = static_cast<std::uint32_t>(mesh.triangle_bound());
  for (std::uint32_t t = 0; t < bound; ++t) {
    if (!mesh.has_triangle(t) || run_of_[t] != nothing || detail::solid_degree(mesh, t) > 1) continue;
    begin_reading();
    read(mesh, t);
    store();
    written_.clear();
  }
  written_.assign(cells_.empty() ? 0 : 1, {0, cells_.size()});
  returned_ = rebuilt_ = true;
  stale_ = false;
}

template <class Index>
template <NumberedMesh Mesh>
std::span<const IndexRange> BasicStripBuffer<Index>::update(const Mesh& mesh, std::span<const std::uint32_t> changed,
                                                            const RangeOptions& ranges) {
  if (stale_) {
    rebuild(mesh);
    return written_;
  }
  stale_ = true;
  rebuilt_ = false;
  if (std::exchange(returned_, true)) written_.clear();
  begin_reading();
  places_.make_room(0);  // copies lack this room, and so do buffers restored by a BufferHistory
  if (run_of_.size() < mesh.triangle_bound()) {
    detail::make_room(run_of_, mesh.triangle_bound() - run_of_.size());
    run_of_.resize(mesh.triangle_bound(), nothing);
  }
  for (const std::uint32_t t : changed)
    if (t < run_of_.size() && run_of_[t] != nothing) touch(run_of_[t]);
  for (const std::uint32_t t : changed) {
    if (t < mesh.triangle_bound() && mesh.has_triangle(t)) {
      if (run_of_[t] != reading) read(mesh, t);
    } else if (t < run_of_.size()) {
      run_of_[t] = nothing;
    }
  }
  store();
  if (!changed.empty()) close_gaps();
  detail::join_ranges(written_, cells_.size(), ranges.merge_gap, ranges.align / sizeof(Index));
  stale_ = false;
  return written_;
}

template <class Index>
void BasicStripBuffer<Index>::begin_reading() noexcept {
  dirty_.clear();
  texts_.clear();
  links_ = letters_ = 0;
}

template <class Index>
void BasicStripBuffer<Index>::touch(std::uint32_t place) {
  if (places_.state(place) != State::settled) return;
  dirty_.push_back(place);
  places_.set_state(place, State::dirty);
}

// ---- the strip around a triangle

// Reads from the triangle of the halfedge `in` on. An edge that a triangle is entered over belongs to the link that the
// triangle has, or to the one before. The strip, from link `begin` on, will have `least` triangles at least. True if it
// continues in a run that stays as it is.
template <class Index>
template <class Mesh>
bool BasicStripBuffer<Index>::follow(const Mesh& mesh, typename Mesh::Halfedge in, std::uint32_t begin,
                                     std::uint32_t least, std::uint32_t edge_goes) {
  std::uint32_t links = links_;
  std::uint32_t known = nothing;  // a run that may be read
  bool stays = false;
  for (;;) {
    const std::uint32_t t = detail::triangle_of(mesh, in);
    const std::uint32_t run = run_of_[t];
    if (run != known) {
      if (run == reading) break;
      if (run != nothing && places_.state(run) == State::settled) {
        stays = std::max(links - begin, least) + places_.run(run).triangles > detail::longest_joined_run;
        if (stays) break;
        touch(run);
      }
      known = run;
    }
    run_of_[t] = reading;
    if (links == strip_.size()) strip_.resize(2 * strip_.size() + 64);
    Link* link = strip_.data() + links++;
    const detail::SeenTriangle seen = detail::seen_over(mesh, in);
    link->triangle = t;
    link->corners = seen.edge ^ seen.apex;
    link->run = run;
    (link - edge_goes)->edge = seen.edge;
    const auto step = strip_step(mesh, in);
    if (!step.goes_on) break;
    in = step.in;
  }
  links_ = links;
  return stays;
}

// Reads the part of the strip through t that must be rewritten, and writes it as runs that are not too long.
template <class Index>
template <class Mesh>
void BasicStripBuffer<Index>::read(const Mesh& mesh, std::uint32_t t) {
  const std::uint32_t begin = links_;
  const std::uint32_t run = std::exchange(run_of_[t], reading);
  const std::uint32_t least = run != nothing ? places_.run(run).triangles : 1;
  auto h = mesh.halfedge(t);
  const detail::SeenTriangle seen = detail::seen_over(mesh, h);
  std::array<typename Mesh::Halfedge, 3> exits{h, h, h};  // the solid sides first
  unsigned ways = 0;
  for (int side = 0; side < 3; ++side, h = mesh.next(h)) {
    exits[ways] = h;
    ways += mesh.solid(h) ? 1U : 0U;
  }
  const bool cut_before = ways > 0 && follow(mesh, mesh.opposite(exits[0]), begin, least, 0);
  std::reverse(strip_.data() + begin, strip_.data() + links_);
  if (links_ == strip_.size()) strip_.resize(2 * links_ + 64);
  strip_[links_++] = {t, seen.edge ^ seen.apex, 0, run};
  const bool cut_behind = ways > 1 && follow(mesh, mesh.opposite(exits[1]), begin, 1, 1);
  const std::uint32_t triangles = links_ - begin;
  const std::uint32_t parts = triangles > detail::longest_run ? (triangles - 1) / detail::longest_joined_run + 1 : 1;
  std::uint32_t from = begin;
  for (std::uint32_t part = 1; part <= parts; ++part) {
    const auto share = static_cast<std::uint32_t>(std::uint64_t{triangles} * part / parts);
    const std::uint32_t to = part == parts ? links_ : best_cut(begin + share, from);
    const std::uint32_t cuts = std::uint32_t{part > 1 || cut_before} + std::uint32_t{part < parts || cut_behind};
    write_text(mesh, from, to, cuts);
    from = to;
  }
}

// Chooses where to cut the strip: near a link, and so that few indices are repeated. A strip repeats an index if it
// turns around the same vertex in two triangles, but not in the triangles next to a cut.
template <class Index>
std::uint32_t BasicStripBuffer<Index>::best_cut(std::uint32_t near, std::uint32_t begin) const noexcept {
  const auto turns_around = [&](std::uint32_t i) { return strip_[i - 1].edge ^ strip_[i].corners ^ strip_[i].edge; };
  std::uint32_t best = near;
  std::uint32_t most = 0;
  const std::uint32_t last = std::min(near + detail::cut_window, links_ - 4);
  for (std::uint32_t cut = std::max(near - detail::cut_window, begin + 3); cut <= last; ++cut) {
    std::uint32_t saved = 0;
    for (std::uint32_t i = cut - 2; i <= cut; ++i) saved += std::uint32_t{turns_around(i) == turns_around(i + 1)};
    if (saved > most) best = cut;
    most = std::max(most, saved);
  }
  return best;
}

// ---- a run as indices

// The first triangle from one end or the other.
template <class Index>
template <class Mesh>
typename BasicStripBuffer<Index>::Start BasicStripBuffer<Index>::start(const Mesh& mesh, const Text& text,
                                                                       bool forward) const {
  Start start{&strip_[forward ? text.begin : text.end - 1], forward ? 1 : -1, forward ? 0 : -1, {}, false};
  const Link* link = start.link;
  auto h = mesh.halfedge(link->triangle);
  if (text.end - text.begin > 1)
    for (int i = 0; i < 2 && detail::from_of(mesh, h) != (link->corners ^ link[start.edge].edge); ++i) h = mesh.next(h);
  for (std::uint32_t& corner : start.corner) {
    corner = detail::from_of(mesh, h);
    h = mesh.next(h);
  }
  // At an odd place the winding needs the same edge in reverse.
  if (stitched_) std::swap(start.corner[1], start.corner[2]);
  link += start.step;
  if (text.end - text.begin > 2) start.swaps = (start.corner[2] ^ link->corners ^ link[start.edge].edge) == 0;
  return start;
}

// Whether the text begins or ends like the run that it replaces.
template <class Index>
bool BasicStripBuffer<Index>::is_forward(const Text& text) const noexcept {
  if (text.place == nothing || text.end - text.begin < 2) return true;
  const detail::Run& run = places_.run(text.place);
  const auto first = static_cast<Index>(strip_[text.begin].corners ^ strip_[text.begin].edge);
  const auto last = static_cast<Index>(strip_[text.end - 1].corners ^ strip_[text.end - 2].edge);
  const bool as_before = cells_[run.first] == first || cells_[run.end() - 2] == last;
  return as_before || (cells_[run.first] != last && cells_[run.end() - 2] != first);
}

template <class Index>
template <class Mesh>
void BasicStripBuffer<Index>::write_text(const Mesh& mesh, std::uint32_t begin, std::uint32_t end, std::uint32_t cuts) {
  const std::uint32_t triangles = end - begin;
  Text text{begin, end, letters_, 0, cuts, nothing};
  // It takes the place of a run that one of its triangles was in, one in the middle if possible.
  for (std::uint32_t i = 0; i < triangles && text.place == nothing; ++i) {
    const std::uint32_t run = strip_[begin + (i + triangles / 2) % triangles].run;
    if (run == nothing || places_.state(run) != State::dirty) continue;
    text.place = run;
    places_.set_state(run, State::claimed);
  }
  if (text_.size() < letters_ + 2 * triangles + 5) text_.resize(2 * (text_.size() + triangles + 3));
  const bool forward = is_forward(text);
  Start run = start(mesh, text, forward);
  // Perhaps shorter from the other end.
  if (run.swaps)
    if (const Start other = start(mesh, text, !forward); !other.swaps) run = other;
  std::uint32_t p = run.corner[1];
  std::uint32_t q = run.corner[2];
  std::uint32_t in = p ^ q;
  std::uint32_t largest = std::max({run.corner[0], p, q});
  Index* out = text_.data() + letters_;
  if (stitched_) *out++ = static_cast<Index>(run.corner[0]);
  for (const std::uint32_t corner : run.corner) *out++ = static_cast<Index>(corner);
  // Each further triangle has the last two indices p, q and adds its third corner x. If the strip leaves it over the
  // edge (p, x), p is repeated before x. Strips turn at random: no branch.
  const Link* link = run.link;
  for (std::uint32_t i = 2; i < triangles; ++i) {
    link += run.step;
    const std::uint32_t x = link->corners ^ in;
    in = link[run.edge].edge;
    const auto repeats = std::uint32_t{(in ^ x) == p};
    *out = static_cast<Index>(p);
    out += repeats;
    *out++ = static_cast<Index>(x);
    p = q ^ ((p ^ q) & (0U - repeats));
    q = x;
    largest = std::max(largest, x);
  }
  if (triangles > 1) {
    const std::uint32_t x = (link + run.step)->corners ^ in;
    *out++ = static_cast<Index>(x);
    largest = std::max(largest, x);
  }
  if (largest >= restart)
    RESTRIP_THROW(std::length_error, "restrip: a vertex does not fit into the indices of the buffer");
  const Index separator = stitched_ ? *(out - 1) : restart;
  *out++ = separator;
  if (stitched_ && (static_cast<std::uint32_t>(out - text_.data()) - letters_) % 2 != 0) *out++ = separator;
  letters_ = static_cast<std::uint32_t>(out - text_.data());
  text.length = letters_ - text.first;
  texts_.push_back(text);
}

}  // namespace restrip
