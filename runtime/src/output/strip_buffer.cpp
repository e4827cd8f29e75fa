// Runs of strips in a buffer: read, written, stored as close as possible to their old place.
//
// How it works. An update follows the strips from the changed triangles to the ends of their runs and divides the
// triangles read into new runs. It prefers to cut where the strip repeats an index, which the cut saves. A new run
// takes the place of an old one, so that its beginning or its end stays where it is, and is written from the first
// index that differs to the last. A run that became longer uses the gaps next to its place; otherwise its neighbours
// slide, or it moves to the smallest gap that is large enough, or to the end of the buffer.
//
// Invariant, between updates. Each triangle on a strip is in one run, and run_of_ names its place. Runs do not overlap
// and are listed in the order of the buffer; the last cell of each separates it from the next. All other cells are in
// the gap after a place and hold filling(). All places are settled: only during an update a place is dirty, while its
// run is read, or claimed by the run that will take it.
//
// Stitched runs. Each begins at an even index with its first vertex twice, is wound for an odd place, and ends with its
// last vertex repeated, to an even length. So the triangles between runs, or between a run and a gap filled with one
// vertex, are always degenerate, and stitched runs can move like others.
//
// Order. At first runs are in an order that a vertex cache likes (order_of_runs). A run that does not fit into its
// place any more is put in the cheapest room next to a run that shares its edges.
//
// Length. A cut takes three indices, less the repeated index that it saves, and the buffer has gaps. When cuts and gaps
// together exceed 9.5 % of the indices needed, an update moves the last runs into gaps, which it may widen. The buffer
// of a scanned mesh has some 1.09 times the indices of strip_indices() while it changes, also after scattered
// operations, a stitched one up to 1.25 times the indices of a stitched strip. Strips that
// repeat no index, such as strips of a grid, take more: one cut for every 28 triangles is already 11 %. A triangle list
// has 3 indices a triangle. Separating stitched runs takes two and a half indices, other runs one.
//
// Time. An update takes time linear in the changed triangles, except for sorting the ranges that it returns: it reads
// their runs and short adjacent runs, slides at most 60 indices for each run that grows, 150 and three for each index
// that needs another place, and moves five for each to close gaps. Only the growth of arrays is linear in the mesh;
// reserve() allocates the two largest in advance. Memory: 4 bytes a triangle, the indices, and 40 bytes a run.
#include "output/strip_buffer.hpp"

#include <algorithm>
#include <utility>

#include "output/drawing_cache.hpp"
#include "restrip/precondition.hpp"

namespace restrip {

namespace {

// Chosen by measurement under all policies; in triangles.
constexpr std::uint32_t longest_joined_run = 28;  // runs of one strip that meet become one up to this
constexpr std::uint32_t cut_window = 4;           // the distance by which a cut may be off
constexpr std::uint32_t longest_run = longest_joined_run + 2 * cut_window;
// Chosen by measurement under all policies; in indices.
constexpr std::uint32_t moved_for_a_run = 60;      // at most, so that a run that grew stays where it is
constexpr std::uint32_t moved_for_an_update = 30;  // for each unit of work, to put runs near their neighbours
constexpr std::uint32_t moved_for_a_gap = 400;     // at most, so that the last run fits into it
constexpr std::uint32_t shortest_run = 4;
constexpr std::size_t neighbors_tried = 4;  // those with the most common edges

// A triangle entered over a halfedge; the edge is the exclusive or of its vertices.
struct EnteredTriangle {
  std::uint32_t edge;
  std::uint32_t apex;  // the corner opposite to it
};
EnteredTriangle entered_over(const StripMesh& mesh, StripMesh::Halfedge h) noexcept {
  const Vertex apex = mesh.from(StripMesh::next(StripMesh::next(h)));
  const std::array<Vertex, 3> corner = mesh.corners(StripMesh::triangle(h));
  return {corner[0] ^ corner[1] ^ corner[2] ^ apex, apex};
}

/// Numbers of runs, in an order for a cache of `cache` vertices, first in, first out. `cells` has the indices of the
/// runs, each with a separator at its end.
RESTRIP_COLD std::vector<std::uint32_t> order_of_runs(const detail::Cells& cells, const std::vector<detail::Run>& runs,
                                                      std::uint32_t cache) {
  constexpr unsigned most_tried = 64;
  std::vector<std::uint32_t> vertices;  // of all runs
  std::vector<std::uint32_t> ends;      // of each run, there
  vertices.reserve(cells.size());
  ends.reserve(runs.size());
  for (const detail::Run& run : runs) {
    for (std::uint32_t i = run.first; i + 1 < run.end(); ++i) vertices.push_back(cells[i]);
    ends.push_back(static_cast<std::uint32_t>(vertices.size()));
  }
  const auto vertices_of = [&](std::uint32_t r) {
    const std::uint32_t* const begin = vertices.data() + (r == 0 ? 0 : ends[r - 1]);
    return std::span(begin, vertices.data() + ends[r]);
  };
  detail::DrawingCache drawing(cache, vertices, ends);

  struct Trial {
    std::uint32_t run = none;
    std::uint64_t misses = 0;
    std::uint64_t triangles = 1;
  };
  std::vector<std::uint32_t> order;
  order.reserve(runs.size());
  for (std::uint32_t first = 0; order.size() < runs.size();) {
    Trial best;
    drawing.for_each_near(most_tried, 8 * most_tried, [&](std::uint32_t r) {
      const std::uint32_t before = drawing.try_from_here();
      std::uint32_t misses = before;
      for (const std::uint32_t v : vertices_of(r)) drawing.try_look_up(v, misses);
      const Trial here{r, misses - before, runs[r].triangles};
      if (best.run == none || here.misses * best.triangles < best.misses * here.triangles) best = here;
      return 1U;
    });
    if (best.run == none)
      drawing.for_each_left_behind([&](std::uint32_t r) {
        best.run = r;
        return false;
      });
    if (best.run == none) {
      while (drawing.is_drawn(first)) ++first;
      best.run = first;
    }
    order.push_back(best.run);
    drawing.draw(best.run);
    for (const std::uint32_t v : vertices_of(best.run)) drawing.look_up(v);
  }
  return order;
}
}  // namespace

StripBuffer::StripBuffer(StripForm form, const LayoutOptions& layout, IndexWidth width)
    : cells_(width), stitched_(form == StripForm::stitched), layout_(layout) {
  RESTRIP_ASSERT(form != StripForm::list, "StripBuffer", "use TriangleListBuffer for triangle lists");
}

// ---- from scratch

RESTRIP_COLD void StripBuffer::rebuild(const StripMesh& mesh) {
  stale_ = rebuilt_ = true;
  places_ = {};
  cells_.clear();
  run_of_.assign(mesh.triangle_bound(), nothing);
  const auto bound = static_cast<std::uint32_t>(mesh.triangle_bound());
  for (std::uint32_t t = 0; t < bound; ++t) {
    if (!mesh.alive(t) || run_of_[t] != nothing || mesh.solid_degree(t) > 1) continue;
    begin_reading();
    read(mesh, t);
    store();
    written_.clear();
  }
  if (layout_.cache != 0) order_runs();
  written_.assign(cells_.empty() ? 0 : 1, {0, cells_.size()});
  returned_ = true;
  stale_ = false;
}

RESTRIP_COLD void StripBuffer::order_runs() {
  std::vector<detail::Run> runs;
  std::vector<std::uint32_t> place;
  for (std::uint32_t p = places_.next(detail::RunPlaces::head); p != detail::RunPlaces::head; p = places_.next(p)) {
    runs.push_back(places_.run(p));
    place.push_back(p);
  }
  detail::Cells cells(cells_.width());
  cells.resize(cells_.size(), filling());
  std::vector<std::uint32_t> new_place(runs.size() + 1);  // by old place: without gaps they are 1 … runs
  detail::RunPlaces places;
  places.make_room(runs.size());
  places.set_length(places_.length());
  std::uint32_t end = 0;
  for (const std::uint32_t r : order_of_runs(cells_, runs, layout_.cache)) {
    detail::Run run = runs[r];
    cells.copy(cells_, run.first, run.length, end);
    run.first = std::exchange(end, end + run.length);
    new_place[place[r]] = places.insert(places.last(), run);
  }
  for (std::uint32_t& p : run_of_)
    if (p != nothing) p = new_place[p];
  cells_ = std::move(cells);
  places_ = std::move(places);
}

// ---- updates

std::span<const IndexRange> StripBuffer::update(const StripMesh& mesh, std::span<const std::uint32_t> changed,
                                                const RangeOptions& ranges) {
  if (stale_) {
    rebuild(mesh);
    return written_;
  }
  stale_ = true;
  rebuilt_ = false;
  if (std::exchange(returned_, true)) written_.clear();
  begin_reading();
  if (run_of_.size() < mesh.triangle_bound()) {
    detail::make_room(run_of_, mesh.triangle_bound() - run_of_.size());
    run_of_.resize(mesh.triangle_bound(), nothing);
  }
  for (const std::uint32_t t : changed)
    if (t < run_of_.size() && run_of_[t] != nothing) touch(run_of_[t]);
  for (const std::uint32_t t : changed) {
    if (t < mesh.triangle_bound() && mesh.alive(t)) {
      if (run_of_[t] != reading) read(mesh, t);
    } else if (t < run_of_.size()) {
      run_of_[t] = nothing;
    }
  }
  store();
  if (!changed.empty()) close_gaps();
  detail::join_ranges(written_, cells_.size(), ranges.merge_gap, ranges.align / cells_.index_bytes());
  stale_ = false;
  return written_;
}

void StripBuffer::begin_reading() noexcept {
  dirty_.clear();
  texts_.clear();
  across_.clear();
  links_ = letters_ = 0;
}

void StripBuffer::touch(std::uint32_t place) {
  if (places_.state(place) != State::settled) return;
  dirty_.push_back(place);
  places_.set_state(place, State::dirty);
}

// ---- the strip around a triangle

// Reads from the triangle of the halfedge `in` on. An edge that a triangle is entered over belongs to the link that the
// triangle has, or to the one before. The strip, from link `begin` on, will have `least` triangles at least. True if it
// continues in a run that stays as it is.
bool StripBuffer::follow(const StripMesh& mesh, StripMesh::Halfedge in, std::uint32_t begin, std::uint32_t least,
                         std::uint32_t edge_goes) {
  std::uint32_t links = links_;
  std::uint32_t known = nothing;  // a run that may be read
  bool stays = false;
  for (;;) {
    const std::uint32_t t = StripMesh::triangle(in);
    const std::uint32_t run = run_of_[t];
    if (run != known) {
      if (run == reading) break;
      if (run != nothing && places_.state(run) == State::settled) {
        stays = (std::max)(links - begin, least) + places_.run(run).triangles > longest_joined_run;
        if (stays) break;
        touch(run);
      }
      known = run;
    }
    run_of_[t] = reading;
    if (links == strip_.size()) strip_.resize(2 * strip_.size() + 64);
    Link* link = strip_.data() + links++;
    const EnteredTriangle seen = entered_over(mesh, in);
    link->triangle = t;
    link->corners = seen.edge ^ seen.apex;
    link->run = run;
    (link - edge_goes)->edge = seen.edge;
    const auto step = mesh.strip_step(in);
    if (!step.continues) break;
    in = step.in;
  }
  links_ = links;
  return stays;
}

// Reads the part of the strip through t that must be rewritten, and writes it as runs that are not too long.
void StripBuffer::read(const StripMesh& mesh, std::uint32_t t) {
  const std::uint32_t begin = links_;
  const std::uint32_t run = std::exchange(run_of_[t], reading);
  const std::uint32_t least = run != nothing ? places_.run(run).triangles : 1;
  auto h = StripMesh::halfedge(t);
  const EnteredTriangle seen = entered_over(mesh, h);
  std::array<StripMesh::Halfedge, 3> exits{h, h, h};  // the solid sides first
  unsigned ways = 0;
  for (int side = 0; side < 3; ++side, h = StripMesh::next(h)) {
    exits[ways] = h;
    ways += mesh.solid(h) ? 1U : 0U;
  }
  const bool cut_before = ways > 0 && follow(mesh, mesh.opposite(exits[0]), begin, least, 0);
  std::reverse(strip_.data() + begin, strip_.data() + links_);
  if (links_ == strip_.size()) strip_.resize(2 * links_ + 64);
  strip_[links_++] = {t, seen.edge ^ seen.apex, 0, run};
  const bool cut_behind = ways > 1 && follow(mesh, mesh.opposite(exits[1]), begin, 1, 1);
  const std::uint32_t triangles = links_ - begin;
  const std::uint32_t parts = triangles > longest_run ? (triangles - 1) / longest_joined_run + 1 : 1;
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
std::uint32_t StripBuffer::best_cut(std::uint32_t wanted, std::uint32_t begin) const noexcept {
  const auto turns_around = [&](std::uint32_t i) { return strip_[i - 1].edge ^ strip_[i].corners ^ strip_[i].edge; };
  std::uint32_t best = wanted;
  std::uint32_t most = 0;
  const std::uint32_t last = (std::min)(wanted + cut_window, links_ - 4);
  for (std::uint32_t cut = (std::max)(wanted - cut_window, begin + 3); cut <= last; ++cut) {
    std::uint32_t saved = 0;
    for (std::uint32_t i = cut - 2; i <= cut; ++i) saved += std::uint32_t{turns_around(i) == turns_around(i + 1)};
    if (saved > most) best = cut;
    most = (std::max)(most, saved);
  }
  return best;
}

// ---- a run as indices

// The first triangle from one end or the other.
StripBuffer::Start StripBuffer::start(const StripMesh& mesh, const Text& text, bool forward) const {
  Start start{&strip_[forward ? text.begin : text.end - 1], forward ? 1 : -1, forward ? 0 : -1, {}, false};
  const Link* link = start.link;
  auto h = StripMesh::halfedge(link->triangle);
  if (text.end - text.begin > 1)
    for (int i = 0; i < 2 && mesh.from(h) != (link->corners ^ link[start.edge].edge); ++i) h = StripMesh::next(h);
  for (std::uint32_t& corner : start.corner) {
    corner = mesh.from(h);
    h = StripMesh::next(h);
  }
  // At an odd place the winding needs the same edge in reverse.
  if (stitched_) std::swap(start.corner[1], start.corner[2]);
  link += start.step;
  if (text.end - text.begin > 2) start.swaps = (start.corner[2] ^ link->corners ^ link[start.edge].edge) == 0;
  return start;
}

// Whether the text begins or ends like the run that it replaces.
bool StripBuffer::is_forward(const Text& text) const noexcept {
  if (text.place == nothing || text.end - text.begin < 2) return true;
  const detail::Run& run = places_.run(text.place);
  const std::uint32_t first = strip_[text.begin].corners ^ strip_[text.begin].edge;
  const std::uint32_t last = strip_[text.end - 1].corners ^ strip_[text.end - 2].edge;
  const bool as_before = cells_[run.first] == first || cells_[run.end() - 2] == last;
  return as_before || (cells_[run.first] != last && cells_[run.end() - 2] != first);
}

void StripBuffer::write_text(const StripMesh& mesh, std::uint32_t begin, std::uint32_t end, std::uint32_t cuts) {
  const std::uint32_t triangles = end - begin;
  Text text{begin, end, letters_, 0, cuts, nothing, 0, 0};
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
  std::uint32_t largest = (std::max)({run.corner[0], p, q});
  std::uint32_t* out = text_.data() + letters_;
  if (stitched_) *out++ = run.corner[0];
  for (const std::uint32_t corner : run.corner) *out++ = corner;
  // Each further triangle has the last two indices p, q and adds its third corner x. If the strip leaves it over the
  // edge (p, x), p is repeated before x. Branch-free: turns are unpredictable.
  const Link* link = run.link;
  for (std::uint32_t i = 2; i < triangles; ++i) {
    link += run.step;
    const std::uint32_t x = link->corners ^ in;
    in = link[run.edge].edge;
    const auto repeats = std::uint32_t{(in ^ x) == p};
    *out = p;
    out += repeats;
    *out++ = x;
    p = q ^ ((p ^ q) & (0U - repeats));
    q = x;
    largest = (std::max)(largest, x);
  }
  if (triangles > 1) {
    const std::uint32_t x = (link + run.step)->corners ^ in;
    *out++ = x;
    largest = (std::max)(largest, x);
  }
  cells_.expect_fits(largest);
  const std::uint32_t separator = stitched_ ? *(out - 1) : cells_.restart();
  *out++ = separator;
  if (stitched_ && (static_cast<std::uint32_t>(out - text_.data()) - letters_) % 2 != 0) *out++ = separator;
  letters_ = static_cast<std::uint32_t>(out - text_.data());
  text.length = letters_ - text.first;
  text.across = static_cast<std::uint32_t>(across_.size());
  if (layout_.cache != 0 && !rebuilt_)
    for (std::uint32_t i = begin; i < end; ++i) note_across(mesh, strip_[i].triangle);
  text.across_end = static_cast<std::uint32_t>(across_.size());
  texts_.push_back(text);
}

// ---- places

void StripBuffer::store() {
  // Room for everything that follows, so that nothing throws after this.
  changed_ = 0;
  for (const std::uint32_t place : dirty_) changed_ += places_.run(place).length;
  changed_ = (std::max)(changed_, letters_);
  slack_ = moved_for_an_update * layout_.work;
  const std::size_t for_runs = texts_.size() * moved_for_a_run + std::size_t{layout_.work} * letters_ + slack_;
  const std::size_t for_gaps = moved_for_a_gap + std::size_t{layout_.work} * changed_;
  cells_.make_room(letters_ + 1);
  detail::make_room(written_, dirty_.size() + 3 * (texts_.size() + (for_runs + for_gaps) / shortest_run + 2));
  places_.make_room(texts_.size());
  for (const std::uint32_t place : dirty_)
    if (places_.state(place) == State::dirty) remove(place);
  for (Text& text : texts_)
    if (text.place != nothing && !store_in_place(text)) {
      remove(text.place);
      text.place = nothing;
    }
  for (const Text& text : texts_)
    if (text.place == nothing && (layout_.cache == 0 || rebuilt_ || !store_near(text))) store_in_gap(text);
}

// Stores the run where it was. False if the room is too small.
bool StripBuffer::store_in_place(const Text& text) noexcept {
  const std::uint32_t before = places_.previous(text.place);
  const std::uint32_t room = places_.limit(text.place) - places_.run(before).end();
  if (text.length > room) {
    const std::uint32_t missing = text.length - room;
    if (widen(before, places_.next(text.place), missing, moved_for_a_run) == 0) return false;
  }
  const detail::Run old = places_.run(text.place);
  std::uint32_t first = old.first;
  if (text.length != old.length) {
    // Keeps its beginning or its end, whichever is unchanged for longer.
    const std::uint32_t* then = text_.data() + text.first;
    const std::uint32_t both = (std::min)(text.length, old.length);
    std::uint32_t head = 0;
    while (head < both && cells_[old.first + head] == then[head]) ++head;
    std::uint32_t tail = 0;
    while (tail < both && cells_[old.end() - 1 - tail] == then[text.length - 1 - tail]) ++tail;
    const std::uint32_t high = places_.limit(text.place) - text.length;
    const bool fits_at_end = old.end() >= places_.run(before).end() + text.length;
    if (fits_at_end && (tail > head || first > high)) first = old.end() - text.length;
    first = (std::min)(first, high);
  }
  write(text, first);
  blank(old.first, (std::min)(first, old.end()));
  blank((std::max)(first + text.length, old.first), old.end());
  places_.set(text.place, as_run(text, first));
  own(text, text.place);
  return true;
}

// Stores the run in the smallest gap that is large enough, or at the end.
void StripBuffer::store_in_gap(const Text& text) noexcept {
  std::uint32_t before = places_.find_gap(text.length);
  if (before == nothing || places_.gap(before) < text.length) before = places_.last();
  const std::uint32_t first = places_.run(before).end();
  if (first + text.length > places_.limit(before)) {
    const std::uint32_t length = even(first + text.length);
    mark(cells_.size(), length);
    cells_.resize(length, filling());
    places_.set_length(length);
  }
  insert(text, before);
}

// Into the gap after `before`, which is large enough.
void StripBuffer::insert(const Text& text, std::uint32_t before) noexcept {
  const std::uint32_t first = places_.run(before).end();
  write(text, first);
  own(text, places_.insert(before, as_run(text, first)));
}

detail::Run StripBuffer::as_run(const Text& text, std::uint32_t first) const noexcept {
  return {first, text.length, text.end - text.begin, text.cuts};
}

void StripBuffer::own(const Text& text, std::uint32_t place) noexcept {
  for (std::uint32_t i = text.begin; i < text.end; ++i) run_of_[strip_[i].triangle] = place;
  places_.set_state(place, State::settled);
}

void StripBuffer::remove(std::uint32_t place) noexcept {
  blank(places_.run(place).first, places_.run(place).end());
  places_.remove(place);
}

// ---- rooms next to neighbours

void StripBuffer::note_across(const StripMesh& mesh, std::uint32_t t) {
  auto h = StripMesh::halfedge(t);
  for (int side = 0; side < 3; ++side, h = StripMesh::next(h))
    if (!mesh.solid(h))
      if (const auto back = mesh.opposite(h); !StripMesh::on_boundary(back))
        across_.push_back(StripMesh::triangle(back));
}

// The runs of some of across_, those with the most common edges first.
std::span<const StripBuffer::Neighbor> StripBuffer::neighbors(std::uint32_t begin, std::uint32_t end) noexcept {
  std::size_t count = 0;
  for (std::uint32_t i = begin; i < end; ++i) {
    const std::uint32_t place = run_of_[across_[i]];
    if (place >= reading) continue;
    const auto same = [place](const Neighbor& n) { return n.place == place; };
    auto* const neighbor = std::find_if(neighbors_.data(), neighbors_.data() + count, same);
    if (neighbor != neighbors_.data() + count)
      ++neighbor->edges;
    else if (count < neighbors_.size())
      neighbors_[count++] = {place, 1};
  }
  const auto before = [](const Neighbor& a, const Neighbor& b) {
    return a.edges != b.edges ? a.edges > b.edges : a.place < b.place;
  };
  const std::size_t tried = (std::min<std::size_t>)(count, neighbors_tried);
  for (std::size_t i = 0; i < tried; ++i)
    std::swap(neighbors_[i], *std::min_element(neighbors_.data() + i, neighbors_.data() + count, before));
  return {neighbors_.data(), tried};
}

// What widen() would move so that a run of `length` fits into the gap after `before`; more than `most` if it cannot.
std::uint32_t StripBuffer::price_of_room(std::uint32_t before, std::uint32_t length,
                                         std::uint32_t most) const noexcept {
  if (places_.next(before) == detail::RunPlaces::head) return most + 1;
  if (places_.gap(before) >= length) return 0;
  const std::uint32_t missing = length - places_.gap(before);
  const Slide right = slide(places_.next(before), missing, most, true);
  const Slide left = slide(before, missing, most, false);
  if (right.cost == 0) return left.cost == 0 ? most + 1 : left.cost;
  return left.cost == 0 ? right.cost : (std::min)(left.cost, right.cost);
}

// Stores the run in the cheapest gap next to one of its neighbours. False if no such gap is cheap enough.
bool StripBuffer::store_near(const Text& text) noexcept {
  const std::uint32_t share = (layout_.work + 1) / 2 * text.length;
  const std::uint32_t most = share + slack_;
  std::uint32_t best = nothing;
  std::uint32_t lowest = most + 1;
  const auto look_at = [&](std::uint32_t before) {
    const std::uint32_t moved = price_of_room(before, text.length, most);
    if (moved >= lowest) return;
    best = before;
    lowest = moved;
  };
  for (const Neighbor& neighbor : neighbors(text.across, text.across_end)) {
    look_at(neighbor.place);
    look_at(places_.previous(neighbor.place));
  }
  if (best == nothing) return false;
  if (const std::uint32_t gap = places_.gap(best); gap < text.length) {
    const std::uint32_t moved = widen(best, places_.next(best), text.length - gap, most);
    slack_ -= moved - (std::min)(moved, share);
  }
  insert(text, best);
  return true;
}

// ---- cells

// From the first index that differs to the last.
void StripBuffer::write(const Text& text, std::uint32_t first) noexcept {
  const IndexRange written = cells_.write(first, indices_of(text));
  mark(written.first, written.first + written.count);
}

void StripBuffer::blank(std::uint32_t first, std::uint32_t end) noexcept {
  if (first >= end) return;
  cells_.fill(first, end, filling());
  mark(first, end);
}

// Moves the run of a place to `first`, in the gap after `before` or within the gaps on both sides of it.
void StripBuffer::move(std::uint32_t place, std::uint32_t before, std::uint32_t first) noexcept {
  detail::Run run = places_.run(place);
  const std::uint32_t old = std::exchange(run.first, first);
  if (old == first) return;
  cells_.copy(cells_, old, run.length, first);
  mark(first, run.end());
  blank(old, (std::min)(first, old + run.length));
  blank((std::max)(run.end(), old), old + run.length);
  if (before == places_.previous(place)) return places_.set(place, run);
  places_.remove(place);
  places_.insert(before, run);  // into the same place: it was freed last
}

// Runs from `place` on in one direction, which slide in this direction until there are `missing` cells more. The cost,
// in indices moved, is 0 if it would exceed `most`. Runs that are to be written stay.
StripBuffer::Slide StripBuffer::slide(std::uint32_t place, std::uint32_t missing, std::uint32_t most,
                                      bool rightwards) const noexcept {
  for (Slide slide; place != detail::RunPlaces::head && places_.state(place) == State::settled;) {
    const std::uint32_t before = places_.previous(place);
    slide.cost += places_.run(place).length;
    if (slide.cost > most) break;
    slide.last = place;
    slide.found += places_.gap(rightwards ? place : before);
    if (slide.found >= missing) return slide;
    place = rightwards ? places_.next(place) : before;
  }
  return {};
}

// Slides runs from `right` on to the right, or runs up to `left` to the left, until `missing` more cells lie between
// the two. Returns the number of indices moved; 0 if it would exceed `most`.
std::uint32_t StripBuffer::widen(std::uint32_t left, std::uint32_t right, std::uint32_t missing,
                                 std::uint32_t most) noexcept {
  const Slide side = slide(right, missing, most, true);
  const bool rightwards = side.cost != 0;
  if (rightwards) most = side.cost - 1;
  if (const Slide other = slide(left, missing, most, false); other.cost != 0) {
    std::uint32_t first = places_.run(places_.previous(other.last)).end() + other.found - missing;
    for (std::uint32_t place = other.last;; place = places_.next(place)) {
      move(place, places_.previous(place), first);
      if (place == left) return other.cost;
      first = places_.run(place).end();
    }
  }
  if (!rightwards) return 0;
  std::uint32_t end = places_.limit(side.last) - (side.found - missing);
  for (std::uint32_t place = side.last;; place = places_.previous(place)) {
    end -= places_.run(place).length;
    move(place, places_.previous(place), end);
    if (place == right) return side.cost;
  }
}

// ---- gaps

// Moves the last run into a gap, repeatedly. A cut wastes some two and a half indices, four in stitched runs, half of
// them at each end.
void StripBuffer::close_gaps() noexcept {
  for (std::uint32_t moved = 0;;) {
    const std::uint32_t last = places_.last();
    const detail::Run run = places_.run(last);
    // A gap at the end is not a part of the buffer.
    if (const std::uint32_t length = even(run.end()); length < cells_.size()) {
      cells_.resize(length);
      places_.set_length(length);
    }
    const std::uint64_t needed = places_.used() - std::uint64_t{places_.cuts()} * (stitched_ ? 8 : 5) / 4;
    const bool wasteful = 1000 * (places_.length() - needed) > layout_.waste * needed;
    const std::uint32_t before = places_.find_gap(run.length);
    // The gap that makes a length even lies after the last run, which cannot move there.
    if (!wasteful || moved >= std::uint64_t{layout_.work} * changed_ || before == nothing || before == last) return;
    if (places_.gap(before) < run.length && places_.next(before) != last) {
      const std::uint32_t missing = run.length - places_.gap(before);
      const std::uint32_t cost = widen(before, places_.next(before), missing, moved_for_a_gap);
      if (cost == 0) return;
      moved += cost;
    }
    move(last, before, places_.run(before).end());
    moved += run.length;
  }
}

// ---- ranges written

void StripBuffer::mark(std::size_t first, std::size_t end) noexcept {
  if (first == end) return;
  // A write is mostly adjacent to the previous one.
  if (!written_.empty()) {
    Range& last = written_.back();
    const std::size_t last_end = last.first + last.count;
    if (first <= last_end && last.first <= end) {
      last.first = (std::min)(last.first, first);
      last.count = (std::max)(last_end, end) - last.first;
      return;
    }
  }
  written_.push_back({first, end - first});
}

void StripBuffer::draws(std::vector<Range>& draws) const {
  draws.clear();
  for (std::uint32_t p = places_.next(detail::RunPlaces::head); p != detail::RunPlaces::head; p = places_.next(p))
    draws.push_back({places_.run(p).first, places_.run(p).length - std::size_t{1}});
}

void detail::join_ranges(std::vector<IndexRange>& ranges, std::size_t end, std::size_t gap, std::size_t unit) noexcept {
  unit = (std::max)(unit, std::size_t{1});
  for (IndexRange& range : ranges) {
    std::size_t stop = (std::min)(range.first + range.count, end);
    if (const std::size_t over = stop % unit; over != 0) stop += (std::min)(unit - over, end - stop);
    range.first -= range.first % unit;
    range.count = stop - (std::min)(range.first, stop);
  }
  std::sort(ranges.begin(), ranges.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::size_t kept = 0;
  for (const auto& [first, count] : ranges) {
    const std::size_t stop = first + count;
    if (count == 0) break;
    const std::size_t joined = kept == 0 ? 0 : ranges[kept - 1].first + ranges[kept - 1].count;
    if (kept == 0 || (first > joined && first - joined > gap)) ranges[kept++] = {first, 0};
    IndexRange& last = ranges[kept - 1];
    last.count = (std::max)(last.count, stop - last.first);
  }
  ranges.resize(kept);
}

}  // namespace restrip
