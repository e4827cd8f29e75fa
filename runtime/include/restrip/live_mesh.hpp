// LiveMesh: a mesh, its strips and the index buffer that draws them, in one object. Most engines need only this:
//
//   LiveMesh live(triangles, vertex_count);            // upload live.bytes(), with room for live.room() indices
//   live.collapse(live.edge(v_s, v_t));                // and split, flip, as often as the frame wants
//   const auto ranges = live.update();
//   if (ranges.outgrown) make_buffer(live.room());     // the only range is then everything
//   for (const auto& range : ranges) upload(range);
//   live.undo();                                       // the last frame, if a history is kept
//
// The parts can also be used separately: StripMesh, Keeper (search/keeper.hpp), LiveBuffer (output/live_buffer.hpp).
// For a member behind a pointer or a parameter by reference fwd.hpp is enough.
//
// Different objects may be used by different threads at the same time, one object only by one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "restrip/fwd.hpp"
#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/operations/result.hpp"
#include "restrip/output/strip_format.hpp"

namespace restrip {

struct LiveOptions {
  Policy policy = default_policy;
  Cost cost = default_cost;
  Effort effort = default_effort;  ///< for the initial strips
  /// The budget of undo, in changed triangles of all frames together, some 50 bytes each. Beyond it the oldest frames
  /// are dropped, but never the last one. 0: no history.
  std::size_t history = 0;
  /// The format of the buffer; limits of batches are not supported.
  StripFormat format = {.width = IndexWidth::bits32};
  /// How strips in the buffer stay short and in order for a vertex cache.
  LayoutOptions layout = {};
  /// Buffer and history begin with the first update(), as after begin_buffer(): for meshes that are not drawn yet.
  bool deferred = false;
};

/// What LiveMesh::pack() returns: by old number the new one, or `none` if the number was free.
struct Renumbering {
  std::vector<Triangle> triangles;
  std::vector<Vertex> vertices;
};

/// Can be moved, not copied; an object that was moved from can only be destroyed or assigned to. Each call throws what
/// its parts throw. After an exception of update(), undo() or redo() the mesh is valid, and the next update() returns
/// everything that has not been returned. If update() throws because 16 bits cannot name a vertex (std::length_error),
/// the frame has ended all the same, and undo() works; if memory ran out, earlier frames perhaps cannot be undone.
class LiveMesh {
 public:
  using Halfedge = StripMesh::Halfedge;

  /// `triangles`: as for StripMesh::build, which leaves out triangles with a corner twice or out of range. Only
  /// `report` counts them; check it unless the triangles are known to be good.
  template <class Triangles>
  RESTRIP_COLD LiveMesh(const Triangles& triangles, std::size_t vertex_count, const LiveOptions& options = {},
                        BuildReport* report = nullptr)
      : LiveMesh(StripMesh::build(triangles, vertex_count, report), options, Colors::from_scratch) {}
  /// Takes a mesh with its colours.
  explicit LiveMesh(StripMesh mesh, const LiveOptions& options = {})
      : LiveMesh(std::move(mesh), options, Colors::of_mesh) {}
  /// Plays a progressive mesh with precomputed strips (formats/baked_file.hpp), from its base on. Policy, cost and
  /// effort of the options are not used: other operations are done under Policy::local for fewest strips.
  explicit LiveMesh(std::shared_ptr<const BakedFile> file, const LiveOptions& options = {});
  LiveMesh(LiveMesh&& other) noexcept;
  LiveMesh& operator=(LiveMesh&& other) noexcept;
  ~LiveMesh();

  /// The halfedge from v to w, or {none}, which every operation refuses. O(valence of v).
  [[nodiscard]] Halfedge edge(Vertex v, Vertex w) const noexcept;

  /// Does the operation under the policy, or refuses it with a reason.
  Checked split(const VertexSplit& where, Vertex new_vertex = none);
  Checked collapse(Halfedge chord);
  Checked flip(Halfedge h);
  /// The same by vertices, for programs with another mesh next to this one: collapse() removes w; split() inserts
  /// triangles along the edges from v to `left` and `right`, of which one may be `none` on the boundary (VertexSplit).
  Checked collapse(Vertex v, Vertex w) { return collapse(edge(v, w)); }
  Checked flip(Vertex v, Vertex w) { return flip(edge(v, w)); }
  Checked split(Vertex v, Vertex left, Vertex right, Vertex new_vertex = none);
  /// The operations of refine.hpp, in the same way.
  Checked split_face(Halfedge h);
  Checked join_faces(Halfedge chord);
  Checked bisect(Halfedge h);
  Checked merge(Halfedge chord);
  /// A custom operation. Include operations/apply.hpp, which makes an OperationView of its table.
  Checked apply(const OperationView& table, Halfedge where);
  /// The same in the first orientation that fits, with this triangle as the first of the operation (first_place()).
  Checked apply_anywhere(const OperationView& table, Triangle triangle);

  /// Any change of a few triangles: removes `out`, by their numbers in mesh(), and adds `in`, each by its corners,
  /// counter-clockwise; either may be empty. The number of the triangle with the side a -> b is
  /// StripMesh::triangle(edge(a, b)). Numbers that are not in use become new vertices, vertices left without triangles
  /// go. Edges of removed triangles are cleared, then the policy searches among what has changed. Refused with a reason
  /// if the mesh would not be a manifold with boundary (check_replace() in checks.hpp). Quadratic in the triangles.
  Checked replace(std::span<const Triangle> out, std::span<const std::array<Vertex, 3>> in);

  /// Another policy and cost for all later operations. Undo does not restore them. Linear time.
  void keep(Policy policy, const Cost& cost);
  /// Strips from scratch for the present mesh (stripify.hpp), for this cost; returns their number. The next update()
  /// writes the whole buffer. A recolouring that changes a colour can be undone like an operation. Handles stay.
  /// Like operations, it leaves the levels of baked strips. Needs memory for a second mesh.
  std::size_t recolor(Effort effort, const Cost& cost, std::uint64_t limit = 0, const Interrupt* interrupt = nullptr);
  /// The same with given colours: bit s of solid_sides[t] for side s of triangle t below triangle_bound(). Returns
  /// false, and changes nothing, if they are not a valid colouring with 0 for numbers that are not triangles.
  bool recolor(std::span<const std::uint8_t> solid_sides);

  /// Baked strips: the file, or null.
  [[nodiscard]] const BakedFile* baked() const noexcept;
  /// The number of records that are played; none when the mesh has left its levels.
  [[nodiscard]] std::optional<std::size_t> level() const noexcept;
  /// Plays at most `most` records towards a level, which must exist, and returns their number: 0 if the mesh has left
  /// its levels. A frame of them can be undone, and is in step again.
  std::size_t move_to_level(std::size_t level, std::size_t most = (std::numeric_limits<std::size_t>::max)());
  /// Goes back to level 0 from any state, and to the policy and cost of baked meshes; the mesh must be baked. The next
  /// update() writes the whole buffer, and the history begins again. Linear time.
  void restart();

  /// For idle time: see Keeper::improve. Returns the cost saved. Leaves the levels of baked strips.
  std::size_t improve(std::size_t budget);

  /// Gives triangles and vertices the lowest numbers, in their order: for a mesh that has shrunk, whose arrays have
  /// room for numbers that are free. Vertices without triangles go. The next update() writes the whole buffer, and the
  /// history begins again. Leaves the levels of baked strips. Linear time. Rearrange your own data by the result.
  Renumbering pack();

  /// Ends a frame and returns the ranges of the buffer that must be uploaded, ascending; valid until the next call.
  /// Upload::outgrown says that the buffer on the device is too small. The constructor writes the buffer already, and
  /// the first update() returns only what has changed since: upload bytes() once before. If the options have
  /// `deferred`, the first update() returns everything.
  Upload update(const RangeOptions& ranges = {});
  /// Makes the next update() also return the ranges of the last one, for a caller that could not upload them.
  void keep_upload() noexcept;
  /// Undo or redo a frame; changes since the last update() count as a frame. Triangles, handles and colours are
  /// restored exactly, and so is the level of baked strips; the next update() draws them as after any change. What
  /// later operations choose may differ: searches do not go back. False when there is nothing to undo or redo. Your
  /// data of vertices is not restored, and the numbers of removed vertices are used again: save the data of a vertex
  /// before an operation that changes it. Time linear in what the frame changed; under the cost of strips and a policy
  /// that tunnels, linear in the mesh.
  bool undo();
  bool redo();

  /// Triangles and vertices by their numbers, colours, policy, cost, format and layout, as bytes that are the same on
  /// every machine (docs/reference/file-formats.md): 13 for each triangle, and a bit for each number. The history,
  /// baked strips (the loaded mesh has left its levels), counts of rules and limits set with keeper().set_search() are
  /// not saved. Linear time.
  [[nodiscard]] std::vector<std::byte> save() const;
  /// Reads what save() has written. Handles and colours are those of the saved mesh; buffer and searches begin again,
  /// so upload bytes(), with room() indices. Free numbers are used again from the lowest on. `history`: see
  /// LiveOptions. Throws std::invalid_argument with the reason for bytes that are truncated, altered, of another
  /// version, or that describe what no LiveMesh can be, and std::length_error if 16 bits cannot name a vertex; bytes
  /// from an untrusted source are safe. Memory and time are linear in the bytes.
  [[nodiscard]] static LiveMesh load(std::span<const std::byte> bytes, std::size_t history = 0);

  /// The number of frames that can be undone and redone, without changes since the last update().
  [[nodiscard]] std::size_t undoable() const noexcept;
  [[nodiscard]] std::size_t redoable() const noexcept;
  /// The number of the present frame: of all frames since the history began, those that are not undone. For data that
  /// undo is to restore as well, such as points: note each change with this number. After undo() the changes noted with
  /// the present number or a higher one are undone; after redo() those with lower ones are done. Changes before the
  /// next update() belong to the present number; update() raises it if something has changed. 0 without a history.
  [[nodiscard]] std::size_t frame() const noexcept;

  /// Begins buffer and history again, in another format: the next update() writes and returns everything.
  void begin_buffer(const StripFormat& format, const LayoutOptions& layout = {}, std::size_t history = 0);
  /// Makes room for a mesh of this size, so that growing to it does not allocate (LiveBuffer::reserve).
  void reserve(std::size_t triangles, std::size_t vertices);
  /// The buffer: see live_buffer.hpp. `indices` are empty when they have 16 bits.
  [[nodiscard]] std::span<const std::uint32_t> indices() const noexcept;
  [[nodiscard]] std::span<const std::uint16_t> indices16() const noexcept;
  [[nodiscard]] std::span<const std::byte> bytes() const noexcept;
  [[nodiscard]] std::size_t index_bytes() const noexcept;
  /// The number of indices that the buffer on the device should have room for.
  [[nodiscard]] std::size_t room() const noexcept;

  [[nodiscard]] const StripMesh& mesh() const noexcept;
  [[nodiscard]] std::size_t strips() const noexcept;
  /// The triangles that have changed since the last update(), some more than once.
  [[nodiscard]] std::span<const Triangle> changed() const noexcept;
  /// Counts of rules used and not used in all operations so far, undone ones included.
  [[nodiscard]] const RuleCounts& rule_counts() const noexcept;
  /// The parts, for members that are not repeated here: include search/keeper.hpp, output/live_buffer.hpp. The keeper
  /// is not up to date while baked strips are at a level; asked for as one that may change, it leaves the level.
  [[nodiscard]] Keeper& keeper() noexcept;
  [[nodiscard]] const Keeper& keeper() const noexcept;
  [[nodiscard]] const LiveBuffer& buffer() const noexcept;

 private:
  enum class Colors : std::uint8_t { of_mesh, from_scratch };
  struct Parts;

  LiveMesh(StripMesh mesh, const LiveOptions& options, Colors colors);

  std::unique_ptr<Parts> parts_;
};

}  // namespace restrip
