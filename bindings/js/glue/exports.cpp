// The functions that JavaScript calls (bindings/js/restrip.mjs), with numbers and addresses only. A caller writes
// arguments that are lists into memory taken by restrip_take; a function that returns a list returns the address of a
// List, which is valid until the next call of any function. A call that ends by a trap has left its reason in
// restrip_stopped_because.
#include <cstdlib>
#include <limits>
#include <new>

#include "session.hpp"

#ifdef __wasm__
// Functions that the standard library of WebAssembly calls when memory runs out or when it would throw. Its own
// versions print, for which the module would import files. These stop the module instead.
void* operator new(std::size_t bytes) {
  void* memory = std::malloc(bytes != 0 ? bytes : 1);
  if (memory == nullptr) RESTRIP_THROW(std::bad_alloc, "restrip: out of memory");
  return memory;
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept { return std::malloc(bytes != 0 ? bytes : 1); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }

#if _LIBCPP_VERSION >= 150000
void std::__libcpp_verbose_abort(const char*, ...) noexcept { __builtin_trap(); }
#endif
#define RESTRIP_EXPORT(Result, name) extern "C" __attribute__((export_name(#name))) Result name
#else  // compiled only as a check
#define RESTRIP_EXPORT(Result, name) extern "C" Result name
#endif

namespace {

using namespace restrip;
using namespace restrip::web;

struct List {
  const void* data = nullptr;
  std::uint32_t size = 0;      // elements
  std::uint32_t outgrown = 0;  // of ranges to upload
};
List list;

struct Page {
  std::unique_ptr<Session> session;  // null if the bytes of a file were refused
  std::string damage;                // why
  BuildReport left_out;
  StripMesh scratch;  // of restrip_from_scratch
  std::vector<std::uint32_t> scratch_indices;
};

/// A mesh that is being simplified.
struct Simplifying {
  std::size_t points;
  BuildReport left_out;
  Simplifier simplifier;

  Simplifying(std::span<const std::array<float, 3>> places, std::span<const Corners> triangles)
      : points(places.size()), simplifier(StripMesh::build(triangles, points, &left_out), in_64_bits(places)) {}
  static std::vector<Simplifier::Point> in_64_bits(std::span<const std::array<float, 3>> points) {
    std::vector<Simplifier::Point> all(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) all[i] = {points[i][0], points[i][1], points[i][2]};
    return all;
  }
};

/// A triangle of the picture. `beyond` and `joined` are by its sides, side i from corner i to the next one: the
/// triangle there, `none` at the boundary, and bit i if the strip continues to it.
struct PaintedTriangle {
  Triangle triangle = none;
  Corners corners{};
  std::array<Triangle, 3> beyond{};
  std::uint32_t joined = 0;
  std::uint32_t strip = 0;  ///< named by its lowest triangle
};

/// A count or a member of an enumeration, as JavaScript reads it.
template <class Number>
constexpr std::uint32_t word(Number number) noexcept {
  return static_cast<std::uint32_t>(number);
}

template <class Element>
const List* give(std::span<const Element> elements) {
  list.data = elements.data();
  list.size = word(elements.size());
  return &list;
}

/// A patch: closed, k, a, two masks as two numbers each, then its triangles, three corners each.
const List* give_patch(const StripMesh& mesh, const PatchColors& colors, const std::vector<Triangle>& triangles) {
  static std::vector<std::uint32_t> words;
  words = {
      colors.closed ? 1U : 0U, colors.k, colors.a, word(colors.edges), word(colors.edges >> 32), word(colors.ports),
      word(colors.ports >> 32)};
  for (const Triangle t : triangles)
    for (const Vertex v : mesh.corners(t)) words.push_back(v);
  return give(std::span<const std::uint32_t>(words));
}

Cost cost_of(std::uint32_t restart, std::uint32_t swap, std::uint32_t isolated) {
  const auto weight = [](std::uint32_t w) { return static_cast<std::uint16_t>(std::min(w, 1000U)); };
  return {weight(restart), weight(swap), weight(isolated)};
}

StripFormat format_of(std::uint32_t form, std::uint32_t bits) {
  return {.form = static_cast<StripForm>(form % 4),
          .width = bits == 16   ? IndexWidth::bits16
                   : bits == 32 ? IndexWidth::bits32
                                : IndexWidth::automatic};
}

}  // namespace

// ---- memory
RESTRIP_EXPORT(void*, restrip_take)(std::uint32_t bytes) { return std::malloc(bytes); }
RESTRIP_EXPORT(void, restrip_give_back)(void* memory) { std::free(memory); }
#ifdef __wasm__
/// The reason of the last call that ended by a trap, or null; reading it clears it.
RESTRIP_EXPORT(const char*, restrip_stopped_because)() { return std::exchange(stopped_because, nullptr); }
#endif

// ---- a mesh
/// `splits`: v_s, v_t, v_l, v_r each.
RESTRIP_EXPORT(Page*, restrip_open)
(std::uint32_t point_count, const Corners* base, std::uint32_t base_count, const Record* splits,
 std::uint32_t split_count) {
  Progressive source{{base, base + base_count}, {splits, splits + split_count}, point_count};
  auto* page = new Page;
  page->session = std::make_unique<Session>(std::move(source), &page->left_out);
  return page;
}
RESTRIP_EXPORT(Simplifying*, restrip_simplify_begin)
(const std::array<float, 3>* points, std::uint32_t point_count, const Corners* triangles,
 std::uint32_t triangle_count) {
  return new Simplifying({points, point_count}, {triangles, triangle_count});
}
/// Does at most `most` collapses and returns the excess of triangles; 0 when it has ended.
RESTRIP_EXPORT(std::uint32_t, restrip_simplify_run)(Simplifying* mesh, std::uint32_t wanted, std::uint32_t most) {
  return mesh->simplifier.run(wanted, most) ? 0 : word(mesh->simplifier.mesh().triangle_count() - wanted);
}
/// Opens the resulting mesh and removes the simplifier.
RESTRIP_EXPORT(Page*, restrip_simplify_end)(Simplifying* mesh) {
  const std::unique_ptr<Simplifying> owned(mesh);
  const auto& collapses = owned->simplifier.collapses();
  auto* page = new Page;
  page->left_out = owned->left_out;
  page->session = std::make_unique<Session>(
      Progressive{triangles_of(owned->simplifier.mesh()), {collapses.rbegin(), collapses.rend()}, owned->points});
  return page;
}
RESTRIP_EXPORT(Page*, restrip_open_baked)(const std::byte* bytes, std::uint32_t count) {
  auto* page = new Page;
  BakedFile file;
  page->damage = read_baked({bytes, count}, file);
  if (!page->damage.empty()) return page;
  page->session = std::make_unique<Session>(std::move(file), &page->left_out);
  return page;
}
/// The bytes of restrip_save, for a mesh whose vertices have this many points.
RESTRIP_EXPORT(Page*, restrip_open_saved)
(const std::byte* bytes, std::uint32_t count, std::uint32_t points, std::uint32_t history) {
  LiveMesh live = LiveMesh::load({bytes, count}, history);
  auto* page = new Page;
  if (live.mesh().vertex_bound() > points)
    page->damage = "it has " + std::to_string(live.mesh().vertex_bound()) + " vertices";
  else
    page->session = std::make_unique<Session>(std::move(live));
  return page;
}
/// Why the bytes were refused, in which case only restrip_close may be called; otherwise empty.
RESTRIP_EXPORT(const char*, restrip_damage)(const Page* page) { return page->damage.c_str(); }
RESTRIP_EXPORT(void, restrip_close)(Page* page) { delete page; }
RESTRIP_EXPORT(std::uint32_t, restrip_levels)(const Page* page) { return word(page->session->source().splits.size()); }
RESTRIP_EXPORT(std::uint32_t, restrip_refused_record)(const Page* page) {
  return word(page->session->refused_record());
}
RESTRIP_EXPORT(std::uint32_t, restrip_left_out)(const Page* page, std::uint32_t what) {
  const BuildReport& r = page->left_out;
  const std::size_t counts[] = {r.degenerate_triangles + r.out_of_range_triangles, r.non_manifold_vertices,
                                r.boundary_edges};
  return what < std::size(counts) ? word(counts[what]) : 0;
}
RESTRIP_EXPORT(const List*, restrip_splits)(const Page* page) {
  return give(std::span<const Record>(page->session->source().splits));
}
/// See Session::needs; `first`: the beginnings.
RESTRIP_EXPORT(const List*, restrip_needs)(const Page* page, std::uint32_t first) {
  return give(first != 0 ? page->session->first_need() : page->session->needs());
}
/// Null unless it has baked strips; three coordinates for each of the file's points.
RESTRIP_EXPORT(const List*, restrip_baked_points)(const Page* page) {
  const BakedFile* const file = page->session->file();
  return file == nullptr ? nullptr : give(std::span(file->points));
}

// ---- maintained strips
/// Null above the last policy.
RESTRIP_EXPORT(const char*, restrip_policy_name)(std::uint32_t policy) {
  return policy < policies.size() ? policies[policy].name : nullptr;
}
/// `policy`: none for baked strips. `form` as StripForm; `bits` 16, 32 or 0. See LiveOptions and LayoutOptions.
RESTRIP_EXPORT(void, restrip_begin)
(Page* page, std::uint32_t points, std::uint32_t policy, std::uint32_t restart, std::uint32_t swap,
 std::uint32_t isolated, std::uint32_t form, std::uint32_t bits, std::uint32_t history, std::uint32_t cache,
 std::uint32_t waste, std::uint32_t work) {
  LiveOptions options{.cost = cost_of(restart, swap, isolated),
                      .history = history,
                      .format = format_of(form, bits),
                      .layout = {cache, waste, work}};
  if (policy < policies.size()) options.policy = policies[policy].policy;
  page->session->begin(options, policy >= policies.size(), points);
}
RESTRIP_EXPORT(void, restrip_keep)
(Page* page, std::uint32_t policy, std::uint32_t restart, std::uint32_t swap, std::uint32_t isolated) {
  page->session->live().keep(policies[policy % policies.size()].policy, cost_of(restart, swap, isolated));
}
/// `effort` as Effort. Returns the number of strips.
RESTRIP_EXPORT(std::uint32_t, restrip_recolor)
(Page* page, std::uint32_t effort, std::uint32_t restart, std::uint32_t swap, std::uint32_t isolated) {
  return word(page->session->live().recolor(static_cast<Effort>(effort % 3), cost_of(restart, swap, isolated)));
}
RESTRIP_EXPORT(std::uint32_t, restrip_improve)(Page* page, std::uint32_t budget) {
  return word(page->session->live().improve(budget));
}
RESTRIP_EXPORT(void, restrip_play)(Page* page, const std::uint32_t* records, std::uint32_t count) {
  page->session->play({records, count});
}
/// By record: 1 if it is split.
RESTRIP_EXPORT(const List*, restrip_played)(const Page* page) {
  static std::vector<std::uint8_t> played;
  played.resize(page->session->source().splits.size());
  for (std::size_t i = 0; i < played.size(); ++i) played[i] = page->session->is_split(i) ? 1 : 0;
  return give(std::span<const std::uint8_t>(played));
}
RESTRIP_EXPORT(std::uint32_t, restrip_split)
(Page* page, std::uint32_t v_s, std::uint32_t v_t, std::uint32_t v_l, std::uint32_t v_r) {
  return word(page->session->split({v_s, v_t, v_l, v_r}));
}
RESTRIP_EXPORT(std::uint32_t, restrip_collapse)(Page* page, std::uint32_t v_s, std::uint32_t v_t) {
  return word(page->session->collapse(v_s, v_t));
}
RESTRIP_EXPORT(std::uint32_t, restrip_flip)(Page* page, std::uint32_t u, std::uint32_t v) {
  return word(page->session->flip(u, v));
}
RESTRIP_EXPORT(std::uint32_t, restrip_bisect)(Page* page, std::uint32_t u, std::uint32_t v) {
  return word(page->session->bisect(u, v));
}
RESTRIP_EXPORT(std::uint32_t, restrip_split_face)(Page* page, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  return word(page->session->split_face(a, b, c));
}
RESTRIP_EXPORT(std::uint32_t, restrip_new_vertex)(const Page* page) { return page->session->new_vertex(); }
RESTRIP_EXPORT(std::uint32_t, restrip_next_vertex)(const Page* page) { return page->session->mesh().next_vertex(); }
/// 1 if indices of this format can name the vertex.
RESTRIP_EXPORT(std::uint32_t, restrip_can_name)(const Page* page, std::uint32_t v) {
  return v <= highest_index16 || page->session->live().buffer().format().width != IndexWidth::bits16 ? 1 : 0;
}
RESTRIP_EXPORT(const char*, restrip_describe)(std::uint32_t refusal) { return describe(static_cast<Refusal>(refusal)); }

/// The neighbours of a vertex; of a non-manifold one only some. Empty if the mesh does not have it.
RESTRIP_EXPORT(const List*, restrip_around)(const Page* page, std::uint32_t v) {
  static std::vector<Vertex> around;
  around.clear();
  const StripMesh& mesh = page->session->mesh();
  if (v < mesh.vertex_bound() && mesh.spoke(v).id != none)
    for_each_spoke(mesh, v, [&](StripMesh::Halfedge h) { around.push_back(mesh.to(h)); });
  return give(std::span<const Vertex>(around));
}
RESTRIP_EXPORT(std::uint32_t, restrip_apex)(const Page* page, std::uint32_t u, std::uint32_t v) {
  return page->session->apex(u, v);
}
/// The patch before a split, and after it, or null if the mesh does not have its edges.
RESTRIP_EXPORT(const List*, restrip_fan)
(const Page* page, std::uint32_t v_s, std::uint32_t v_l, std::uint32_t v_r) {
  const StripMesh& mesh = page->session->mesh();
  const Where where = find_spokes(mesh, {v_s, none, v_l, v_r});
  const bool both = where.left.id != none && where.right.id != none;
  if (!both && where.spokes == Where::Spokes::both) return nullptr;
  const Halfedge first = where.left.id != none ? where.left : where.right;
  if (first.id == none) return nullptr;
  std::vector<Triangle> triangles;
  fan_triangles(mesh, first, triangles);
  return give_patch(mesh, both ? fan_colors(mesh, where.left, where.right) : PatchColors{}, triangles);
}
RESTRIP_EXPORT(const List*, restrip_ring)(const Page* page, std::uint32_t v_s, std::uint32_t v_t) {
  const StripMesh& mesh = page->session->mesh();
  const Halfedge chord = page->session->live().edge(v_s, v_t);
  if (chord.id == none) return nullptr;
  std::vector<Triangle> triangles;
  edge_triangles(mesh, chord, triangles);
  return give_patch(mesh, ring_colors(mesh, chord), triangles);
}

// ---- the index buffer
RESTRIP_EXPORT(const List*, restrip_update)(Page* page, std::uint32_t join, std::uint32_t align) {
  const Upload upload = page->session->live().update({join, align});
  list.outgrown = upload.outgrown ? 1 : 0;
  return give(std::span<const IndexRange>(upload));
}
/// The bytes of the buffer; each index has restrip_index_bytes().
RESTRIP_EXPORT(const List*, restrip_indices)(const Page* page) { return give(page->session->live().bytes()); }
RESTRIP_EXPORT(std::uint32_t, restrip_index_bytes)(const Page* page) {
  return word(page->session->live().index_bytes());
}
RESTRIP_EXPORT(std::uint32_t, restrip_room)(const Page* page) { return word(page->session->live().room()); }
/// The runs to be drawn one by one, for StripForm::lengths; else one range.
RESTRIP_EXPORT(const List*, restrip_draws)(const Page* page) {
  static std::vector<IndexRange> draws;
  page->session->live().buffer().draws(draws);
  return give(std::span<const IndexRange>(draws));
}
RESTRIP_EXPORT(const List*, restrip_from_scratch)
(Page* page, std::uint32_t restart, std::uint32_t swap, std::uint32_t isolated, std::uint32_t cache_size,
 double cache_weight) {
  StripMesh& scratch = page->scratch = page->session->mesh();
  stripify(scratch, Effort::fast, cost_of(restart, swap, isolated));
  page->scratch_indices = cache_size == 0
                              ? strip_indices(scratch)
                              : strip_indices(scratch, strips_for_vertex_cache(scratch, {cache_size, cache_weight}));
  return give(std::span<const std::uint32_t>(page->scratch_indices));
}
RESTRIP_EXPORT(const List*, restrip_triangles)(const Page* page) {
  static std::vector<Corners> corners;
  corners = triangles_of(page->session->mesh());
  return give(std::span<const Corners>(corners));
}

// ---- history
/// 1: a frame was undone, or redone.
RESTRIP_EXPORT(std::uint32_t, restrip_step)(Page* page, std::uint32_t forward) {
  LiveMesh& live = page->session->live();
  return (forward != 0 ? live.redo() : live.undo()) ? 1 : 0;
}
/// The frames that can be undone, and redone; the number of the present frame.
RESTRIP_EXPORT(const List*, restrip_frames)(const Page* page) {
  static std::array<std::uint32_t, 3> frames;
  const LiveMesh& live = page->session->live();
  frames = {word(live.undoable()), word(live.redoable()), word(live.frame())};
  return give(std::span<const std::uint32_t>(frames));
}
RESTRIP_EXPORT(const List*, restrip_save)(Page* page) {
  static std::vector<std::byte> bytes;
  bytes = page->session->live().save();
  return give(std::span<const std::byte>(bytes));
}

// ---- figures
RESTRIP_EXPORT(const Figures*, restrip_figures)(Page* page) { return &page->session->figures(); }
RESTRIP_EXPORT(std::uint32_t, restrip_plain_indices)(const Page* page) {
  return word(strip_indices(page->session->mesh()).size());
}
/// 1: the colouring is valid, checked from its definition.
RESTRIP_EXPORT(std::uint32_t, restrip_valid)(const Page* page) {
  return check_coloring(page->session->mesh()).valid ? 1 : 0;
}

// ---- pictures: linear in the mesh; called only while such a picture is shown
/// The triangles with their strips, strip by strip. `scratch`: whether to use the strips from scratch.
RESTRIP_EXPORT(const List*, restrip_ribbon)(Page* page, std::uint32_t scratch) {
  static std::vector<PaintedTriangle> ribbon;
  const StripMesh& mesh = scratch != 0 ? page->scratch : page->session->mesh();
  const Strips strips = extract_strips(mesh);
  ribbon.clear();
  for (std::size_t s = 0; s < strips.size(); ++s) {
    const Triangle lowest = *std::min_element(strips[s].begin(), strips[s].end());
    for (const Triangle t : strips[s]) {
      PaintedTriangle& painted = ribbon.emplace_back(PaintedTriangle{t, mesh.corners(t), {}, 0, lowest});
      for (unsigned side = 0; side < 3; ++side) {
        const Halfedge h = StripMesh::halfedge(t, side);
        const Halfedge back = mesh.opposite(h);
        painted.beyond[side] = StripMesh::on_boundary(back) ? none : StripMesh::triangle(back);
        if (mesh.solid(h)) painted.joined |= 1U << side;
      }
    }
  }
  return give(std::span<const PaintedTriangle>(ribbon));
}
// ---- rules
/// `family`: 0 split, 1 collapse (x = a), 2 open split, 3 open collapse (x, y: the gaps), 4 boundary split, 5 boundary
/// collapse (x: the gap), 6 flip. The answer: valid, change of strips, colours as two numbers, ports kept (of flips).
/// Positions that do not exist are not valid.
RESTRIP_EXPORT(const List*, restrip_rule)
(std::uint32_t family, std::uint32_t k, std::uint32_t x, std::uint32_t y, std::uint64_t edges, std::uint64_t ports) {
  static std::array<std::uint32_t, 5> answer;
  Rule rule;
  Word kept = ports;
  const bool fits = k >= (family < 2 ? 3U : 1U) && k <= max_word_valence;
  if (family < 2 && fits && x >= 1 && x < k) {
    rule = family == 0 ? split_rule({k, x}, edges & low_bits(k), ports & low_bits(k))
                       : collapse_rule({k, x}, edges & low_bits(k + 3), ports & low_bits(k));
  } else if ((family == 2 || family == 3) && fits && x < y && y <= k) {
    rule = family == 2 ? open_split_rule({k, x, y}, edges & low_bits(k - 1), ports & low_bits(k))
                       : open_collapse_rule({k, x, y}, edges & low_bits(k + 2), ports & low_bits(k));
  } else if ((family == 4 || family == 5) && fits && x <= k) {
    rule = family == 4 ? boundary_split_rule({k, x}, edges & low_bits(k - 1), ports & low_bits(k))
                       : boundary_collapse_rule({k, x}, edges & low_bits(k), ports & low_bits(k));
  } else if (family == 6) {
    const FlipRule flip = flip_rule((edges & 1U) != 0, static_cast<unsigned>(ports & 15U));
    rule = {flip.inner ? Word{1} : Word{0}, flip.strips, flip.valid};
    kept = flip.ports;
  }
  answer = {rule.valid ? 1U : 0U, word(rule.strips), word(rule.colors), word(rule.colors >> 32), word(kept)};
  return give(std::span<const std::uint32_t>(answer));
}
