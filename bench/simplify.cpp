// bench_simplify MESH PERCENT...: simplifies a mesh to these shares of its triangles by our simplifier, meshoptimizer
// and OpenMesh's quadrics, and prints for each the distance to the mesh and the processor time, as lines of CSV
// (scripts/simplify_table.py). Each starts from a triangle list; ours and OpenMesh build their own mesh of it, and
// that is part of their time. Times are medians of repetitions that alternate between the three.
#include "restrip/search/simplify.hpp"

#include <meshoptimizer.h>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <exception>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "lod/mesh_files.hpp"
#include "surface.hpp"

namespace restrip::bench {
namespace {

constexpr std::size_t samples = 40'000;
constexpr int repetitions = 3;

struct Input {
  std::vector<Place> points;
  std::vector<float> coordinates;  // the same
  Triangles triangles;
};

Triangles by_restrip(const Input& input, std::size_t wanted) {
  Simplifier simplifier(StripMesh::build(input.triangles, input.points.size()), input.points);
  simplifier.run(wanted);
  Triangles left;
  const StripMesh& mesh = simplifier.mesh();
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.alive(t)) left.push_back(mesh.corners(t));
  return left;
}

Triangles by_meshoptimizer(const Input& input, std::size_t wanted) {
  constexpr float any_error = 1e9F;
  std::vector<std::uint32_t> indices(3 * input.triangles.size());
  const std::size_t count =
      meshopt_simplify(indices.data(), input.triangles.data()->data(), indices.size(), input.coordinates.data(),
                       input.points.size(), 3 * sizeof(float), 3 * wanted, any_error);
  Triangles left;
  for (std::size_t i = 0; i < count; i += 3) left.push_back({indices[i], indices[i + 1], indices[i + 2]});
  return left;
}

Triangles by_open_mesh(const Input& input, std::size_t wanted) {
  using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;
  Mesh mesh;
  for (std::size_t i = 0; i < input.coordinates.size(); i += 3)
    mesh.add_vertex({input.coordinates[i], input.coordinates[i + 1], input.coordinates[i + 2]});
  const auto vertex = [](std::uint32_t v) { return Mesh::VertexHandle(static_cast<int>(v)); };
  for (const auto& [a, b, c] : input.triangles) mesh.add_face(vertex(a), vertex(b), vertex(c));
  OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
  OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
  decimater.add(quadric);
  decimater.initialize();
  decimater.decimate_to_faces(0, wanted);
  Triangles left;
  for (const auto face : mesh.faces()) {  // without deleted ones
    auto& corners = left.emplace_back();
    std::size_t i = 0;
    for (auto v = mesh.cfv_begin(face); v != mesh.cfv_end(face); ++v)
      corners[i++] = static_cast<std::uint32_t>(v->idx());
  }
  return left;
}

struct Method {
  const char* name;
  Triangles (*simplify)(const Input&, std::size_t);
};
constexpr std::array methods{Method{"restrip", by_restrip}, Method{"meshoptimizer", by_meshoptimizer},
                             Method{"openmesh", by_open_mesh}};

void measure(const std::string& name, const Input& input, const Surface& whole, const std::string& percent) {
  const double share = std::stod(percent) / 100;
  const auto wanted = static_cast<std::size_t>(std::ceil(share * static_cast<double>(input.triangles.size())));
  std::array<std::vector<double>, methods.size()> seconds;
  std::array<Triangles, methods.size()> left;
  for (int i = 0; i < repetitions; ++i)
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const std::clock_t start = std::clock();
      left[m] = methods[m].simplify(input, wanted);
      seconds[m].push_back(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const std::size_t count = left[m].size();
    const Deviation found = deviation(whole, Surface(input.points, std::move(left[m])), samples);
    std::sort(seconds[m].begin(), seconds[m].end());
    std::printf("%s,%s,%s,%zu,%.2f,%.1f,%.3f,%.6f\n", name.c_str(), percent.c_str(), methods[m].name, count,
                1e5 * found.mean, 1e5 * found.largest, 100 * found.turned, seconds[m][repetitions / 2]);
    std::fflush(stdout);
  }
}

void run(const std::string& file, std::span<char* const> percents) {
  const tools::Soup soup = tools::read_mesh(tools::NamedFile(file));
  Input input;
  for (const tools::Point& p : soup.points) {
    input.points.push_back({p.x, p.y, p.z});
    for (const double x : input.points.back()) input.coordinates.push_back(static_cast<float>(x));
  }
  input.triangles.assign(soup.triangles.begin(), soup.triangles.end());
  const Surface whole(input.points, input.triangles);
  for (const char* percent : percents) measure(tools::NamedFile(file).path.stem().string(), input, whole, percent);
}

}  // namespace
}  // namespace restrip::bench

int main(int count, char** arguments) {
  if (count < 3) {
    std::fputs("usage: bench_simplify MESH PERCENT...\n", stderr);
    return 2;
  }
  omerr().disable();  // OpenMesh reports each face that it cannot add
  try {
    restrip::bench::run(arguments[1], std::span(arguments + 2, arguments + count));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_simplify: %s\n", error.what());
    return 2;
  }
  return 0;
}
