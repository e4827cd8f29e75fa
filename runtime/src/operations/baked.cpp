// Baked strips: colours flipped before or after the change of the mesh.
//
// Outline. Between two levels lies the plain colouring: a split gives both halves of an edge that it cuts the colour of
// that edge, a collapse gives a merged edge the colour that both its halves have, and all other new dual edges are
// dashed. A record lists the dual edges in which the baked colouring of the finer level differs from it. The flips that
// clear edges come first, so that the colouring is valid at every moment.
//
// Cost. The mesh operation, and linear in the flips.
#include "restrip/operations/baked.hpp"

#include <cstddef>
#include <span>
#include <vector>

#include "restrip/mesh/checks.hpp"
#include "restrip/precondition.hpp"
#include "restrip/rules/bits.hpp"

namespace restrip {

namespace {

/// Records with more flips allocate a bit for each.
constexpr std::size_t flips_without_allocation = 512;

/// Before a collapse: the two halves of an edge that is merged, on one side of the chord.
struct FallingEdge {
  bool triangle = false;  ///< whether the chord has one on this side
  bool solid = false;
  Halfedge before{};  ///< the halfedge before the joined one, in a triangle that stays

  FallingEdge(const StripMesh& mesh, Halfedge chord) {
    if (mesh.on_boundary(chord)) return;
    triangle = true;
    const auto half = mesh.next(chord);
    solid = mesh.solid(half);
    // The joined edge keeps the name of one of its halves, which only the mesh knows: find it from a neighbour that
    // stays.
    if (solid) before = mesh.next(mesh.next(mesh.opposite(half)));
  }
  void color(StripMesh& mesh) const {
    if (solid) mesh.set_solid(mesh.next(before), true);
  }
};

}  // namespace

int flip_colors(StripMesh& mesh, std::span<const Halfedge> flips) {
  Word few[flips_without_allocation / word_bits] = {};
  std::vector<Word> many;
  if (flips.size() > flips_without_allocation) many.resize(flips.size() / word_bits + 1, 0);
  const std::span<Word> done = many.empty() ? std::span<Word>(few) : std::span<Word>(many);
  int more = 0;
  for (std::size_t i = 0; i < flips.size(); ++i) {
    RESTRIP_ASSERT(mesh.alive(flips[i]), "flips of a baked record", describe(Refusal::no_such_edge));
    RESTRIP_ASSERT(!mesh.on_boundary(flips[i]) && !mesh.on_boundary(mesh.opposite(flips[i])), "flips of a baked record",
                   describe(Refusal::boundary_edge));
    if (!mesh.solid(flips[i])) continue;
    done[i / word_bits] |= bit(i % word_bits);
    mesh.set_solid(flips[i], false);
    --more;
  }
  for (std::size_t i = 0; i < flips.size(); ++i) {
    if (has(done[i / word_bits], i % word_bits)) continue;
    mesh.set_solid(flips[i], true);
    ++more;
  }
  return more;
}

Rewrite split_baked(StripMesh& mesh, const VertexSplit& where, std::span<const Halfedge> flips, Vertex new_vertex) {
  RESTRIP_ASSERT_GRANTED(check_split(mesh, where, new_vertex), "split_baked");
  using Spokes = VertexSplit::Spokes;
  const bool left = where.spokes != Spokes::right_only && mesh.solid(where.left);
  const bool right = where.spokes != Spokes::left_only && mesh.solid(where.right);
  const Halfedge chord = mesh.insert_vertex(where, new_vertex);
  const auto color_both_halves = [&mesh](Halfedge side) {
    const Halfedge half = StripMesh::next(side);
    mesh.set_solid(half, true);
    mesh.set_solid(StripMesh::next(half), true);
  };
  if (left) color_both_halves(chord);
  if (right) color_both_halves(mesh.opposite(chord));
  const int triangles = where.spokes == Spokes::both ? 2 : 1;
  return {{triangles - int{left} - int{right} - flip_colors(mesh, flips), 0, 0}, chord, 0};
}

Rewrite collapse_baked(StripMesh& mesh, Halfedge chord, std::span<const Halfedge> flips) {
  RESTRIP_ASSERT_GRANTED(check_collapse(mesh, chord), "collapse_baked");
  const int more = flip_colors(mesh, flips);
  const FallingEdge left(mesh, chord);
  const FallingEdge right(mesh, mesh.opposite(chord));
  const Halfedge spoke = mesh.remove_vertex(chord);
  left.color(mesh);
  right.color(mesh);
  const int triangles = int{left.triangle} + int{right.triangle};
  return {{int{left.solid} + int{right.solid} - triangles - more, 0, 0}, spoke, 0};
}

}  // namespace restrip
