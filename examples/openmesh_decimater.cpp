// An OpenMesh decimater with strips: a module that does each collapse on a LiveMesh as well, by vertex numbers.
//
// OpenMesh calls a module before each collapse of v0 into v1. The live mesh does the same one, so after each frame its
// buffer draws the triangles that OpenMesh has. Here both are compared after every hundred collapses.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <span>
#include <vector>

#include "restrip/live_mesh.hpp"
#include "restrip/mesh/checks.hpp"

namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Each triangle from its smallest corner on, in ascending order.
Triangles sorted(Triangles list) {
  for (auto& t : list) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(list.begin(), list.end());
  return list;
}

/// What a device draws of strips with primitive restart.
Triangles drawn(std::span<const std::uint32_t> indices) {
  Triangles list;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] == 0xFFFFFFFF) {
      begin = i + 1;
    } else if (i >= begin + 2) {
      const bool odd = (i - begin) % 2 != 0;
      const std::array<std::uint32_t, 3> t{indices[i - 2], indices[odd ? i : i - 1], indices[odd ? i - 1 : i]};
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) list.push_back(t);
    }
  }
  return sorted(std::move(list));
}

struct StartMesh {
  std::vector<std::array<double, 3>> points;
  Triangles triangles;
};

/// A torus with bumps.
StartMesh bumpy_torus() {
  StartMesh torus;
  constexpr int columns = 60;
  constexpr int rows = 30;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      const double u = 6.283185307 * x / columns;
      const double v = 6.283185307 * y / rows;
      const double around = 3 + std::cos(v) * (1 + 0.1 * std::sin(5 * u));
      torus.points.push_back({around * std::cos(u), around * std::sin(u), std::sin(v)});
      const auto at = [&](int dx, int dy) { return std::uint32_t((y + dy) % rows * columns + (x + dx) % columns); };
      torus.triangles.push_back({at(0, 0), at(1, 0), at(1, 1)});
      torus.triangles.push_back({at(0, 0), at(1, 1), at(0, 1)});
    }
  return torus;
}

/// As an index buffer.
std::vector<std::uint32_t> indices_of(const Triangles& list) {
  std::vector<std::uint32_t> indices;
  for (const auto& t : list) indices.insert(indices.end(), t.begin(), t.end());
  return indices;
}

using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;

/// Accepts every collapse that the live mesh would do, and does it there.
template <class MeshT>
class ModStripsT : public OpenMesh::Decimater::ModBaseT<MeshT> {
 public:
  DECIMATING_MODULE(ModStripsT, MeshT, Strips);
  explicit ModStripsT(MeshT& mesh) : Base(mesh, true) {}

  void set(restrip::LiveMesh& live) { live_ = &live; }
  float collapse_priority(const CollapseInfo& info) override {
    const restrip::Halfedge chord = live_->edge(number(info.v1), number(info.v0));
    return restrip::check_collapse(live_->mesh(), chord) == restrip::Refusal::granted ? Base::LEGAL_COLLAPSE
                                                                                      : Base::ILLEGAL_COLLAPSE;
  }
  void preprocess_collapse(const CollapseInfo& info) override { live_->collapse(number(info.v1), number(info.v0)); }

 private:
  static std::uint32_t number(OpenMesh::VertexHandle v) { return static_cast<std::uint32_t>(v.idx()); }
  restrip::LiveMesh* live_ = nullptr;
};

Triangles triangles_of(const Mesh& mesh) {
  Triangles list;
  for (const auto face : mesh.faces()) {
    auto& t = list.emplace_back();
    std::size_t i = 0;
    for (const auto v : face.vertices()) t[i++] = static_cast<std::uint32_t>(v.idx());
  }
  return sorted(std::move(list));
}

}  // namespace

int main() {
  Mesh mesh;
  const StartMesh start = bumpy_torus();
  for (const auto& [x, y, z] : start.points) mesh.add_vertex({float(x), float(y), float(z)});
  for (const auto& [a, b, c] : start.triangles)
    mesh.add_face(Mesh::VertexHandle(int(a)), Mesh::VertexHandle(int(b)), Mesh::VertexHandle(int(c)));

  restrip::LiveMesh live(indices_of(start.triangles), mesh.n_vertices());
  OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
  OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
  ModStripsT<Mesh>::Handle strips;
  decimater.add(quadric);
  decimater.add(strips);
  decimater.module(strips).set(live);
  decimater.initialize();
  std::size_t frames = 0;
  std::size_t same = 0;
  while (decimater.decimate(100) > 0) {
    (void)live.update();
    same += drawn(live.indices()) == triangles_of(mesh) ? 1U : 0U;
    if (++frames % 5 == 0) std::printf("%zu triangles in %zu strips\n", live.mesh().triangle_count(), live.strips());
    if (live.mesh().triangle_count() < 500) break;
  }
  std::printf("%zu frames, %zu drawn as OpenMesh has them\n", frames, same);
  return same == frames ? 0 : 1;
}
