// The functions that JavaScript calls (bindings/js/restrip.mjs), with numbers and addresses only. A caller writes
// arguments that are lists into memory taken by restrip_take; a function that returns a list returns the address of a
// List, which is valid until the next call of any function.
#include <cstdlib>
#include <new>

#include "session.hpp"

#ifdef __wasm__
// Functions that the standard library of WebAssembly calls when memory runs out or when it would throw. Its own
// versions print, for which the module would import files. These stop the module instead.
void* operator new(std::size_t bytes) {
  void* memory = std::malloc(bytes != 0 ? bytes : 1);
  if (memory == nullptr) __builtin_trap();
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
  std::uint32_t size = 0;  // elements
};
List list;

struct Page {
  std::unique_ptr<Session> session;  // null if the bytes of a baked mesh were refused
  std::string damage;                // why
  BuildReport left_out;
};

/// A mesh that is being simplified.
struct Simplifying {
  std::vector<float> points;
  BuildReport left_out;
  Simplifier simplifier;

  Simplifying(std::vector<float> places, std::span<const Corners> triangles)
      : points(std::move(places)),
        simplifier(StripMesh::build(triangles, points.size() / 3, &left_out), in_64_bits(points)) {}
  static std::vector<Simplifier::Point> in_64_bits(const std::vector<float>& points) {
    std::vector<Simplifier::Point> all(points.size() / 3);
    for (std::size_t i = 0; i < points.size() / 3 * 3; ++i) all[i / 3][i % 3] = points[i];
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
  list = {elements.data(), word(elements.size())};
  return &list;
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

// ---- a mesh
/// `splits`: v_s, v_t, v_l, v_r each.
RESTRIP_EXPORT(Page*, restrip_open)
(const float* points, std::uint32_t point_count, const Corners* base, std::uint32_t base_count, const Record* splits,
 std::uint32_t split_count) {
  Progressive source{{base, base + base_count}, {splits, splits + split_count}, point_count};
  auto* page = new Page;
  page->session = std::make_unique<Session>(
      std::move(source), std::vector<float>(points, points + 3 * std::size_t{point_count}), &page->left_out);
  return page;
}
RESTRIP_EXPORT(Simplifying*, restrip_simplify_begin)
(const float* points, std::uint32_t point_count, const Corners* triangles, std::uint32_t triangle_count) {
  return new Simplifying({points, points + 3 * std::size_t{point_count}}, {triangles, triangle_count});
}
/// Does at most `most` collapses and returns the excess of triangles; 0 when it has ended.
RESTRIP_EXPORT(std::uint32_t, restrip_simplify_run)(Simplifying* mesh, std::uint32_t wanted, std::uint32_t most) {
  return mesh->simplifier.run(wanted, most) ? 0 : word(mesh->simplifier.mesh().triangle_count() - wanted);
}
/// Opens the resulting mesh and removes the simplifier.
RESTRIP_EXPORT(Page*, restrip_simplify_end)(Simplifying* mesh) {
  const std::unique_ptr<Simplifying> owned(mesh);
  const auto& collapses = owned->simplifier.collapses();
  Progressive made{{}, {collapses.rbegin(), collapses.rend()}, owned->points.size() / 3};
  const StripMesh& coarse = owned->simplifier.mesh();
  for (Triangle t = 0; t < coarse.triangle_bound(); ++t)
    if (coarse.alive(t)) made.base.push_back(coarse.corners(t));
  auto* page = new Page;
  page->left_out = owned->left_out;
  page->session = std::make_unique<Session>(std::move(made), std::move(owned->points));
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
/// Why the bytes of a baked mesh were refused; then nothing but restrip_close may be called. Else empty.
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
RESTRIP_EXPORT(const List*, restrip_points)(const Page* page) { return give(page->session->points()); }
RESTRIP_EXPORT(std::uint32_t, restrip_has_baked_strips)(const Page* page) {
  return page->session->has_baked_strips() ? 1 : 0;
}

// ---- maintained strips
/// Null above the last policy.
RESTRIP_EXPORT(const char*, restrip_policy_name)(std::uint32_t policy) {
  return policy < policies.size() ? policies[policy].name : nullptr;
}
RESTRIP_EXPORT(std::uint32_t, restrip_add_point)(Page* page, float x, float y, float z) {
  return page->session->add_point({x, y, z});
}
RESTRIP_EXPORT(void, restrip_set_point)(Page* page, std::uint32_t v, float x, float y, float z) {
  page->session->set_point(v, {x, y, z});
}
/// 1: single operations have changed the mesh since begin, so records can no longer be played.
RESTRIP_EXPORT(std::uint32_t, restrip_left_records)(const Page* page) { return page->session->left_records() ? 1 : 0; }
/// `form` as StripForm; `bits` 16, 32 or 0.
RESTRIP_EXPORT(void, restrip_begin)
(Page* page, std::uint32_t form, std::uint32_t bits, std::uint32_t policy, std::uint32_t restart, std::uint32_t swap,
 std::uint32_t isolated) {
  page->session->begin(policies[policy % policies.size()].policy, cost_of(restart, swap, isolated),
                       format_of(form, bits));
}
RESTRIP_EXPORT(void, restrip_begin_baked)(Page* page, std::uint32_t form, std::uint32_t bits) {
  page->session->begin_baked(format_of(form, bits));
}
RESTRIP_EXPORT(std::uint32_t, restrip_move)(Page* page, std::uint32_t level, std::uint32_t most) {
  return word(page->session->move(level, most));
}
RESTRIP_EXPORT(std::uint32_t, restrip_approach)(Page* page, const std::uint8_t* wanted, std::uint32_t most) {
  return word(page->session->approach({wanted, page->session->source().splits.size()}, most));
}
RESTRIP_EXPORT(const List*, restrip_ready)(Page* page) { return give(page->session->ready()); }
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

// ---- the index buffer
RESTRIP_EXPORT(const List*, restrip_update)(Page* page, std::uint32_t join, std::uint32_t align) {
  return give(page->session->update({join, align}));
}
/// The bytes of the buffer; each index has restrip_index_bytes().
RESTRIP_EXPORT(const List*, restrip_indices)(const Page* page) { return give(page->session->buffer().bytes()); }
RESTRIP_EXPORT(std::uint32_t, restrip_index_bytes)(const Page* page) {
  return word(page->session->buffer().index_bytes());
}
RESTRIP_EXPORT(std::uint32_t, restrip_room)(const Page* page) { return word(page->session->buffer().room()); }
RESTRIP_EXPORT(std::uint32_t, restrip_outgrown)(const Page* page) { return page->session->outgrown() ? 1 : 0; }
/// The runs to be drawn one by one, for StripForm::lengths; else one range.
RESTRIP_EXPORT(const List*, restrip_draws)(const Page* page) {
  static std::vector<IndexRange> draws;
  page->session->buffer().draws(draws);
  return give(std::span<const IndexRange>(draws));
}
RESTRIP_EXPORT(const List*, restrip_update_list)(Page* page, std::uint32_t whole) {
  return give(page->session->update_list(whole != 0));
}
RESTRIP_EXPORT(const List*, restrip_list)(const Page* page) { return give(page->session->list()); }
RESTRIP_EXPORT(const List*, restrip_from_scratch)
(Page* page, std::uint32_t restart, std::uint32_t swap, std::uint32_t isolated, std::uint32_t cache_size,
 double cache_weight) {
  return give(page->session->from_scratch(cost_of(restart, swap, isolated), {cache_size, cache_weight}));
}
RESTRIP_EXPORT(const List*, restrip_triangles)(const Page* page) {
  static std::vector<Corners> corners;
  corners.clear();
  const StripMesh& mesh = page->session->mesh();
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.alive(t)) corners.push_back(mesh.corners(t));
  return give(std::span<const Corners>(corners));
}

// ---- figures
RESTRIP_EXPORT(const Figures*, restrip_figures)(Page* page) { return &page->session->figures(); }
RESTRIP_EXPORT(std::uint32_t, restrip_plain_indices)(const Page* page) {
  return word(strip_indices(page->session->mesh()).size());
}
/// A lower bound on indices of this mesh: the quick one, because a page waits for it.
RESTRIP_EXPORT(std::uint32_t, restrip_index_bound)(const Page* page) {
  return word(strip_index_lower_bound(page->session->mesh(), 0).indices);
}
/// 1: the colouring is valid, checked from its definition.
RESTRIP_EXPORT(std::uint32_t, restrip_valid)(const Page* page) {
  return check_coloring(page->session->mesh()).valid ? 1 : 0;
}

// ---- pictures: linear in the mesh; called only while such a picture is shown
/// The triangles with their strips, strip by strip. `scratch`: whether to use the strips from scratch.
RESTRIP_EXPORT(const List*, restrip_ribbon)(Page* page, std::uint32_t scratch) {
  static std::vector<PaintedTriangle> ribbon;
  const StripMesh& mesh = scratch != 0 ? page->session->scratch() : page->session->mesh();
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
/// The nearest triangle that a ray meets, and where (three numbers); empty when it meets none.
RESTRIP_EXPORT(const List*, restrip_pick)(Page* page, float x, float y, float z, float dx, float dy, float dz) {
  static std::array<float, 3> hit;
  using Point = Vector<float>;
  const Point from{x, y, z};
  const Point along{dx, dy, dz};
  const auto point = [points = page->session->points()](Vertex v) -> Point {
    const auto p = points.subspan(3 * std::size_t{v}, 3);
    return {p[0], p[1], p[2]};
  };
  float nearest = std::numeric_limits<float>::max();
  const StripMesh& mesh = page->session->mesh();
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    if (!mesh.alive(t)) continue;
    const auto [i, j, k] = mesh.corners(t);
    // The distance along the ray (Moller and Trumbore 1997).
    const Point a = point(i);
    const Point e = point(j) - a;
    const Point f = point(k) - a;
    const Point p = cross(along, f);
    const float determinant = dot(e, p);
    if (determinant == 0) continue;
    const Point s = from - a;
    const float u = dot(s, p) / determinant;
    const Point q = cross(s, e);
    const float v = dot(along, q) / determinant;
    if (u < 0 || v < 0 || u + v > 1) continue;
    const float distance = dot(f, q) / determinant;
    if (!(distance > 0) || distance >= nearest) continue;
    nearest = distance;
    hit = {from.x + distance * along.x, from.y + distance * along.y, from.z + distance * along.z};
  }
  return give(std::span<const float>(hit).first(nearest < std::numeric_limits<float>::max() ? 3 : 0));
}
/// The last operation: kind, closed, k, a of the patch before, four masks as two numbers each, strips, isolated.
RESTRIP_EXPORT(const List*, restrip_last)(const Page* page) {
  static std::array<std::uint32_t, 14> words;
  const LastOperation& last = page->session->last();
  const auto high = [](Word w) { return word(w >> 32); };
  const bool closed = last.before.closed && last.after.closed;
  words = {word(last.kind),         closed ? 1U : 0U,        last.before.k,           last.before.a,
           word(last.before.edges), high(last.before.edges), word(last.before.ports), high(last.before.ports),
           word(last.after.edges),  high(last.after.edges),  word(last.after.ports),  high(last.after.ports),
           word(last.strips),       word(last.isolated)};
  return give(std::span<const std::uint32_t>(words));
}
RESTRIP_EXPORT(const List*, restrip_last_triangles)(const Page* page, std::uint32_t after) {
  const LastOperation& last = page->session->last();
  return give(std::span<const Corners>(after != 0 ? last.triangles_after : last.triangles_before));
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
