#include "lod/pm_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "common/bad_input.hpp"
#include "meshes/little_endian.hpp"
#include "restrip/mesh/checks.hpp"

namespace restrip::tools {
namespace {

constexpr std::string_view pm_magic = "ProgMesh";
constexpr std::size_t pm_header_bytes = 20;
constexpr std::size_t vertex_bytes = 12;
constexpr std::size_t face_bytes = 12;
constexpr std::size_t split_bytes = 24;

}  // namespace

ProgressiveMesh parse_pm(std::string_view bytes, const std::string& name) {
  if (is_hoppe_pm(bytes)) return parse_hoppe_pm(bytes, name);
  if (!bytes.starts_with(pm_magic))
    throw BadInput(
        fmt::format("{}: not a progressive mesh: it begins neither with '{}', as OpenMesh's do, nor with PM, as "
                    "Hoppe's do",
                    name, pm_magic));
  if (bytes.size() < pm_header_bytes) throw BadInput(fmt::format("{}: ends inside its header; is it complete?", name));
  std::size_t at = pm_magic.size();
  const auto next = [&bytes, &at] { return little_endian(bytes, std::exchange(at, at + 4)); };
  const std::size_t vertices = next();
  const std::size_t faces = next();
  const std::size_t splits = next();
  const std::size_t expected = pm_header_bytes + vertices * vertex_bytes + faces * face_bytes + splits * split_bytes;
  if (bytes.size() != expected)
    throw BadInput(
        fmt::format("{}: {} vertices, {} faces and {} splits take {} bytes, but the file has {}; is it complete?", name,
                    vertices, faces, splits, expected, bytes.size()));

  if (faces == 0)
    throw BadInput(
        fmt::format("{}: its base has no triangles, so there is nothing to replay; write it again from the "
                    "mesh (restrip simplify)",
                    name));
  ProgressiveMesh mesh;
  mesh.file = name;
  mesh.points.reserve(vertices + splits);
  mesh.base.resize(faces);
  mesh.splits.reserve(splits);
  const auto add_point = [&] {
    Point p;
    for (double* coordinate : {&p.x, &p.y, &p.z}) *coordinate = std::bit_cast<float>(next());
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      throw BadInput(
          fmt::format("{}: vertex {} has a coordinate that is infinite or not a number; write it again from the mesh "
                      "(restrip simplify)",
                      name, mesh.points.size()));
    mesh.points.push_back(p);
  };
  for (std::size_t v = 0; v < vertices; ++v) add_point();
  for (Corners& triangle : mesh.base)
    for (Vertex& corner : triangle) {
      corner = next();
      if (corner >= vertices)
        throw BadInput(fmt::format("{}: a face refers to vertex {} of {}", name, corner, vertices));
    }
  if (std::all_of(mesh.base.begin(), mesh.base.end(), degenerate))
    throw BadInput(
        fmt::format("{}: every triangle of its base is degenerate (a corner twice), so there is nothing to "
                    "replay; write it again from the mesh (restrip simplify)",
                    name));
  for (std::size_t i = 0; i < splits; ++i) {
    const auto v_t = static_cast<Vertex>(vertices + i);
    add_point();
    const Vertex v_s = next();
    const Vertex v_r = next();
    const Vertex v_l = next();
    const auto known = [v_t](Vertex v) { return v == none || v < v_t; };
    if (v_s >= v_t || !known(v_l) || !known(v_r) || v_l == v_r)
      throw BadInput(fmt::format("{}: split {} refers to vertices {}, {}, {}, of which there are {}", name, i, v_s, v_r,
                                 v_l, v_t));
    mesh.splits.push_back({v_s, v_t, v_l, v_r});
  }
  return mesh;
}

VertexSplit<StripMesh::Halfedge> possible_split(const StripMesh& now, const ProgressiveMesh& mesh, std::size_t number) {
  const Record& record = mesh.splits[number];
  const auto where = spokes_of(now, record);
  if (const Refusal refusal = check_split(now, where, record.v_t); refusal != Refusal::granted)
    throw BadInput(fmt::format("{}{}split {} ({} -> {}) is not possible: {}; make the file again with restrip simplify",
                               mesh.file, mesh.file.empty() ? "" : ": ", number, record.v_s, record.v_t,
                               describe(refusal)));
  return where;
}

ProgressiveMesh numbered_by_appearance(const ProgressiveMesh& mesh) {
  ProgressiveMesh out;
  std::vector<Vertex> number(mesh.points.size(), none);
  const auto appear = [&](Vertex v) {
    number[v] = static_cast<Vertex>(out.points.size());
    out.points.push_back(mesh.points[v]);
  };
  const auto number_of = [&](Vertex v) { return v == none ? none : number[v]; };
  out.base.reserve(mesh.base.size());
  for (const Corners& triangle : mesh.base) {
    for (const Vertex v : triangle)
      if (number[v] == none) appear(v);
    out.base.push_back({number[triangle[0]], number[triangle[1]], number[triangle[2]]});
  }
  out.splits.reserve(mesh.splits.size());
  for (const Record& r : mesh.splits) {
    appear(r.v_t);
    out.splits.push_back({number_of(r.v_s), number_of(r.v_t), number_of(r.v_l), number_of(r.v_r)});
  }
  return out;
}

std::string pm_bytes(const ProgressiveMesh& any) {
  const ProgressiveMesh mesh = numbered_by_appearance(any);
  std::string bytes(pm_magic);
  const std::size_t base_points = mesh.points.size() - mesh.splits.size();
  put(bytes, static_cast<std::uint32_t>(base_points));
  put(bytes, static_cast<std::uint32_t>(mesh.base.size()));
  put(bytes, static_cast<std::uint32_t>(mesh.splits.size()));
  for (std::size_t v = 0; v < base_points; ++v) put(bytes, mesh.points[v]);
  for (const Corners& triangle : mesh.base)
    for (const Vertex v : triangle) put(bytes, v);
  for (const Record& record : mesh.splits) {
    put(bytes, mesh.points[record.v_t]);
    put(bytes, record.v_s);
    put(bytes, record.v_r);
    put(bytes, record.v_l);
  }
  return bytes;
}

}  // namespace restrip::tools
