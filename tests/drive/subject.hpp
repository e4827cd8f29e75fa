// What the driver of random operations (driver.hpp) drives: a LiveMesh, through C++ (live_subject.hpp) or through the C
// interface (tests/c). Calls are data, so that they can be repeated on a second subject, and oracles (oracles.hpp) can
// look before and after each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "restrip/live_mesh.hpp"
#include "runtime/form_reader.hpp"
#include "runtime/sample_meshes.hpp"
#include "support/promise.hpp"

namespace restrip::drive {

using sample::Corners;
using Triangles = std::vector<Corners>;

using testing_support::promise;

/// Members of LiveMesh. The first ones are operations, of which those before `apply` have their own name and take one
/// halfedge or, for splits, two.
enum class Call : std::uint8_t {
  split,
  collapse,
  flip,
  split_face,
  join_faces,
  bisect,
  merge,
  apply,
  replace,
  improve,
  recolor,
  keep,
  move_to_level,
  pack,
  reload,  ///< saves the mesh and continues with what was loaded
  update,
  undo,
  redo
};
inline constexpr std::size_t calls = static_cast<std::size_t>(Call::redo) + 1;
constexpr bool is_operation(Call call) noexcept { return call <= Call::replace; }

/// A call with its arguments; each call reads its own.
struct Step {
  Call call{};
  bool by_vertices = false;     ///< collapse, flip and split by the numbers of vertices instead of halfedges
  VertexSplit where{};          ///< split; otherwise `left` is the halfedge
  Vertex name = none;           ///< split: the new vertex
  std::size_t number = 0;       ///< apply: of operations(); improve: the budget; a level; keep: the states of a search
  std::vector<Triangle> out{};  ///< replace
  Triangles in{};               ///< replace
  Policy policy{};
  Cost cost{};
  RangeOptions ranges{};
  bool lost = false;  ///< update: the caller cannot upload the ranges, and calls keep_upload()
};

struct Outcome {
  enum class End : std::uint8_t { done, refused, out_of_memory, too_wide };
  End end = End::done;
  const char* reason = "";  ///< of a refusal
  Rewrite rewrite;          ///< of an operation
  NewVertices added;        ///< likewise
  bool moved = false;       ///< undo, redo: a frame
  std::size_t number = 0;   ///< improve: the cost saved; recolor: strips; move_to_level: records
  Upload upload;            ///< valid until the next call
  Renumbering numbers;      ///< pack

  [[nodiscard]] bool done() const noexcept { return end == End::done; }
};

/// The tables that Call::apply numbers: the shipped operations of strips.
[[nodiscard]] std::span<const OperationView> operations();

struct BufferView {
  std::span<const std::byte> bytes;
  std::size_t width = 0;  ///< bytes of an index
  std::size_t room = 0;   ///< in indices
  StripForm form{};
  std::span<const IndexRange> draws;
};

class Subject {
 public:
  virtual ~Subject() = default;
  /// Allocates nothing besides the call itself, of which an allocation may fail.
  virtual Outcome perform(const Step& step) = 0;
  /// Whether the interface has this call.
  [[nodiscard]] virtual bool can(Call call) const = 0;

  [[nodiscard]] virtual std::size_t triangle_bound() const = 0;
  [[nodiscard]] virtual std::size_t vertex_bound() const = 0;
  /// `none` three times for numbers that are free.
  [[nodiscard]] virtual Corners corners(Triangle t) const = 0;
  /// {none} if h is not a halfedge of the mesh.
  [[nodiscard]] virtual Halfedge opposite(Halfedge h) const = 0;
  [[nodiscard]] virtual bool solid(Halfedge h) const = 0;
  [[nodiscard]] virtual std::size_t strips() const = 0;
  /// Triangles by number with their corners, neighbours and colours; LiveMesh adds what else undo restores.
  [[nodiscard]] virtual std::vector<std::uint32_t> look() const {
    std::vector<std::uint32_t> look{static_cast<std::uint32_t>(triangle_bound())};
    for (Triangle t = 0; t < triangle_bound(); ++t)
      for (unsigned side = 0; has_triangle(t) && side < 3; ++side) {
        const Halfedge h = StripMesh::halfedge(t, side);
        look.insert(look.end(), {h.id, corners(t)[side], opposite(h).id, solid(h) ? 1U : 0U});
      }
    return look;
  }

  [[nodiscard]] virtual BufferView buffer() = 0;
  [[nodiscard]] virtual std::size_t undoable() const = 0;
  [[nodiscard]] virtual std::size_t redoable() const = 0;
  [[nodiscard]] virtual std::size_t frame() const = 0;

  /// The LiveMesh, for oracles that know C++; or null.
  [[nodiscard]] virtual const LiveMesh* live() const { return nullptr; }

  [[nodiscard]] bool has_triangle(Triangle t) const { return t < triangle_bound() && corners(t)[0] != none; }
  [[nodiscard]] Triangles triangles() const {
    Triangles all;
    for (Triangle t = 0; t < triangle_bound(); ++t)
      if (has_triangle(t)) all.push_back(corners(t));
    return sample::sorted(std::move(all));
  }
};

}  // namespace restrip::drive
