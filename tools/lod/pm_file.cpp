#include "lod/pm_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <optional>
#include <utility>
#include <vector>

#include "meshes/gltf_file.hpp"
#include "meshes/little_endian.hpp"
#include "meshes/strip_file.hpp"
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
  const auto refuse = [&name](const std::string& why) { throw BadInput(fmt::format("{}: {}", name, why)); };
  constexpr const char* remedy = "write it again from the mesh (restrip simplify)";
  if (bytes.size() < pm_header_bytes) refuse("ends inside its header; is it complete?");
  std::size_t at = pm_magic.size();
  const auto next = [&bytes, &at] { return little_endian(bytes, std::exchange(at, at + 4)); };
  const std::size_t vertices = next();
  const std::size_t faces = next();
  const std::size_t splits = next();
  const std::size_t expected = pm_header_bytes + vertices * vertex_bytes + faces * face_bytes + splits * split_bytes;
  if (bytes.size() != expected)
    refuse(fmt::format("{} vertices, {} faces and {} splits take {} bytes, but the file has {}; is it complete?",
                       vertices, faces, splits, expected, bytes.size()));
  if (faces == 0) refuse(fmt::format("its base has no triangles, so there is nothing to replay; {}", remedy));
  ProgressiveMesh mesh;
  mesh.file = name;
  mesh.points.reserve(vertices + splits);
  mesh.base.resize(faces);
  mesh.splits.reserve(splits);
  const auto add_point = [&] {
    Point p;
    for (double* coordinate : {&p.x, &p.y, &p.z}) *coordinate = std::bit_cast<float>(next());
    if (!is_finite(p))
      refuse(
          fmt::format("vertex {} has a coordinate that is infinite or not a number; {}", mesh.points.size(), remedy));
    mesh.points.push_back(p);
  };
  for (std::size_t v = 0; v < vertices; ++v) add_point();
  for (Corners& triangle : mesh.base)
    for (Vertex& corner : triangle) {
      corner = next();
      if (corner >= vertices) refuse(fmt::format("a face refers to vertex {} of {}", corner, vertices));
    }
  if (std::all_of(mesh.base.begin(), mesh.base.end(), degenerate))
    refuse(fmt::format("every triangle of its base is degenerate (a corner twice), so there is nothing to replay; {}",
                       remedy));
  for (std::size_t i = 0; i < splits; ++i) {
    const auto v_t = static_cast<Vertex>(vertices + i);
    add_point();
    const Vertex v_s = next();
    const Vertex v_r = next();
    const Vertex v_l = next();
    const auto known = [v_t](Vertex v) { return v == none || v < v_t; };
    if (v_s >= v_t || !known(v_l) || !known(v_r) || v_l == v_r)
      refuse(fmt::format("split {} refers to vertices {}, {}, {}, of which there are {}", i, v_s, v_r, v_l, v_t));
    mesh.splits.push_back({v_s, v_t, v_l, v_r});
  }
  return mesh;
}

VertexSplit possible_split(const StripMesh& now, const ProgressiveMesh& mesh, std::size_t number) {
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

std::string progressive_glb_bytes(const ProgressiveMesh& any) {
  StripMesh now = StripMesh::build(any.base, any.points.size());
  for (std::size_t i = 0; i < any.splits.size(); ++i) now.insert_vertex(possible_split(now, any, i), any.splits[i].v_t);
  const ProgressiveMesh mesh = numbered_by_appearance(any);
  const auto refuse = [&](const std::string& why) {
    throw BadInput(fmt::format("{}{}{}", any.file, any.file.empty() ? "" : ": ", why));
  };
  if (mesh.splits.empty()) refuse("has no splits; restrip simplify makes some");
  for (std::size_t i = 0; i < mesh.splits.size(); ++i)
    if (mesh.splits[i].v_l == none || mesh.splits[i].v_r == none)
      refuse(
          fmt::format("split {} is at a boundary, for which {} has no record; simplify the mesh with --boundary lock",
                      i, progressive_extension));

  // From the finest level down: when two vertices merge, the new one lies at the midpoint.
  std::vector<Point> points = mesh.points;
  std::vector<Point> moves(mesh.splits.size());
  for (std::size_t i = mesh.splits.size(); i-- > 0;) {
    Point& s = points[mesh.splits[i].v_s];
    const Point& t = points[mesh.splits[i].v_t];
    moves[i] = {(t.x - s.x) / 2, (t.y - s.y) / 2, (t.z - s.z) / 2};
    s = {(t.x + s.x) / 2, (t.y + s.y) / 2, (t.z + s.z) / 2};
  }
  points.resize(points.size() - mesh.splits.size());

  const unsigned width = mesh.points.size() < 0xFFFF ? 2 : 4;
  const unsigned type = width == 2 ? 5123 : 5125;
  const auto fill_up = [](std::string& bytes) { bytes.resize((bytes.size() + 3) / 4 * 4, '\0'); };
  std::string binary;
  for (const Point& p : points) put(binary, p);
  const std::size_t indices = binary.size();
  for (const Corners& t : mesh.base)
    for (const Vertex v : t) put(binary, v, width);
  fill_up(binary);
  const std::size_t records = binary.size();
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const Record& record = mesh.splits[i];
    for (const Vertex v : {record.v_s, record.v_l, record.v_r}) put(binary, v, width);
    fill_up(binary);
    put(binary, moves[i]);
  }
  const std::size_t stride = (binary.size() - records) / moves.size();
  const std::size_t displacement = stride - 12;  // the offset within a record
  std::string json = fmt::format(
      R"({{"asset":{{"version":"2.0","generator":"restrip"}},"extensionsUsed":["{0}"],"scene":0,"scenes":[{{"nodes":[0]}}],)"
      R"("nodes":[{{"mesh":0}}],"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1,"mode":4,)"
      R"("extensions":{{"{0}":{{"attributes":{{"POSITION":3}},"indices":2}}}}}}]}}],)",
      progressive_extension);
  json += fmt::format(R"("accessors":[{{"bufferView":0,"componentType":5126,"count":{0},"type":"VEC3",{1}}},)"
                      R"({{"bufferView":1,"componentType":{2},"count":{3},"type":"SCALAR"}},)"
                      R"({{"bufferView":2,"componentType":{2},"count":{4},"type":"VEC3"}},)"
                      R"({{"bufferView":3,"componentType":5126,"count":{4},"type":"VEC3"}}],)",
                      points.size(), bounds_of(points), type, 3 * mesh.base.size(), moves.size());
  json += fmt::format(
      R"("bufferViews":[{{"buffer":0,"byteLength":{0},"target":34962}},)"
      R"({{"buffer":0,"byteOffset":{0},"byteLength":{1},"target":34963}},)"
      R"({{"buffer":0,"byteOffset":{2},"byteLength":{3},"byteStride":{4}}},)"
      R"({{"buffer":0,"byteOffset":{5},"byteLength":{6},"byteStride":{4}}}],"buffers":[{{"byteLength":{7}}}]}})",
      indices, 3 * mesh.base.size() * width, records, binary.size() - records, stride, records + displacement,
      binary.size() - records - displacement, binary.size());
  return glb_of_chunks(std::move(json), std::move(binary));
}

std::optional<ProgressiveMesh> parse_progressive_gltf(std::string_view bytes, const std::string& name,
                                                      const ReadSibling& sibling) {
  if (bytes.find(progressive_extension) == std::string_view::npos) return std::nullopt;
  GltfFile file(bytes, name, sibling);
  // The extension, which the proposal puts in a primitive and its author's program in the mesh; and the primitive.
  std::optional<std::pair<JsonValue, JsonValue>> found;
  const JsonValue meshes = file.root()["meshes"];
  for (std::size_t m = 0; m < meshes.size(); ++m)
    for (std::size_t p = 0; p < meshes.at(m)["primitives"].size(); ++p) {
      const JsonValue primitive = meshes.at(m)["primitives"].at(p);
      for (const JsonValue& at : {primitive, meshes.at(m)}) {
        const JsonValue extension = at["extensions"][progressive_extension];
        if (!extension.there()) continue;
        if (found) extension.refuse("is the second one; a file has one progressive mesh");
        found.emplace(extension, primitive);
        break;
      }
    }
  if (!found) return std::nullopt;
  const auto& [extension, primitive] = *found;
  for (const std::string& attribute : extension["attributes"].members())
    if (attribute != "POSITION")
      extension["attributes"][attribute].refuse("is not read: splits have positions only; export without it");

  Soup drawn = read_gltf(bytes, name, sibling);
  ProgressiveMesh mesh;
  mesh.file = name;
  mesh.left_out = std::move(drawn.left_out);
  mesh.base = std::move(drawn.triangles);
  mesh.points = file.positions(primitive["attributes"]["POSITION"].whole());
  if (mesh.points != drawn.points)
    extension.refuse(
        "belongs to a mesh that nodes move, or that is not alone; export one mesh without transformations");

  const std::vector<Corners> records = file.triples(extension["indices"].whole());
  const std::vector<Point> moves = file.positions(extension["attributes"]["POSITION"].whole());
  if (moves.size() != records.size())
    extension.refuse(fmt::format("has {} records and {} displacements", records.size(), moves.size()));
  const std::size_t base_points = mesh.points.size();
  for (std::size_t i = 0; i < records.size(); ++i) {
    const auto v_t = static_cast<Vertex>(base_points + i);
    const auto [v_s, v_l, v_r] = records[i];
    if (v_s >= v_t || v_l >= v_t || v_r >= v_t || v_l == v_r)
      throw BadInput(
          fmt::format("{}: split {} refers to vertices {}, {}, {}, of which {} exist", name, i, v_s, v_l, v_r, v_t));
    mesh.splits.push_back({v_s, v_t, v_l, v_r});
    const Point s = mesh.points[v_s];
    const Point& d = moves[i];
    mesh.points[v_s] = {s.x - d.x, s.y - d.y, s.z - d.z};
    mesh.points.push_back({s.x + d.x, s.y + d.y, s.z + d.z});
  }
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    Point& p = mesh.points[v] = in_32_bits(mesh.points[v]);
    if (!is_finite(p))
      throw BadInput(fmt::format("{}: vertex {} moves to a position that is infinite or not a number", name, v));
  }
  return mesh;
}

}  // namespace restrip::tools
