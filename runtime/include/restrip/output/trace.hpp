// Trace: a record of the changes to a mesh and its strips, which restrip-check checks, a program that shares no code
// with this library (docs/reference/file-formats.md has the format).
//
// The trace begins with all triangles and solid dual edges of the mesh. Each operation adds one line: the triangles
// removed and added, by vertex number, the dual edges that became dashed and solid, anywhere in the mesh, and the
// reported changes of strips and isolated triangles.
//
//   std::vector<Triangle> changed;
//   mesh.watch(&changed);                              // or a Watched, for meshes other than StripMesh
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

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "restrip/mesh/mesh.hpp"

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
  template <NumberedMesh Mesh>
  Trace(const Mesh& mesh, Claim claim) {
    constexpr std::array<std::string_view, 3> words{"valid", "no-worse", "best"};
    text_ = "restrip-trace 1\nclaim ";
    text_ += words[static_cast<std::size_t>(claim)];
    text_ += '\n';
    seen_.resize(mesh.triangle_bound());
    for (std::uint32_t t = 0; t < seen_.size(); ++t) {
      seen_[t] = seen(mesh, t);
      if (!seen_[t].there()) continue;
      line("t", seen_[t].corners);
      solid_edges(seen_[t], after_);
    }
    settle(after_);
    for (const Edge& edge : after_) line("s", edge);
  }

  /// `changed`: as StripMesh::watch and Watched make it, since the last call. Time linear in `changed`, up to a
  /// logarithm.
  template <NumberedMesh Mesh>
  void add(const Mesh& mesh, std::span<const std::uint32_t> changed, const Traced& done) {
    constexpr std::array<std::string_view, 4> words{"split", "collapse", "flip", "other"};
    named_.assign(changed.begin(), changed.end());
    std::sort(named_.begin(), named_.end());
    named_.erase(std::unique(named_.begin(), named_.end()), named_.end());
    if (seen_.size() < mesh.triangle_bound()) seen_.resize(mesh.triangle_bound());
    before_.clear();
    after_.clear();
    gone_.clear();
    come_.clear();
    for (const std::uint32_t t : named_) {
      const SeenTriangle now = seen(mesh, t);
      SeenTriangle& then = seen_[t];
      solid_edges(then, before_);
      solid_edges(now, after_);
      if (then.corners != now.corners) {
        if (then.there()) gone_.push_back(then.corners);
        if (now.there()) come_.push_back(now.corners);
      }
      then = now;
    }
    settle(before_);
    settle(after_);
    text_ += words[static_cast<std::size_t>(done.kind)];
    append(std::array{done.from, done.to});
    append(std::array{done.strips, done.isolated});
    list(" -", gone_);
    list(" +", come_);
    list(" d", differences(before_, after_));
    list(" s", differences(after_, before_));
    text_ += '\n';
    ++operations_;
  }

  /// A trace without an end is refused.
  void end() { line("end", std::array{operations_}); }

  /// The text written so far. The caller clears it after taking it.
  [[nodiscard]] std::string& text() noexcept { return text_; }

 private:
  using Edge = std::array<std::uint32_t, 2>;     // the smaller vertex first
  using Corners = std::array<std::uint32_t, 3>;  // counter-clockwise, the smallest first

  static constexpr std::uint32_t nothing = (std::numeric_limits<std::uint32_t>::max)();
  struct SeenTriangle {
    Corners corners{nothing, nothing, nothing};
    std::uint32_t solid = 0;  // bit s: the edge from corner s to the next one
    [[nodiscard]] bool there() const noexcept { return corners[0] != nothing; }
  };

  template <class Mesh>
  static SeenTriangle seen(const Mesh& mesh, std::uint32_t t) {
    SeenTriangle now;
    if (t >= mesh.triangle_bound() || !mesh.has_triangle(t)) return now;
    const auto corner = [&](auto of) { return static_cast<std::uint32_t>(mesh.from(of)); };
    auto h = mesh.halfedge(t);
    const auto second = mesh.next(h);
    for (const auto other : {second, mesh.next(second)})
      if (corner(other) < corner(h)) h = other;
    for (std::size_t side = 0; side < 3; ++side, h = mesh.next(h)) {
      now.corners[side] = corner(h);
      if (!mesh.on_boundary(mesh.opposite(h)) && mesh.solid(h)) now.solid |= 1U << side;
    }
    return now;
  }

  static void solid_edges(const SeenTriangle& triangle, std::vector<Edge>& edges) {
    for (std::size_t side = 0; side < 3; ++side) {
      if ((triangle.solid >> side & 1U) == 0) continue;
      const std::uint32_t from = triangle.corners[side];
      const std::uint32_t to = triangle.corners[side == 2 ? 0 : side + 1];
      edges.push_back({(std::min)(from, to), (std::max)(from, to)});
    }
  }
  /// Leaves each edge once: it was found from both of its triangles, or from one.
  static void settle(std::vector<Edge>& edges) {
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  }
  const std::vector<Edge>& differences(const std::vector<Edge>& of, const std::vector<Edge>& from) {
    difference_.clear();
    std::set_difference(of.begin(), of.end(), from.begin(), from.end(), std::back_inserter(difference_));
    return difference_;
  }

  template <class Number, std::size_t n>
  void append(const std::array<Number, n>& numbers) {
    for (const Number number : numbers) {
      std::array<char, 24> digits{};
      digits[0] = ' ';
      const auto last = std::to_chars(digits.data() + 1, digits.data() + digits.size(), number).ptr;
      text_.append(digits.data(), last);
    }
  }
  template <class Numbers>
  void line(std::string_view word, const Numbers& numbers) {
    text_ += word;
    append(numbers);
    text_ += '\n';
  }
  template <class Numbers>
  void list(std::string_view sign, const std::vector<Numbers>& all) {
    if (all.empty()) return;
    text_ += sign;
    for (const Numbers& numbers : all) append(numbers);
  }

  std::string text_;
  std::size_t operations_ = 0;
  std::vector<SeenTriangle> seen_;  // by triangle
  // Scratch lists of one operation, kept for their memory.
  std::vector<std::uint32_t> named_;
  std::vector<Edge> before_;
  std::vector<Edge> after_;
  std::vector<Edge> difference_;
  std::vector<Corners> gone_;
  std::vector<Corners> come_;
};

}  // namespace restrip
