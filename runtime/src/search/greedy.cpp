// Greedy strips.
//
// Outline. Fewest strips = most solid edges without a cycle and with at most two at each triangle. All dual edges start
// *open*; one after another is made solid or dropped. A triangle is *forced* if it can still take all of its open
// edges: they all become solid, which loses nothing as long as the rest can be completed. Only when nothing is forced
// is an edge chosen freely, at the strip end that has waited longest. Strips then grow around each other in rings, and
// few triangles are left between them (on the Stanford bunny a third of the strips, compared with preferring the newest
// end). This is Karp and Sipser's rule for matchings (1981), applied to paths as in the 2GREEDY algorithm of Bohman and
// Frieze ("Hamilton cycles in random graphs with minimum degree at least 3", 2013).
//
// Each end of a growing strip knows the other end, so the test for cycles takes constant time.
#include "search/greedy.hpp"

#include <cstdint>
#include <vector>

namespace restrip {

namespace {

class GreedyStrips {
 public:
  explicit GreedyStrips(StripMesh& mesh) : mesh_(mesh), nodes_(mesh.triangle_bound()) {
    waiting_.reserve(mesh.triangle_count());
  }

  std::size_t run() {
    mesh_.clear_colors();
    for (Triangle t = 0; t < nodes_.size(); ++t) {
      if (!mesh_.alive(t)) continue;
      nodes_[t].other_end = t;
      unsigned open = 0;
      for (unsigned s = 0; s < 3; ++s)
        if (!StripMesh::on_boundary(mesh_.opposite(StripMesh::halfedge(t, s)))) open |= 1U << s;
      nodes_[t].open = static_cast<std::uint8_t>(open);
      if (open != 0 && slack(t) <= 0) forced_.push_back(t);
    }
    std::size_t head = 0;
    Triangle scan = 0;
    for (;;) {
      if (!forced_.empty()) {
        const Triangle t = forced_.back();
        forced_.pop_back();
        while (nodes_[t].open != 0) take(t, lowest(nodes_[t].open));
      } else if (head < waiting_.size() || scan < nodes_.size()) {
        const bool grows = head < waiting_.size();
        const Triangle t = grows ? waiting_[head] : scan;
        if (nodes_[t].open != 0)
          take(t, preferred(t));
        else if (grows)
          ++head;
        else
          ++scan;
      } else {
        break;
      }
    }
    return mesh_.triangle_count() - solid_;
  }

 private:
  struct Node {
    Triangle other_end = none;  // of the strip that ends here
    std::uint8_t open = 0;      // mask of sides
    std::uint8_t solid = 0;     // number of solid sides
  };

  static unsigned lowest(unsigned mask) noexcept { return (mask & 1U) != 0 ? 0 : (mask & 2U) != 0 ? 1 : 2; }
  static int count(unsigned mask) noexcept {
    return static_cast<int>((mask & 1U) + (mask >> 1 & 1U) + (mask >> 2 & 1U));
  }
  [[nodiscard]] int slack(Triangle t) const noexcept { return count(nodes_[t].open) - (2 - nodes_[t].solid); }

  // The first open side towards the end of a strip, or else the first open side.
  [[nodiscard]] unsigned preferred(Triangle t) const noexcept {
    const unsigned open = nodes_[t].open;
    for (unsigned s = 0; s < 3; ++s)
      if ((open >> s & 1U) != 0 && nodes_[StripMesh::triangle(mesh_.opposite(StripMesh::halfedge(t, s)))].solid == 1)
        return s;
    return lowest(open);
  }

  void drop(Triangle t, unsigned s) {
    const StripMesh::Halfedge back = mesh_.opposite(StripMesh::halfedge(t, s));
    close(t, s);
    close(StripMesh::triangle(back), StripMesh::side(back));
  }
  void close(Triangle t, unsigned s) {
    Node& node = nodes_[t];
    node.open = static_cast<std::uint8_t>(node.open & ~(1U << s));
    if (node.open != 0 && node.solid < 2 && slack(t) <= 0) forced_.push_back(t);
  }

  // Makes an open side solid, or drops it if it would close a cycle.
  void take(Triangle t, unsigned s) {
    const StripMesh::Halfedge h = StripMesh::halfedge(t, s);
    const StripMesh::Halfedge back = mesh_.opposite(h);
    const Triangle u = StripMesh::triangle(back);
    const Triangle t_end = nodes_[t].other_end;
    const Triangle u_end = nodes_[u].other_end;
    if (t_end == u) {
      drop(t, s);
      return;
    }
    mesh_.set_solid(h, true);
    ++solid_;
    nodes_[t_end].other_end = u_end;
    nodes_[u_end].other_end = t_end;
    ++nodes_[t].solid;
    ++nodes_[u].solid;
    close(t, s);
    close(u, StripMesh::side(back));
    for (const Triangle full : {t, u}) {
      if (nodes_[full].solid < 2) {
        waiting_.push_back(full);
        continue;
      }
      if (nodes_[full].open != 0) drop(full, lowest(nodes_[full].open));
    }
  }

  StripMesh& mesh_;
  std::vector<Node> nodes_;
  std::vector<Triangle> forced_;
  std::vector<Triangle> waiting_;  // every end so far, oldest first
  std::size_t solid_ = 0;
};

}  // namespace

std::size_t stripify_fast(StripMesh& mesh) { return GreedyStrips(mesh).run(); }

}  // namespace restrip
