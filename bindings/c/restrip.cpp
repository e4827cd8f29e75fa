// The C interface (include/restrip.h is its manual), over the library.
#include "restrip.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "restrip/restrip.hpp"
#include "table.hpp"

namespace restrip::c {

inline std::vector<restrip_range> ranges_of(std::span<const IndexRange> ranges) {
  std::vector<restrip_range> made;
  made.reserve(ranges.size());
  for (const IndexRange& range : ranges) made.push_back({range.first, range.count});
  return made;
}

}  // namespace restrip::c

struct restrip_buffer {
  explicit restrip_buffer(restrip::IndexBuffer made) : buffer(std::move(made)) {
    if (buffer.form != restrip::StripForm::lengths) {
      draws = restrip::c::ranges_of(buffer.batches);
      return;
    }
    std::size_t first = 0;
    for (const std::uint32_t length : buffer.lengths) {
      draws.push_back({first, length});
      first += length;
    }
  }
  const restrip::IndexBuffer buffer;
  std::vector<restrip_range> draws;
};

struct restrip_mesh {
  explicit restrip_mesh(restrip::LiveMesh made) : live(std::move(made)) { read_draws(); }
  [[nodiscard]] const restrip::StripMesh& mesh() const noexcept { return live.mesh(); }
  /// After each change of the buffer, so that readers change nothing.
  void read_draws() {
    std::vector<restrip::IndexRange> runs;
    live.buffer().draws(runs);
    draws = restrip::c::ranges_of(runs);
  }

  restrip::LiveMesh live;
  // What functions return until they are called again.
  std::vector<restrip_range> ranges;
  std::vector<restrip_range> draws;
  std::vector<std::byte> saved;
};

namespace {

using namespace restrip;

// ---- codes, texts and arguments

/// The codes of the refusals, which never change, in the order of Refusal up to same_vertex.
constexpr std::array<restrip_status, 17> codes{
    RESTRIP_OK,
    RESTRIP_NO_SUCH_EDGE,
    RESTRIP_DIFFERENT_VERTICES,
    RESTRIP_SAME_SPOKE,
    RESTRIP_NON_MANIFOLD_VERTEX,
    RESTRIP_BOUNDARY_EDGE,
    RESTRIP_SPOKE_ON_BOUNDARY,
    RESTRIP_JOINS_BOUNDARIES,
    RESTRIP_LINK_CONDITION,
    RESTRIP_TOO_FEW_TRIANGLES,
    RESTRIP_DANGLING_EDGE,
    RESTRIP_EDGE_EXISTS,
    RESTRIP_VERTEX_IN_USE,
    RESTRIP_VERTEX_TOO_FAR,
    RESTRIP_NO_MANIFOLD,
    RESTRIP_OTHER_PATCH,
    RESTRIP_SAME_VERTEX,
};
static_assert(codes.size() == static_cast<std::size_t>(Refusal::same_vertex) + 1);

constexpr restrip_status status_of(Refusal refusal) noexcept {
  if (refusal == Refusal::colors_not_valid) return RESTRIP_BAD_COLORING;
  const auto place = static_cast<std::size_t>(refusal);
  return place < codes.size() ? codes[place] : RESTRIP_UNEXPECTED;
}

/// Writes a text for the caller, cut off to `size` with its end.
void tell(std::string_view what, char* text, std::size_t size) noexcept {
  if (size != 0) text[what.copy(text, size - 1)] = '\0';
}

/// The result of work(), RESTRIP_OK if it has none, or the code of the exception that ends it; `text` receives the
/// sentence about bytes that were refused. Without exceptions RESTRIP_THROW does not return.
template <class Work>
restrip_status guarded(Work&& work, [[maybe_unused]] char* text = nullptr,
                       [[maybe_unused]] std::size_t text_size = 0) noexcept {
  const auto done = [&]() -> restrip_status {
    if constexpr (std::is_void_v<decltype(work())>) {
      work();
      return RESTRIP_OK;
    } else {
      return work();
    }
  };
#ifdef __cpp_exceptions
  try {
    return done();
  } catch (const std::invalid_argument& error) {
    constexpr std::string_view prefix = "restrip: ";
    const std::string_view what = error.what();
    tell(what.starts_with(prefix) ? what.substr(prefix.size()) : what, text, text_size);
    return RESTRIP_BAD_FILE;
  } catch (const std::bad_alloc&) {
    return RESTRIP_OUT_OF_MEMORY;
  } catch (const std::length_error&) {
    return RESTRIP_TOO_LARGE;
  } catch (...) {
    return RESTRIP_UNEXPECTED;
  }
#else
  return done();
#endif
}

bool any_null(std::initializer_list<const void*> pointers) noexcept {
  return std::find(pointers.begin(), pointers.end(), nullptr) != pointers.end();
}

/// The same for a function that needs these pointers.
template <class Work>
restrip_status given(std::initializer_list<const void*> pointers, Work&& work) noexcept {
  if (any_null(pointers)) return RESTRIP_NULL_ARGUMENT;
  return guarded(work);
}

/// The number given, as a member of an enumeration of the library, 0 to `last`.
template <class Enum>
bool named(std::int32_t number, Enum last, Enum& out) noexcept {
  if (number < 0 || number > static_cast<std::int32_t>(last)) return false;
  out = static_cast<Enum>(number);
  return true;
}

/// False when a weight is out of range.
bool cost_of(const restrip_cost* given, Cost& out) noexcept {
  constexpr std::uint16_t most = 1000;
  if (given == nullptr) {
    out = default_cost;
    return true;
  }
  out = {given->restart, given->swap, given->isolated};
  return out.restart >= 1 && out.restart <= most && out.swap <= most && out.isolated <= most;
}

/// False when the weight is out of range.
bool cache_of(const restrip_cache* given, VertexCache& out) noexcept {
  if (given != nullptr) out = {given->size, given->weight};
  return out.weight >= 0 && out.weight <= 1000;
}

// ---- meshes

/// No mesh without boundary has more vertices than triangles.
constexpr std::size_t most_vertices = StripMesh::max_triangles;

restrip_build_report report_of(const BuildReport& found) noexcept {
  return {found.degenerate_triangles, found.out_of_range_triangles, found.boundary_edges,
          found.non_manifold_edges,   found.inconsistent_edges,     found.non_manifold_vertices};
}

template <class Index>
restrip_status build(const Index* indices, std::size_t index_count, std::size_t vertex_count,
                     restrip_build_report* report, std::uint32_t* origin, restrip_mesh** out) {
  if (out != nullptr) *out = nullptr;
  if (out == nullptr || (indices == nullptr && index_count != 0)) return RESTRIP_NULL_ARGUMENT;
  if (index_count % 3 != 0) return RESTRIP_BAD_ARGUMENT;
  if (vertex_count > most_vertices) return RESTRIP_TOO_LARGE;  // before memory is asked for
  return guarded([&] {
    BuildReport found;
    std::vector<std::uint32_t> places;
    *out = new restrip_mesh(LiveMesh(StripMesh::build(std::span<const Index>(indices, index_count), vertex_count,
                                                      &found, origin != nullptr ? &places : nullptr),
                                     {.format = {}, .deferred = true}));
    if (report != nullptr) *report = report_of(found);
    std::copy(places.begin(), places.end(), origin);
  });
}

// ---- buffers

bool format_of(const restrip_format* format, StripFormat& out) noexcept {
  if (format == nullptr) return true;
  const auto limit_is = [](std::size_t limit, std::size_t least) { return limit == 0 || limit >= least; };
  if (!named(format->form, StripForm::list, out.form)) return false;
  if (format->index_bits != 0 && format->index_bits != 16 && format->index_bits != 32) return false;
  if (!limit_is(format->most_vertices, 3) || !limit_is(format->most_indices, 4)) return false;
  out.width = format->index_bits == 0    ? IndexWidth::automatic
              : format->index_bits == 16 ? IndexWidth::bits16
                                         : IndexWidth::bits32;
  out.list_if_shorter = format->keep_strips == 0;
  out.most_vertices = format->most_vertices;
  out.most_indices = format->most_indices;
  return true;
}

/// strips_of() with time and memory that do not depend on the vertex numbers: they are renumbered without gaps.
template <class Index>
IndexBuffer strips_of_sparse(std::span<const Index> list, std::size_t vertex_count, const StripFormat& format,
                             Effort effort, const Cost& cost, const VertexCache& cache) {
  std::vector<std::uint32_t> used(list.begin(), list.end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  const auto place_of = [&used](std::size_t v) {
    return static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), v) - used.begin());
  };
  std::vector<std::uint32_t> places(list.size());
  std::transform(list.begin(), list.end(), places.begin(), place_of);
  const IndexBuffer strips = strips_of(places, place_of(vertex_count),
                                       {.width = IndexWidth::bits32, .list_if_shorter = false}, effort, cost, cache);
  std::vector<std::uint32_t> indices = std::get<0>(strips.indices);
  for (std::uint32_t& index : indices)
    if (index != restart_index) index = used[index];
  return format_strips(indices, format);
}

template <class Index>
restrip_status strips_of_list(const Index* indices, std::size_t index_count, std::size_t vertex_count,
                              std::int32_t effort, const restrip_cost* cost, const restrip_cache* cache,
                              const restrip_format* format, restrip_buffer** out) {
  if (out != nullptr) *out = nullptr;
  if (out == nullptr || (indices == nullptr && index_count != 0)) return RESTRIP_NULL_ARGUMENT;
  Effort how{};
  Cost what;
  VertexCache target;
  StripFormat wanted;
  if (index_count % 3 != 0 || !named(effort, Effort::best, how) || !format_of(format, wanted) || !cost_of(cost, what) ||
      !cache_of(cache, target))
    return RESTRIP_BAD_ARGUMENT;
  if (vertex_count > RESTRIP_NONE) return RESTRIP_TOO_LARGE;
  return guarded([&] {
    const std::span list(indices, index_count);
    const bool sparse = vertex_count > index_count && vertex_count - index_count > StripMesh::max_vertex_gap;
    *out = new restrip_buffer(sparse ? strips_of_sparse(list, vertex_count, wanted, how, what, target)
                                     : strips_of(list, vertex_count, wanted, how, what, target));
  });
}

restrip_record record_of(const SplitRecord& split) noexcept { return {split.v_s, split.v_t, split.v_l, split.v_r}; }

/// Reads a mesh from bytes, or describes what is wrong with them in `text`.
template <class Read>
restrip_status read_bytes(const void* bytes, std::size_t size, char* text, std::size_t text_size, restrip_mesh** out,
                          Read&& read) {
  if (out != nullptr) *out = nullptr;
  if (out == nullptr || (bytes == nullptr && size != 0) || (text == nullptr && text_size != 0))
    return RESTRIP_NULL_ARGUMENT;
  tell({}, text, text_size);
  return guarded([&] { return read(std::span(static_cast<const std::byte*>(bytes), size)); }, text, text_size);
}

/// Whether h is a halfedge of the mesh.
bool known(const restrip_mesh* mesh, restrip_halfedge h) noexcept {
  return mesh != nullptr && mesh->mesh().alive(Halfedge{h});
}

// ---- operations

VertexSplit where_of(restrip_halfedge left, restrip_halfedge right) noexcept {
  using Spokes = VertexSplit::Spokes;
  const Spokes spokes = right == RESTRIP_NONE  ? Spokes::left_only
                        : left == RESTRIP_NONE ? Spokes::right_only
                                               : Spokes::both;
  return {{left}, {right}, spokes};
}

/// The status of an operation that adds the vertex v_t, by default the next one: too large if indices of the live
/// buffer always have 16 bits and cannot name it.
restrip_status indexable(const restrip_mesh& mesh, Refusal refusal, Vertex v_t = none) noexcept {
  if (refusal != Refusal::granted) return status_of(refusal);
  if (mesh.live.buffer().format().width != IndexWidth::bits16) return RESTRIP_OK;
  return (v_t == none ? mesh.mesh().next_vertex() : v_t) > highest_index16 ? RESTRIP_TOO_LARGE : RESTRIP_OK;
}

/// Reports what became of an operation.
restrip_status reported(const Checked& done, restrip_change* change) noexcept {
  if (!done) return status_of(done.refusal);
  const auto& rewrite = done.rewrite;
  if (change != nullptr) *change = {rewrite.halfedge.id, rewrite.valence, rewrite.strips, rewrite.isolated};
  return RESTRIP_OK;
}

/// The operations that take one halfedge, in the order of their numbers.
struct AtHalfedge {
  Refusal (*check)(const StripMesh&, Halfedge);
  Checked (LiveMesh::*apply)(Halfedge);
  bool adds_vertex;
};
template <OperationPlace (*at)(const StripMesh&, Halfedge)>
Refusal check_at(const StripMesh& mesh, Halfedge h) {
  return check_apply(mesh, at(mesh, h));
}
constexpr std::array<AtHalfedge, 6> at_halfedge{{
    {check_collapse, &LiveMesh::collapse, false},
    {check_flip, &LiveMesh::flip, false},
    {check_at<split_face_at>, &LiveMesh::split_face, true},
    {check_at<join_faces_at>, &LiveMesh::join_faces, false},
    {check_at<bisect_at>, &LiveMesh::bisect, true},
    {check_at<merge_at>, &LiveMesh::merge, false},
}};

restrip_status check(const restrip_mesh* mesh, std::int32_t operation, restrip_halfedge h) noexcept {
  if (mesh == nullptr) return RESTRIP_NULL_ARGUMENT;
  const AtHalfedge& row = at_halfedge[static_cast<std::size_t>(operation)];
  return guarded([&] {  // checks allocate around vertices of large valence
    const Refusal refusal = row.check(mesh->mesh(), {h});
    return row.adds_vertex ? indexable(*mesh, refusal) : status_of(refusal);
  });
}
restrip_status apply(restrip_mesh* mesh, std::int32_t operation, restrip_halfedge h, restrip_change* change) noexcept {
  if (mesh == nullptr) return RESTRIP_NULL_ARGUMENT;
  const AtHalfedge& row = at_halfedge[static_cast<std::size_t>(operation)];
  return guarded([&] {
    if (row.adds_vertex)  // the mesh may not grow, so the reason of the refusal matters
      if (const restrip_status status = indexable(*mesh, Refusal::granted); status != RESTRIP_OK) {
        const Refusal refusal = row.check(mesh->mesh(), {h});
        return refusal == Refusal::granted ? status : status_of(refusal);
      }
    const Vertex from = restrip_mesh_from(mesh, h);
    Checked done = (mesh->live.*row.apply)({h});
    if (done && row.adds_vertex) done.rewrite.halfedge = mesh->mesh().spoke(from, done.new_vertex());
    return reported(done, change);
  });
}

/// What is wrong with the arguments of a function that does an operation at each of n halfedges.
restrip_status each_fault(const restrip_mesh* mesh, std::int32_t operation, std::size_t n,
                          const restrip_halfedge* halfedges, const restrip_status* statuses) noexcept {
  if (mesh == nullptr || (n != 0 && any_null({halfedges, statuses}))) return RESTRIP_NULL_ARGUMENT;
  const bool known = 0 <= operation && static_cast<std::size_t>(operation) < at_halfedge.size();
  return known ? RESTRIP_OK : RESTRIP_BAD_ARGUMENT;
}

// ---- the live buffer

/// If memory runs out before the caller has the ranges of an update, the next one returns them as well.
struct Undelivered {
  LiveMesh* live;
  explicit Undelivered(LiveMesh* from) noexcept : live(from) {}
  Undelivered(const Undelivered&) = delete;
  Undelivered& operator=(const Undelivered&) = delete;
  ~Undelivered() {
    if (live != nullptr) live->keep_upload();
  }
};

restrip_status step(restrip_mesh* mesh, bool (LiveMesh::*way)(), std::int32_t* done) noexcept {
  return given({mesh, done}, [&] {
    *done = (mesh->live.*way)() ? 1 : 0;
    mesh->read_draws();
  });
}

// ---- rules

/// Whether the rule has this position.
constexpr bool has_position(std::int32_t rule, std::uint32_t k, std::uint32_t i, std::uint32_t j) noexcept {
  if (rule == RESTRIP_RULE_FLIP) return true;
  if (rule < RESTRIP_RULE_SPLIT || rule > RESTRIP_RULE_FLIP || k > RESTRIP_LARGEST_FAN) return false;
  if (rule <= RESTRIP_RULE_COLLAPSE) return 3 <= k && 1 <= i && i < k;
  return 1 <= k && i <= k && (rule >= RESTRIP_RULE_BOUNDARY_SPLIT || (i < j && j <= k));
}
Rule rule_of(std::int32_t rule, std::uint32_t k, std::uint32_t i, std::uint32_t j, Word colors, Word ports) noexcept {
  switch (rule) {
    case RESTRIP_RULE_SPLIT:
      return split_rule({k, i}, colors, ports);
    case RESTRIP_RULE_COLLAPSE:
      return collapse_rule({k, i}, colors, ports);
    case RESTRIP_RULE_OPEN_SPLIT:
      return open_split_rule({k, i, j}, colors, ports);
    case RESTRIP_RULE_OPEN_COLLAPSE:
      return open_collapse_rule({k, i, j}, colors, ports);
    case RESTRIP_RULE_BOUNDARY_SPLIT:
      return boundary_split_rule({k, i}, colors, ports);
    default:
      return boundary_collapse_rule({k, i}, colors, ports);
  }
}

static_assert(RESTRIP_LARGEST_FAN == max_word_valence);
static_assert(RESTRIP_NONE == none);
static_assert(RESTRIP_MOST_NEW_VERTICES == NewVertices::most);
static_assert(RESTRIP_POLICY_BAKED >= policies.size());

}  // namespace

// ---- version and errors

std::uint32_t restrip_abi_version() { return RESTRIP_ABI_VERSION; }
const char* restrip_version() { return RESTRIP_VERSION; }
const char* restrip_describe(restrip_status status) {
  // Refusals have the texts of the library.
  for (std::size_t place = 0; place < codes.size(); ++place)
    if (codes[place] == status) return describe(static_cast<Refusal>(place));
  constexpr std::pair<restrip_status, const char*> texts[] = {
      {RESTRIP_NULL_ARGUMENT, "a pointer that must not be null is null"},
      {RESTRIP_BAD_ARGUMENT, "an argument is outside its range or not supported here: see the function's comment"},
      {RESTRIP_BAD_COLORING, "the colours are not a valid colouring"},
      {RESTRIP_TOO_LARGE, "there are more triangles or vertices than a mesh or its indices can hold"},
      {RESTRIP_TOO_SMALL, "the array is too short for the result"},
      {RESTRIP_BAD_FILE, "the bytes are not a mesh that was saved or baked, or are damaged"},
      {RESTRIP_NOT_BAKED, "the mesh was not read from a baked mesh"},
      {RESTRIP_OUT_OF_STEP, "the mesh has left its baked levels: restart it"},
      {RESTRIP_OUT_OF_MEMORY, "there is not enough memory"},
      {RESTRIP_UNEXPECTED, "an error in restrip"},
  };
  for (const auto& [code, text] : texts)
    if (code == status) return text;
  return "this is not a code of restrip";
}

// ---- meshes

restrip_status restrip_mesh_build_u32(const std::uint32_t* indices, std::size_t index_count, std::size_t vertex_count,
                                      restrip_build_report* report, std::uint32_t* origin, restrip_mesh** mesh) {
  return build(indices, index_count, vertex_count, report, origin, mesh);
}
restrip_status restrip_mesh_build_u16(const std::uint16_t* indices, std::size_t index_count, std::size_t vertex_count,
                                      restrip_build_report* report, std::uint32_t* origin, restrip_mesh** mesh) {
  return build(indices, index_count, vertex_count, report, origin, mesh);
}
restrip_status restrip_mesh_copy(const restrip_mesh* mesh, restrip_mesh** copy) {
  if (copy != nullptr) *copy = nullptr;
  return given({mesh, copy},
               [&] { *copy = new restrip_mesh(LiveMesh(StripMesh(mesh->mesh()), {.format = {}, .deferred = true})); });
}
restrip_status restrip_mesh_reserve(restrip_mesh* mesh, std::size_t triangles, std::size_t vertices) {
  if (any_null({mesh})) return RESTRIP_NULL_ARGUMENT;
  if (triangles > StripMesh::max_triangles || vertices > most_vertices) return RESTRIP_TOO_LARGE;
  return guarded([&] { mesh->live.reserve(triangles, vertices); });
}
void restrip_mesh_free(restrip_mesh* mesh) { delete mesh; }

std::size_t restrip_mesh_triangle_count(const restrip_mesh* mesh) {
  return mesh == nullptr ? 0 : mesh->mesh().triangle_count();
}
std::size_t restrip_mesh_triangle_bound(const restrip_mesh* mesh) {
  return mesh == nullptr ? 0 : mesh->mesh().triangle_bound();
}
std::size_t restrip_mesh_vertex_bound(const restrip_mesh* mesh) {
  return mesh == nullptr ? 0 : mesh->mesh().vertex_bound();
}
restrip_status restrip_mesh_corners(const restrip_mesh* mesh, std::uint32_t t, std::uint32_t corners[3]) {
  if (any_null({mesh, corners})) return RESTRIP_NULL_ARGUMENT;
  if (!mesh->mesh().alive(t)) return RESTRIP_BAD_ARGUMENT;
  const auto found = mesh->mesh().corners(t);
  std::copy(found.begin(), found.end(), corners);
  return RESTRIP_OK;
}
restrip_status restrip_mesh_triangles(const restrip_mesh* mesh, std::uint32_t* corners, std::size_t size) {
  if (any_null({mesh, corners})) return RESTRIP_NULL_ARGUMENT;
  if (size < 3 * mesh->mesh().triangle_count()) return RESTRIP_TOO_SMALL;
  for (Triangle t = 0; t < mesh->mesh().triangle_bound(); ++t)
    if (mesh->mesh().alive(t))
      for (const Vertex v : mesh->mesh().corners(t)) *corners++ = v;
  return RESTRIP_OK;
}

// ---- halfedges

restrip_halfedge restrip_mesh_find(const restrip_mesh* mesh, std::uint32_t v, std::uint32_t w) {
  const restrip_halfedge first = restrip_mesh_spoke(mesh, v);
  return first == RESTRIP_NONE ? RESTRIP_NONE : mesh->mesh().spoke(v, w).id;
}
restrip_status restrip_mesh_find_each(const restrip_mesh* mesh, std::size_t n, const std::uint32_t* v,
                                      const std::uint32_t* w, restrip_halfedge* found) {
  if (mesh == nullptr || (n != 0 && any_null({v, w, found}))) return RESTRIP_NULL_ARGUMENT;
  for (std::size_t i = 0; i < n; ++i) found[i] = restrip_mesh_find(mesh, v[i], w[i]);
  return RESTRIP_OK;
}
restrip_halfedge restrip_mesh_spoke(const restrip_mesh* mesh, std::uint32_t v) {
  return mesh == nullptr || v >= mesh->mesh().vertex_bound() ? RESTRIP_NONE : mesh->mesh().spoke(v).id;
}
restrip_halfedge restrip_mesh_next(const restrip_mesh* mesh, restrip_halfedge h) {
  return known(mesh, h) && !StripMesh::on_boundary({h}) ? StripMesh::next({h}).id : RESTRIP_NONE;
}
restrip_halfedge restrip_mesh_opposite(const restrip_mesh* mesh, restrip_halfedge h) {
  return known(mesh, h) ? mesh->mesh().opposite({h}).id : RESTRIP_NONE;
}
std::uint32_t restrip_mesh_from(const restrip_mesh* mesh, restrip_halfedge h) {
  return known(mesh, h) ? mesh->mesh().from({h}) : RESTRIP_NONE;
}
std::uint32_t restrip_mesh_to(const restrip_mesh* mesh, restrip_halfedge h) {
  return known(mesh, h) ? mesh->mesh().to({h}) : RESTRIP_NONE;
}
std::uint32_t restrip_mesh_triangle(const restrip_mesh* mesh, restrip_halfedge h) {
  return known(mesh, h) && !StripMesh::on_boundary({h}) ? StripMesh::triangle({h}) : RESTRIP_NONE;
}
int restrip_mesh_solid(const restrip_mesh* mesh, restrip_halfedge h) {
  return known(mesh, h) && mesh->mesh().solid({h}) ? 1 : 0;
}

// ---- colours

restrip_status restrip_mesh_get_colors(const restrip_mesh* mesh, std::uint8_t* solid_sides, std::size_t size) {
  if (any_null({mesh, solid_sides})) return RESTRIP_NULL_ARGUMENT;
  if (size < mesh->mesh().triangle_bound()) return RESTRIP_TOO_SMALL;
  for (Triangle t = 0; t < mesh->mesh().triangle_bound(); ++t)
    solid_sides[t] = mesh->mesh().alive(t) ? static_cast<std::uint8_t>(mesh->mesh().solid_sides(t)) : std::uint8_t{0};
  return RESTRIP_OK;
}
restrip_status restrip_mesh_set_colors(restrip_mesh* mesh, const std::uint8_t* solid_sides, std::size_t size) {
  if (any_null({mesh, solid_sides})) return RESTRIP_NULL_ARGUMENT;
  if (size != mesh->mesh().triangle_bound()) return RESTRIP_BAD_ARGUMENT;
  return guarded([&] { return mesh->live.recolor({solid_sides, size}) ? RESTRIP_OK : RESTRIP_BAD_COLORING; });
}
restrip_status restrip_mesh_check(const restrip_mesh* mesh, restrip_coloring* coloring) {
  return given({mesh, coloring}, [&] {
    const ColoringReport report = check_coloring(mesh->mesh());
    *coloring = {report.triangles, report.strips, report.isolated, report.valid ? 1 : 0};
  });
}
restrip_status restrip_mesh_strip_count(const restrip_mesh* mesh, std::size_t* strips) {
  return given({mesh, strips}, [&] {
    const LiveMesh& live = mesh->live;
    *strips = live.level() || live.keeper().up_to_date() ? live.strips() : count_strips(live.mesh());
  });
}
restrip_status restrip_mesh_stripify(restrip_mesh* mesh, std::int32_t effort, const restrip_cost* cost,
                                     std::uint64_t limit, std::size_t* strips) {
  return restrip_mesh_stripify_until(mesh, effort, cost, limit, nullptr, nullptr, strips);
}
restrip_status restrip_mesh_stripify_until(restrip_mesh* mesh, std::int32_t effort, const restrip_cost* cost,
                                           std::uint64_t limit, std::int32_t (*stop)(void* context), void* context,
                                           std::size_t* strips) {
  if (any_null({mesh})) return RESTRIP_NULL_ARGUMENT;
  Effort how{};
  Cost what;
  if (!named(effort, Effort::best, how) || !cost_of(cost, what)) return RESTRIP_BAD_ARGUMENT;
  std::pair asked(stop, context);
  const auto ask = [](void* given) {
    const auto& [answer, of_user] = *static_cast<decltype(asked)*>(given);
    return answer(of_user) != 0;
  };
  const Interrupt interrupt{stop == nullptr ? nullptr : +ask, &asked};
  return guarded([&] {
    const std::size_t made = mesh->live.recolor(how, what, limit, &interrupt);
    if (strips != nullptr) *strips = made;
  });
}

// ---- operations

restrip_status restrip_mesh_keep(restrip_mesh* mesh, std::int32_t policy, const restrip_cost* cost) {
  if (any_null({mesh})) return RESTRIP_NULL_ARGUMENT;
  Policy how{};
  Cost what;
  if (!named(policy, static_cast<Policy>(policies.size() - 1), how) || !cost_of(cost, what))
    return RESTRIP_BAD_ARGUMENT;
  return guarded([&] { mesh->live.keep(how, what); });
}
std::int32_t restrip_mesh_policy(const restrip_mesh* mesh) {
  if (mesh == nullptr) return RESTRIP_POLICY_BARE;
  const LiveMesh& live = mesh->live;
  return live.level() ? RESTRIP_POLICY_BAKED : static_cast<std::int32_t>(live.keeper().policy());
}

restrip_status restrip_mesh_split(restrip_mesh* mesh, restrip_halfedge left, restrip_halfedge right, std::uint32_t v_t,
                                  restrip_change* change) {
  if (any_null({mesh})) return RESTRIP_NULL_ARGUMENT;
  if (const restrip_status status = indexable(*mesh, Refusal::granted, v_t); status != RESTRIP_OK) return status;
  return guarded([&] { return reported(mesh->live.split(where_of(left, right), v_t), change); });
}
restrip_status restrip_mesh_collapse(restrip_mesh* mesh, restrip_halfedge h, restrip_change* change) {
  return apply(mesh, RESTRIP_COLLAPSE, h, change);
}
restrip_status restrip_mesh_flip(restrip_mesh* mesh, restrip_halfedge h, restrip_change* change) {
  return apply(mesh, RESTRIP_FLIP, h, change);
}
restrip_status restrip_mesh_split_at(restrip_mesh* mesh, std::uint32_t v, std::uint32_t left, std::uint32_t right,
                                     std::uint32_t v_t, restrip_change* change) {
  if (any_null({mesh})) return RESTRIP_NULL_ARGUMENT;
  if (const restrip_status status = indexable(*mesh, Refusal::granted, v_t); status != RESTRIP_OK) return status;
  return guarded([&] { return reported(mesh->live.split(v, left, right, v_t), change); });
}
restrip_status restrip_mesh_collapse_at(restrip_mesh* mesh, std::uint32_t v, std::uint32_t w, restrip_change* change) {
  return restrip_mesh_collapse(mesh, restrip_mesh_find(mesh, v, w), change);
}
restrip_status restrip_mesh_flip_at(restrip_mesh* mesh, std::uint32_t v, std::uint32_t w, restrip_change* change) {
  return restrip_mesh_flip(mesh, restrip_mesh_find(mesh, v, w), change);
}
restrip_status restrip_mesh_replace(restrip_mesh* mesh, const std::uint32_t* out, std::size_t out_count,
                                    const std::uint32_t* in, std::size_t in_count, restrip_change* change) {
  if (mesh == nullptr || (out == nullptr && out_count != 0) || (in == nullptr && in_count != 0))
    return RESTRIP_NULL_ARGUMENT;
  if (in_count > StripMesh::max_triangles) return RESTRIP_TOO_LARGE;
  return guarded([&]() -> restrip_status {
    std::vector<std::array<Vertex, 3>> corners(in_count);
    Vertex highest = 0;
    for (std::size_t i = 0; i < 3 * in_count; ++i) highest = (std::max)(highest, corners[i / 3][i % 3] = in[i]);
    const std::span removed(out, out_count);
    if (mesh->live.buffer().format().width == IndexWidth::bits16 && highest > highest_index16) {
      const Refusal refusal = check_replace(mesh->mesh(), removed, corners);
      return refusal == Refusal::granted ? RESTRIP_TOO_LARGE : status_of(refusal);
    }
    return reported(mesh->live.replace(removed, corners), change);
  });
}
restrip_status restrip_mesh_split_face(restrip_mesh* mesh, restrip_halfedge h, restrip_change* change) {
  return apply(mesh, RESTRIP_SPLIT_FACE, h, change);
}
restrip_status restrip_mesh_join_faces(restrip_mesh* mesh, restrip_halfedge h, restrip_change* change) {
  return apply(mesh, RESTRIP_JOIN_FACES, h, change);
}
restrip_status restrip_mesh_bisect(restrip_mesh* mesh, restrip_halfedge h, restrip_change* change) {
  return apply(mesh, RESTRIP_BISECT, h, change);
}
restrip_status restrip_mesh_merge(restrip_mesh* mesh, restrip_halfedge h, restrip_change* change) {
  return apply(mesh, RESTRIP_MERGE, h, change);
}
restrip_status restrip_table_make(const restrip_operation* operation, char* text, std::size_t text_size,
                                  restrip_table** table) {
  if (table != nullptr) *table = nullptr;
  if (any_null({operation, table}) || (text == nullptr && text_size != 0) ||
      any_null({operation->before, operation->after, operation->entries}))
    return RESTRIP_NULL_ARGUMENT;
  tell({}, text, text_size);
  return guarded([&]() -> restrip_status {
    const std::string fault = restrip::c::fault_of(*operation);
    tell(fault, text, text_size);
    if (!fault.empty()) return RESTRIP_BAD_ARGUMENT;
    auto made = std::make_unique<restrip_table>();
    std::vector<bool> old(operation->vertices);
    for (const auto& [from, count, to] : {std::tuple(operation->before, operation->before_count, &made->before),
                                          std::tuple(operation->after, operation->after_count, &made->after)})
      for (const restrip_patch_triangle& t : std::span(from, count)) {
        to->push_back(
            {t.from, t.from_side, {t.vertex[0], t.vertex[1], t.vertex[2]}, {t.side[0], t.side[1], t.side[2]}});
        for (const std::uint8_t v : t.vertex) {
          if (!old[v] && to == &made->after) ++made->new_vertices;
          old[v] = true;
        }
      }
    made->entries.assign(operation->entries, operation->entries + operation->entry_count);
    made->view.before = {static_cast<unsigned>(made->before.size()), operation->edges_before};
    made->view.after = {static_cast<unsigned>(made->after.size()), operation->edges_after};
    made->view.ports = operation->ports;
    made->view.vertices = operation->vertices;
    made->view.entry_bytes = sizeof(std::uint32_t);
    made->view.entries = made->entries.data();
    made->view.triangles_before = made->before;
    made->view.triangles_after = made->after;
    *table = made.release();
    return RESTRIP_OK;
  });
}
void restrip_table_free(restrip_table* table) { delete table; }
restrip_status restrip_mesh_apply(restrip_mesh* mesh, const restrip_table* table, restrip_halfedge h,
                                  restrip_change* change, std::uint32_t* added, std::size_t* added_count) {
  if (any_null({mesh, table}) || (added == nullptr) != (added_count == nullptr)) return RESTRIP_NULL_ARGUMENT;
  return guarded([&]() -> restrip_status {
    if (table->new_vertices != 0) {
      const auto highest = static_cast<Vertex>(mesh->mesh().vertex_bound() + table->new_vertices - 1);
      const Vertex v = table->new_vertices == 1 ? mesh->mesh().next_vertex() : highest;
      const Refusal refusal = check_apply(mesh->mesh(), table->view, {h});
      if (const restrip_status status = indexable(*mesh, refusal, v); status != RESTRIP_OK) return status;
    }
    const Checked done = mesh->live.apply(table->view, {h});
    if (done && added != nullptr) {
      std::copy(done.new_vertices.begin(), done.new_vertices.end(), added);
      *added_count = done.new_vertices.size();
    }
    return reported(done, change);
  });
}
restrip_status restrip_mesh_apply_each(restrip_mesh* mesh, std::int32_t operation, std::size_t n,
                                       const restrip_halfedge* halfedges, restrip_status* statuses,
                                       restrip_change* changes) {
  const restrip_status fault = each_fault(mesh, operation, n, halfedges, statuses);
  for (std::size_t i = 0; fault == RESTRIP_OK && i < n; ++i)
    statuses[i] = apply(mesh, operation, halfedges[i], changes == nullptr ? nullptr : changes + i);
  return fault;
}
restrip_status restrip_mesh_check_each(const restrip_mesh* mesh, std::int32_t operation, std::size_t n,
                                       const restrip_halfedge* halfedges, restrip_status* statuses) {
  const restrip_status fault = each_fault(mesh, operation, n, halfedges, statuses);
  for (std::size_t i = 0; fault == RESTRIP_OK && i < n; ++i) statuses[i] = check(mesh, operation, halfedges[i]);
  return fault;
}
restrip_status restrip_mesh_check_split(const restrip_mesh* mesh, restrip_halfedge left, restrip_halfedge right,
                                        std::uint32_t v_t) {
  if (any_null({mesh})) return RESTRIP_NULL_ARGUMENT;
  return indexable(*mesh, check_split(mesh->mesh(), where_of(left, right), v_t), v_t);
}

restrip_status restrip_mesh_play(restrip_mesh* mesh, const restrip_record* records, std::size_t n, std::int32_t forward,
                                 std::size_t* done) {
  if (done != nullptr) *done = 0;
  if (any_null({mesh}) || (n != 0 && records == nullptr)) return RESTRIP_NULL_ARGUMENT;
  const auto spoke = [mesh](std::uint32_t v, std::uint32_t w, bool& missing) {
    const restrip_halfedge h = w == RESTRIP_NONE ? RESTRIP_NONE : restrip_mesh_find(mesh, v, w);
    missing = missing || (h == RESTRIP_NONE && w != RESTRIP_NONE);
    return h;
  };
  for (std::size_t i = 0; i < n; ++i) {
    const restrip_record& r = records[forward != 0 ? i : n - 1 - i];
    bool missing = false;
    const restrip_halfedge left = spoke(r.v_s, forward != 0 ? r.v_l : r.v_t, missing);
    const restrip_halfedge right = spoke(r.v_s, forward != 0 ? r.v_r : RESTRIP_NONE, missing);
    // First, as records that are played already usually have no such edges either.
    const bool in_use = forward != 0 && restrip_mesh_spoke(mesh, r.v_t) != RESTRIP_NONE;
    const restrip_status status = in_use         ? RESTRIP_VERTEX_IN_USE
                                  : missing      ? RESTRIP_NO_SUCH_EDGE
                                  : forward == 0 ? restrip_mesh_collapse(mesh, left, nullptr)
                                                 : restrip_mesh_split(mesh, left, right, r.v_t, nullptr);
    if (status != RESTRIP_OK) return status;
    if (done != nullptr) *done = i + 1;
  }
  return RESTRIP_OK;
}

restrip_status restrip_mesh_improve(restrip_mesh* mesh, std::size_t budget, std::size_t* saved) {
  if (any_null({mesh})) return RESTRIP_NULL_ARGUMENT;
  if (mesh->live.level()) return RESTRIP_BAD_ARGUMENT;
  return guarded([&] {
    const std::size_t less = mesh->live.improve(budget);
    if (saved != nullptr) *saved = less;
  });
}

// ---- strips and index buffers out

restrip_status restrip_mesh_strips(const restrip_mesh* mesh, std::uint32_t* triangles, std::size_t triangles_size,
                                   std::size_t* starts, std::size_t starts_size) {
  return given({mesh, triangles, starts}, [&] {
    const Strips strips = extract_strips(mesh->mesh());
    if (triangles_size < strips.order.size() || starts_size < strips.start.size()) return RESTRIP_TOO_SMALL;
    std::copy(strips.order.begin(), strips.order.end(), triangles);
    std::copy(strips.start.begin(), strips.start.end(), starts);
    return RESTRIP_OK;
  });
}

// ---- buffers in any form

restrip_status restrip_strips_of_u32(const std::uint32_t* indices, std::size_t index_count, std::size_t vertex_count,
                                     std::int32_t effort, const restrip_cost* cost, const restrip_cache* cache,
                                     const restrip_format* format, restrip_buffer** buffer) {
  return strips_of_list(indices, index_count, vertex_count, effort, cost, cache, format, buffer);
}
restrip_status restrip_strips_of_u16(const std::uint16_t* indices, std::size_t index_count, std::size_t vertex_count,
                                     std::int32_t effort, const restrip_cost* cost, const restrip_cache* cache,
                                     const restrip_format* format, restrip_buffer** buffer) {
  return strips_of_list(indices, index_count, vertex_count, effort, cost, cache, format, buffer);
}
restrip_status restrip_mesh_buffer(const restrip_mesh* mesh, const restrip_cache* cache, const restrip_format* format,
                                   restrip_buffer** buffer) {
  if (buffer != nullptr) *buffer = nullptr;
  if (any_null({mesh, buffer})) return RESTRIP_NULL_ARGUMENT;
  VertexCache target;
  StripFormat wanted;
  if (!format_of(format, wanted) || !cache_of(cache, target)) return RESTRIP_BAD_ARGUMENT;
  return guarded([&] {
    const auto ordered = [&target](StripMesh own) { return strip_indices(own, strips_for_vertex_cache(own, target)); };
    *buffer = new restrip_buffer(
        format_strips(target.size == 0 ? strip_indices(mesh->mesh()) : ordered(mesh->mesh()), wanted));
    return RESTRIP_OK;
  });
}
restrip_status restrip_buffer_read(const restrip_buffer* buffer, restrip_buffer_view* view) {
  if (any_null({buffer, view})) return RESTRIP_NULL_ARGUMENT;
  const IndexBuffer& made = buffer->buffer;
  *view = {made.bytes().data(),
           made.size(),
           static_cast<std::int32_t>(8 * made.index_bytes()),
           static_cast<std::int32_t>(made.form),
           buffer->draws.data(),
           buffer->draws.size(),
           made.triangles};
  return RESTRIP_OK;
}
void restrip_buffer_free(restrip_buffer* buffer) { delete buffer; }

// ---- the live buffer

restrip_status restrip_live_begin(restrip_mesh* mesh, const restrip_format* format, const restrip_layout* layout,
                                  std::size_t history) {
  if (any_null({mesh})) return RESTRIP_NULL_ARGUMENT;
  StripFormat wanted;
  LayoutOptions how;
  if (layout != nullptr) how = {layout->cache, layout->waste, layout->work};
  if (!format_of(format, wanted) || wanted.most_vertices != 0 || wanted.most_indices != 0 || !how.in_range())
    return RESTRIP_BAD_ARGUMENT;
  return guarded([&] {
    mesh->live.begin_buffer(wanted, how, history);
    mesh->read_draws();
  });
}
restrip_status restrip_live_update(restrip_mesh* mesh, std::size_t merge_gap, std::size_t align,
                                   const restrip_range** ranges, std::size_t* range_count, std::int32_t* outgrown) {
  if (any_null({mesh, ranges, range_count})) return RESTRIP_NULL_ARGUMENT;
  if (align == 0 || (align != 2 && align % 4 != 0)) return RESTRIP_BAD_ARGUMENT;
  return guarded([&] {
    const Upload upload = mesh->live.update({merge_gap, align});
    Undelivered undelivered{&mesh->live};
    mesh->ranges = restrip::c::ranges_of(upload);
    mesh->read_draws();
    undelivered.live = nullptr;
    *ranges = mesh->ranges.data();
    *range_count = mesh->ranges.size();
    if (outgrown != nullptr) *outgrown = upload.outgrown ? 1 : 0;
  });
}
restrip_status restrip_live_buffer(const restrip_mesh* mesh, restrip_buffer_view* view, std::size_t* room) {
  if (any_null({mesh, view})) return RESTRIP_NULL_ARGUMENT;
  const LiveBuffer& buffer = mesh->live.buffer();
  *view = {buffer.bytes().data(),
           buffer.size(),
           static_cast<std::int32_t>(8 * buffer.index_bytes()),
           static_cast<std::int32_t>(buffer.format().form),
           mesh->draws.data(),
           mesh->draws.size(),
           mesh->mesh().triangle_count()};
  if (room != nullptr) *room = buffer.room();
  return RESTRIP_OK;
}
restrip_status restrip_live_undo(restrip_mesh* mesh, std::int32_t* done) { return step(mesh, &LiveMesh::undo, done); }
restrip_status restrip_live_redo(restrip_mesh* mesh, std::int32_t* done) { return step(mesh, &LiveMesh::redo, done); }
restrip_status restrip_live_history_size(const restrip_mesh* mesh, std::size_t* undoable, std::size_t* redoable) {
  if (any_null({mesh, undoable, redoable})) return RESTRIP_NULL_ARGUMENT;
  *undoable = mesh->live.undoable();
  *redoable = mesh->live.redoable();
  return RESTRIP_OK;
}
size_t restrip_live_frame(const restrip_mesh* mesh) { return mesh == nullptr ? 0 : mesh->live.frame(); }

restrip_status restrip_mesh_save(restrip_mesh* mesh, const void** bytes, std::size_t* size) {
  return given({mesh, bytes, size}, [&] {
    mesh->saved = mesh->live.save();
    *bytes = mesh->saved.data();
    *size = mesh->saved.size();
  });
}
restrip_status restrip_mesh_load(const void* bytes, std::size_t size, std::size_t history, char* text,
                                 std::size_t text_size, restrip_mesh** mesh) {
  return read_bytes(bytes, size, text, text_size, mesh, [&](std::span<const std::byte> all) {
    *mesh = new restrip_mesh(LiveMesh::load(all, history));
    return RESTRIP_OK;
  });
}

// ---- baked meshes

restrip_status restrip_baked_read(const void* bytes, std::size_t size, char* text, std::size_t text_size,
                                  restrip_mesh** mesh) {
  return read_bytes(bytes, size, text, text_size, mesh, [&](std::span<const std::byte> all) -> restrip_status {
    auto file = std::make_shared<BakedFile>();
    const std::string fault = read_baked(all, *file);
    tell(fault, text, text_size);
    if (!fault.empty()) return RESTRIP_BAD_FILE;
    *mesh = new restrip_mesh(LiveMesh(std::move(file), {.format = {}, .deferred = true}));
    return RESTRIP_OK;
  });
}
std::size_t restrip_baked_levels(const restrip_mesh* mesh) {
  return mesh == nullptr || mesh->live.baked() == nullptr ? 0 : mesh->live.baked()->splits.size();
}
restrip_status restrip_baked_level(const restrip_mesh* mesh, std::size_t* level) {
  if (any_null({mesh, level})) return RESTRIP_NULL_ARGUMENT;
  if (mesh->live.baked() == nullptr) return RESTRIP_NOT_BAKED;
  if (!mesh->live.level()) return RESTRIP_OUT_OF_STEP;
  *level = *mesh->live.level();
  return RESTRIP_OK;
}
restrip_status restrip_baked_move(restrip_mesh* mesh, std::size_t level, std::size_t most, std::size_t* done) {
  std::size_t now = 0;
  if (const restrip_status status = restrip_baked_level(mesh, &now); status != RESTRIP_OK) return status;
  if (level > mesh->live.baked()->splits.size()) return RESTRIP_BAD_ARGUMENT;
  return guarded([&] {
    const std::size_t played = mesh->live.move_to_level(level, most);
    if (done != nullptr) *done = played;
  });
}
restrip_status restrip_baked_restart(restrip_mesh* mesh) {
  if (any_null({mesh})) return RESTRIP_NULL_ARGUMENT;
  if (mesh->live.baked() == nullptr) return RESTRIP_NOT_BAKED;
  return guarded([&] { mesh->live.restart(); });
}
restrip_status restrip_baked_record(const restrip_mesh* mesh, std::size_t i, restrip_record* record) {
  if (any_null({mesh, record})) return RESTRIP_NULL_ARGUMENT;
  if (mesh->live.baked() == nullptr) return RESTRIP_NOT_BAKED;
  if (i >= restrip_baked_levels(mesh)) return RESTRIP_BAD_ARGUMENT;
  *record = record_of(mesh->live.baked()->splits[i]);
  return RESTRIP_OK;
}
restrip_status restrip_baked_payload(const restrip_mesh* mesh, std::size_t i, const void** bytes, std::size_t* size) {
  if (any_null({mesh, bytes, size})) return RESTRIP_NULL_ARGUMENT;
  if (mesh->live.baked() == nullptr) return RESTRIP_NOT_BAKED;
  if (i >= restrip_baked_levels(mesh)) return RESTRIP_BAD_ARGUMENT;
  const auto payload = mesh->live.baked()->payload[i];
  *bytes = payload.data();
  *size = payload.size();
  return RESTRIP_OK;
}
restrip_status restrip_baked_points(const restrip_mesh* mesh, const float** coordinates, std::size_t* vertex_count) {
  if (any_null({mesh, coordinates, vertex_count})) return RESTRIP_NULL_ARGUMENT;
  if (mesh->live.baked() == nullptr) return RESTRIP_NOT_BAKED;
  const auto& points = mesh->live.baked()->points;
  *coordinates = points.empty() ? nullptr : points.front().data();
  *vertex_count = points.size();
  return RESTRIP_OK;
}

// ---- the rules by themselves

restrip_status restrip_lookup(std::int32_t rule, std::uint32_t k, std::uint32_t i, std::uint32_t j,
                              std::uint64_t colors, std::uint64_t ports, restrip_answer* answer) {
  if (answer == nullptr) return RESTRIP_NULL_ARGUMENT;
  if (!has_position(rule, k, i, j)) return RESTRIP_BAD_ARGUMENT;
  if (rule != RESTRIP_RULE_FLIP) {
    const Rule found = rule_of(rule, k, i, j, colors, ports);
    if (!found.valid) return RESTRIP_BAD_COLORING;
    *answer = {found.colors, ports, found.strips};
    return RESTRIP_OK;
  }
  if (colors > 1 || ports > 15) return RESTRIP_BAD_COLORING;
  const FlipRule found = flip_rule(colors != 0, static_cast<unsigned>(ports));
  if (!found.valid) return RESTRIP_BAD_COLORING;
  *answer = {found.inner ? Word{1} : Word{0}, found.ports, found.strips};
  return RESTRIP_OK;
}
