// History: undo and redo of whole frames of a StripMesh, colours included.
//
// Inverse operations restore a mesh, but not its strips: rules and searches choose new colours on the way back. A
// history keeps the changed triangles of each frame as they were before and after it. So undo restores triangles,
// handles and colours bit for bit.
//
//   std::vector<Triangle> changed;
//   mesh.watch(&changed);
//   History history(mesh);
//   ... operations of a frame, under a keeper or not ...
//   history.frame(mesh, changed);                      // the frame ends here
//   history.undo(mesh);  keeper.rebuild();             // changed names what undo changed
//
// A frame takes time and memory linear in the triangles that changed in it, some 50 bytes each. The history also holds
// one copy of the mesh, with which it finds the changes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <span>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"

namespace restrip {

class History {
 public:
  /// Begins with the mesh as it is. Linear time. `most_triangles` limits the changed triangles of all frames together:
  /// beyond it the oldest frames are dropped, but never the last one.
  explicit History(const StripMesh& mesh, std::size_t most_triangles = (std::numeric_limits<std::size_t>::max)());

  /// Ends a frame. `changed`: the list made by the watch of the mesh since the previous frame; not cleared. Frames that
  /// were undone and not redone are dropped. Returns false and adds no frame when the mesh has not changed; free
  /// handles in another order are a change. After std::bad_alloc the history must not be used any more.
  bool frame(const StripMesh& mesh, std::span<const Triangle> changed);

  /// undo() restores the mesh as it was before the last frame, redo() as it was after the frame undone last. Both
  /// return false when no such frame exists. Call them right after frame(): later changes are lost. The watch of the
  /// mesh is notified. Keepers of the mesh must be rebuilt, buffers updated. After std::bad_alloc nothing has changed.
  bool undo(StripMesh& mesh);
  bool redo(StripMesh& mesh);

  [[nodiscard]] std::size_t undoable() const noexcept { return done_; }
  [[nodiscard]] std::size_t redoable() const noexcept { return frames_.size() - done_; }
  /// All frames since the beginning that are not undone, dropped ones included.
  [[nodiscard]] std::size_t number() const noexcept { return dropped_ + done_; }

 private:
  /// How many elements the four arrays of the mesh have.
  struct Sizes {
    std::size_t triangles = 0;
    std::size_t vertices = 0;
    std::size_t free = 0;
    std::size_t free_vertices = 0;
    friend constexpr bool operator==(const Sizes&, const Sizes&) = default;
  };
  /// The elements that a frame has changed, with the values that they do not have now: those before the frame while it
  /// is done, those after it while it is undone.
  struct Frame {
    std::vector<std::uint32_t> data;  ///< number and record of each triangle, then number and value of the others
    std::size_t triangles = 0;
    std::size_t spokes = 0;
    std::size_t free = 0;  ///< the rest: free vertices
    Sizes sizes;
    /// Its memory, in triangles.
    [[nodiscard]] std::size_t size() const noexcept;
  };

  [[nodiscard]] static Sizes sizes_of(const StripMesh& mesh) noexcept;
  static void resize(StripMesh& mesh, const Sizes& sizes);
  void note_end(std::vector<std::uint32_t>& last, const std::vector<std::uint32_t>& now, std::size_t changes);
  void step(StripMesh& mesh, Frame& frame);

  StripMesh last_;  // as it was at the end of the last frame
  std::deque<Frame> frames_;
  std::size_t done_ = 0;     // frames that are not undone
  std::size_t dropped_ = 0;  // frames before the first one
  std::size_t kept_ = 0;     // triangles of all frames
  std::size_t most_;
  std::vector<std::uint32_t> data_;  // of the frame that is being made
};

}  // namespace restrip
