// Trace: a record of the changes to a mesh and its strips, which restrip-check checks, a program that shares no code
// with this library (docs/reference/file-formats.md has the format).
//
// The trace begins with all triangles and solid dual edges of the mesh. Each operation adds one line: the triangles
// removed and added, by vertex number, the dual edges that became dashed and solid, anywhere in the mesh, and the
// reported changes of strips and isolated triangles.
//
//   std::vector<Triangle> changed;
//   mesh.watch(&changed);
//   Keeper keeper(mesh, Policy::local);
//   Trace trace(mesh, Trace::Claim::no_worse);
//   const auto done = keeper.collapse(chord);          // of v_s -> v_t
//   trace.add(mesh, changed, {Traced::Kind::collapse, v_s, v_t, done.strips, done.isolated});
//   changed.clear();
//   trace.end();
//   file << trace.text();                              // or piece by piece, clearing the text each time
//
// A trace records differences between states of the mesh, not what an operation reports. So an operation that is traced
// under a wrong name, or not at all, makes a trace that is refused.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "restrip/mesh/strip_mesh.hpp"

namespace restrip {

/// One operation as a trace records it.
struct Traced {
  enum class Kind : std::uint8_t {
    split,     ///< `from` has been split, `to` is the new vertex
    collapse,  ///< `to` has been collapsed into `from`
    flip,      ///< the mesh edge between `from` and `to` has been turned
    other      ///< anything else, including several operations together; it claims nothing except the reported
               ///< changes
  };
  Kind kind = Kind::other;
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  int strips = 0;    ///< reported: the change in the number of strips of the whole mesh
  int isolated = 0;  ///< reported: the change in the number of isolated triangles
};

/// Keeps a copy of the triangles and their colours, 16 bytes a triangle, and the text until it is taken.
class Trace {
 public:
  /// The claim to check for every split, collapse and flip, in addition to valid colours and correct numbers.
  enum class Claim : std::uint8_t {
    valid,     ///< nothing more
    no_worse,  ///< no recolouring of only the patch that a rule may choose would have left fewer strips, or the
               ///< same number and fewer isolated triangles (Policy::local and policies that search further)
    best       ///< the recolouring is such a best one, and nothing outside the patch has changed (Policy::rules)
  };

  /// Linear time. Mesh edges must have at most one triangle on either side, or the trace will be refused.
  Trace(const StripMesh& mesh, Claim claim);
  Trace(Trace&& other) noexcept;
  Trace& operator=(Trace&& other) noexcept;
  ~Trace();

  /// `changed`: as StripMesh::watch makes it, since the last call. Time linear in `changed`, up to a
  /// logarithm.
  void add(const StripMesh& mesh, std::span<const std::uint32_t> changed, const Traced& done);

  /// A trace without an end is refused.
  void end();

  /// The text written so far. The caller clears it after taking it.
  [[nodiscard]] std::string& text() noexcept;

 private:
  struct Writer;
  std::unique_ptr<Writer> writer_;
};

}  // namespace restrip
