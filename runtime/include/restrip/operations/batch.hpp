// Batches: many splits or many collapses of a StripMesh at the same time.
//
// A rule reads and writes nothing outside its patch, so operations on disjoint patches commute
// (docs/explanation/theory.md, the locality lemma). A batch is a list of such operations. The result is, byte for byte,
// the same as when they are done one by one in the order of the list: the same triangle and vertex handles, links,
// colours and first spokes, for any number of threads and any order of execution. Only handles depend on the order. One
// thread takes them before the parallel part (splits) or gives them back after it (collapses), in the order of the
// list.
//
// Threads are std::jthread, or oneTBB if RESTRIP_USE_TBB is defined (then link TBB::tbb, and define it in the same way
// in all sources of a program). The default is one thread, the caller's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "restrip/mesh/checks.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/operations/operations.hpp"

namespace restrip {

/// One split of a batch. `new_vertex`: a free vertex, or `none` for the next free one. In a batch either all requests
/// name their new vertex or none does; otherwise one request could take the vertex that another names.
struct SplitRequest {
  VertexSplit<StripMesh::Halfedge> where;
  Vertex new_vertex = none;
};

struct BatchOptions {
  /// 1: only the caller's thread; 0: one for each processor. Batches of a few operations stay in the caller's thread.
  unsigned threads = 1;
  /// True: the caller guarantees that every operation is granted and that no two overlap (PatchClaims); only debug
  /// builds check that (precondition.hpp).
  bool checked = false;
};

/// Why a batch was not done.
enum class BatchFault {
  done,           ///< no fault
  refused,        ///< a request is refused by itself: BatchReport::refusal says why
  overlap,        ///< the patches of two requests overlap
  vertex_in_use,  ///< a request names a new vertex that has triangles already
  mixed_names     ///< some requests name their new vertex and some do not
};

/// One human-readable sentence.
[[nodiscard]] constexpr const char* describe(BatchFault fault) noexcept {
  switch (fault) {
    case BatchFault::done:
      return "the batch is done";
    case BatchFault::refused:
      return "an operation of the batch is not possible";
    case BatchFault::overlap:
      return "two operations of the batch overlap";
    case BatchFault::vertex_in_use:
      return "the vertex named for a split is in use";
    case BatchFault::mixed_names:
      return "either all splits of a batch name their new vertex, or none does";
  }
  return "unknown";
}

/// The result of a batch; after a fault, the first request that conflicts with earlier ones, and why. A batch with a
/// fault has changed nothing.
struct BatchReport {
  BatchFault fault = BatchFault::done;
  std::size_t request = 0;             ///< the request at fault
  std::size_t other = 0;               ///< the earlier request that it conflicts with; else the same as `request`
  Refusal refusal = Refusal::granted;  ///< for BatchFault::refused
  std::vector<Rewrite<StripMesh::Halfedge>> rewrites;  ///< one for each request
  std::int64_t strips = 0;                             ///< change in the number of strips, in total
  std::int64_t isolated = 0;                           ///< change in the number of isolated triangles, in total
  [[nodiscard]] bool done() const noexcept { return fault == BatchFault::done; }
};

/// Does the splits. O(sum of valences); checks also initialise 4 bytes for each triangle and vertex of the mesh. Checks
/// (which cost more than the operations themselves) and splits run in parallel; handles are taken in the caller's
/// thread. An exception in the parallel part (std::bad_alloc; only fans of more than max_word_valence triangles
/// allocate) leaves the mesh unusable.
BatchReport split_batch(StripMesh& mesh, std::span<const SplitRequest> requests, const BatchOptions& options = {});

/// Does the collapses, each given by its chord v_s -> v_t. Complexity and exceptions as for split_batch.
BatchReport collapse_batch(StripMesh& mesh, std::span<const StripMesh::Halfedge> chords,
                           const BatchOptions& options = {});

/// Records which operation owns which part of a mesh, to choose operations for a batch or to report conflicts.
///
/// Two operations overlap when they claim the same triangle or the same vertex:
///  - a split claims the triangles around v_s. Triangles across its ports stay free, because it reads port colours
///    inside the fan and writes no link outside it. It also claims the vertex that a spoke without left triangle
///    enters, because that vertex's first spoke moves, and the new vertex if it is named;
///  - a collapse claims the triangles around v_s and v_t, and the apexes v_l and v_r, whose first spokes it reads and
///    may write.
/// If operations do not overlap and each is granted by its check, each stays granted while the others are done.
/// The mesh must not change while it is claimed.
class PatchClaims {
 public:
  explicit PatchClaims(const StripMesh& mesh)
      : mesh_(mesh), triangles_(mesh.triangle_bound(), none), vertices_(mesh.vertex_bound(), none) {}
  /// Claims the patch of an operation for `number` (below `none`). When it overlaps with earlier ones, it claims
  /// nothing and returns their smallest number. Precondition: the operation is granted by its check. O(valence).
  std::optional<std::size_t> claim(const SplitRequest& request, std::size_t number);
  std::optional<std::size_t> claim(StripMesh::Halfedge chord, std::size_t number);

 private:
  template <class Operation>
  std::optional<std::size_t> claim_patch(const Operation& operation, std::size_t number);

  const StripMesh& mesh_;
  std::vector<std::uint32_t> triangles_;  // the number of the owner, or none
  std::vector<std::uint32_t> vertices_;
};

}  // namespace restrip

#include "restrip/operations/impl/batch.hpp"
