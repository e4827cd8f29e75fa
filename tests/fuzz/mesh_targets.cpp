// Meshes and progressive meshes. Accepted meshes are stripified; accepted baked ones are written and read again.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <map>

#include "lod/bake.hpp"
#include "lod/baked_file.hpp"
#include "lod/coloring_check.hpp"
#include "lod/mesh_formats.hpp"
#include "lod/pm_file.hpp"
#include "lod/simplify.hpp"
#include "meshes/little_endian.hpp"
#include "meshes/mend.hpp"
#include "meshes/soup.hpp"
#include "meshes/strip_file.hpp"
#include "restrip/output/strips.hpp"
#include "target.hpp"
#include "tools/shapes.hpp"

namespace restrip::fuzz {
namespace {

using namespace tools;

void check_strips_of_file(const Soup& soup) {
  for (const std::uint32_t index : soup.strips)
    promise(index == strip_end || index < soup.points.size(), "an index of a strip is a vertex");
  std::vector<Corners> drawn;
  for (const Corners& t : soup.triangles)
    if (!degenerate(t)) drawn.push_back(rotated(t));
  std::vector<Corners> by_strips = decode_strips(soup.strips);
  for (Corners& t : by_strips) t = rotated(t);
  promise(soup.strips.empty() || by_strips == drawn, "the strips of a file draw its triangles");
  std::vector<std::uint32_t> origin;
  StripMesh mesh = StripMesh::build(soup.triangles, soup.points.size(), nullptr, &origin);
  color_as_in_file(mesh, soup, origin);
  promise(find_faults(mesh).empty(), "the strips of a file are valid");
}

/// Simplifies the mesh as the program does: with closed seams, or with vertices of seams that stay.
void check_levels(Soup soup) {
  constexpr std::size_t few = 2000;
  if (soup.triangles.size() > few) return;
  Mended mended;
  if (soup.attributes.empty()) close_seams(soup, mended);
  const std::vector<std::uint32_t> fixed = vertices_on_seams(soup);
  const ProgressiveMesh levels = simplify(soup, {0.1, BoundaryPolicy::move}).mesh;
  promise(sorted_triangles(finest_level(levels).triangles) == sorted_triangles(soup.triangles),
          "the levels lead back to the triangles");
  for (const Record& record : levels.splits)
    promise(soup.attributes.empty() || !std::binary_search(fixed.begin(), fixed.end(), record.v_t),
            "vertices on seams stay");
}

bool play(Soup soup) {
  for (const Corners& t : soup.triangles)
    for (const std::uint32_t corner : t) promise(corner < soup.points.size(), "a corner is a vertex");
  promise(find_faults(stripified(soup)).empty(), "strips from scratch are valid");
  check_levels(soup);
  if (!soup.strips.empty()) check_strips_of_file(soup);
  Mended mended;
  weld(soup, mended);
  promise(coincident_vertices(soup) == 0, "welded vertices have distinct positions");
  try {
    orient(soup, "f", mended);
    BuildReport report;
    (void)StripMesh::build(soup.triangles, soup.points.size(), &report);
    promise(report.inconsistent_edges == 0, "neighbours agree after orienting");
  } catch (const BadInput&) {
    // it has no orientation
  }
  if (!soup.strips.empty()) check_strips_of_file(soup);
  return true;
}

/// A GLB around this JSON and these bytes.
std::string glb_of(std::string json, const std::string& binary) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string glb = "glTF";
  for (const std::size_t value :
       {std::size_t{2}, 28 + json.size() + binary.size(), json.size(), std::size_t{0x4E4F534A}})
    put(glb, static_cast<std::uint32_t>(value));
  glb += json;
  put(glb, static_cast<std::uint32_t>(binary.size())), put(glb, 0x004E4942);
  return glb + binary;
}

/// Sparse positions, bytes with a stride, nodes.
std::string intricate_glb() {
  const std::string binary = std::string(48, '\0') + std::string("\1\2\0\0\0\1\2\3\xFF\3\2\1", 12) +
                             std::string("\0\0\x80\x3F\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\x3F\0\0\0\0", 24);
  return glb_of(
      R"({"asset":{"version":"2.0"},"extensionsUsed":["KHR_mesh_quantization"],"scene":0,"scenes":[{"nodes":[0]}],)"
      R"("nodes":[{"scale":[-1,2,1],"children":[1]},{"mesh":0,"rotation":[0,0,1,0],"translation":[1,2,3]}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"mode":5},{"attributes":{"POSITION":0},)"
      R"("mode":6},{"attributes":{"POSITION":2}}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":4,)"
      R"("type":"VEC3","sparse":{"count":2,"indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":2}}},)"
      R"({"bufferView":1,"byteOffset":4,"componentType":5121,"count":8,"type":"SCALAR"},{"bufferView":1,)"
      R"("componentType":5120,"normalized":true,"count":3,"type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":48},)"
      R"({"buffer":0,"byteOffset":48,"byteLength":12},{"buffer":0,"byteOffset":60,"byteLength":24}],)"
      R"("buffers":[{"byteLength":84}]})",
      binary);
}

std::string text_gltf() {
  return R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":)"
         R"([{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":36}],)"
         R"("buffers":[{"byteLength":36,"uri":"data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";
}

bool check_pm(std::string_view bytes) {
  const ProgressiveMesh mesh = parse_pm(bytes, "f");
  promise(mesh.points.size() * 12 < bytes.size(), "the vertices fit into the bytes");
  const std::size_t base_points = mesh.points.size() - mesh.splits.size();
  for (const Corners& t : mesh.base)
    for (const std::uint32_t corner : t) promise(corner < base_points, "a corner of the base is a vertex of the base");
  for (const Record& record : mesh.splits) {
    promise(record.v_s < record.v_t && record.v_t < mesh.points.size(), "the split vertex exists already");
    for (const Vertex apex : {record.v_l, record.v_r})
      promise(apex == none || apex < record.v_t, "the apex exists already");
  }
  try {
    const ProgressiveMesh again = parse_progressive_gltf(progressive_glb_bytes(mesh), "g", no_sibling).value();
    promise(again.splits.size() == mesh.splits.size(), "a progressive mesh in a GLB is read as it was");
  } catch (const BadInput&) {
    // splits that are not possible, or at a boundary
  }
  return true;
}

/// With a matching checksum, so that alterations reach the reader.
std::string sealed(std::string_view bytes) {
  std::string all(bytes.substr(0, bytes.size() - std::min<std::size_t>(bytes.size(), 8)));
  const std::uint64_t hash = fnv1a(all);
  put(all, static_cast<std::uint32_t>(hash)), put(all, static_cast<std::uint32_t>(hash >> 32));
  return all;
}

bool play_baked(std::string_view bytes) {
  const std::string again = baked_bytes(parse_baked(sealed(bytes), "f"));
  promise(baked_bytes(parse_baked(again, "g")) == again, "a baked mesh that was written is read");
  return true;
}

bool play_baked_gltf(std::string_view bytes) {
  const std::optional<BakedBytes> found = parse_baked_gltf(bytes, "f", no_sibling);
  if (!found) return false;
  const std::string again = baked_glb_bytes(found->bytes, {StripForm::lengths}).bytes;
  promise(parse_baked_gltf(again, "g", no_sibling)->bytes == found->bytes, "a baked mesh in a GLB is read as it was");
  return true;
}

/// Hoppe's format: a tetrahedron, and two splits of it.
std::string hoppe_pm() {
  std::string bytes =
      "# by hand\nPM\nversion=2\nnvsplits=2 nvertices=6 nwedges=4 nfaces=8\nbbox 0 0 0  1 1 1\nhas_rgb=0\nhas_uv=0\n"
      "has_resid=0\nPM base mesh:\nnmaterials=1\nmatid=0\nnvertices=4 nwedges=4 nfaces=4\n";
  const auto put = [&bytes](unsigned width, std::initializer_list<std::uint32_t> values) {
    for (const std::uint32_t value : values)
      for (unsigned i = width; i-- > 0;) bytes.push_back(static_cast<char>(value >> (8 * i) & 0xFFU));
  };
  constexpr std::uint32_t one = 0x3F800000;
  put(4, {0, 0, 0, one, 0, 0, 0, one, 0, 0, 0, one});
  for (std::uint32_t v = 0; v < 4; ++v) put(4, {v, one, 0, 0});
  for (const Corners& face : {Corners{0, 2, 1}, Corners{0, 1, 3}, Corners{1, 2, 3}, Corners{2, 0, 3}}) {
    put(4, {face[0], face[1], face[2]});
    put(2, {0});
  }
  constexpr std::uint32_t all_the_same = 0x3F8;
  for (const auto& [face, corner] : {std::pair{0U, 0U}, std::pair{4U, 1U}}) {
    put(4, {face});
    put(2, {2, all_the_same | corner});
    put(4, {one, one, 0, 0, 0, 0, 0, 0, 0});
  }
  return bytes + "\xFF" + "End of PM\n";
}

std::string big_endian_ply() {
  return "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty double x\nproperty float y\nproperty short z\n"
         "element face 1\nproperty list uint ushort vertex_index\nproperty uchar flag\nend_header\n" +
         std::string(42, '\0') + std::string("\0\0\0\3\0\0\0\1\0\2x", 11);
}

Soup textured_sheet() {
  Soup shape = sheet(2);
  shape.attributes = {{"NORMAL"},
                      {"TEXCOORD_0", ComponentType::unsigned_short, 2, true},
                      {"COLOR_0", ComponentType::unsigned_byte, 4, true}};
  for (std::size_t v = 0; v < shape.points.size(); ++v) {
    shape.attributes[0].append({0, 0, 1, 0});
    shape.attributes[1].append({static_cast<double>(v), 65535, 0, 0});
    shape.attributes[2].append({static_cast<double>(v), 255, 0, 7});
  }
  return shape;
}

std::string written_in(const MeshFormat& format, const Soup& shape, StripForm form) {
  return written_strips(format, shape.points, strip_indices(stripified(shape)), {form}, shape.attributes).bytes;
}

bool play_format(const MeshFormat& format, std::string_view bytes) {
  const auto read = [](const MeshFormat& by, std::string_view text) {
    return finest_level(by.read(text, "f", no_sibling, ReadAttributes::yes));
  };
  constexpr auto usual = MeshFormat::Attributes::usual;
  Soup found = read(format, bytes);
  for (const MeshFormat& other : mesh_formats()) {
    if (format.attributes != usual || other.attributes != usual) continue;
    const Soup again = read(other, other.write_mesh(found));
    promise(again.attributes.size() == found.attributes.size() && again.left_out.empty(),
            "attributes that are written are read");
    for (const Attribute& attribute : again.attributes)
      promise(attribute.bytes.size() == again.points.size() * attribute.value_bytes(), "each point has a value");
  }
  return play(std::move(found));
}

}  // namespace

std::vector<Target> mesh_targets() {
  const Soup textured = textured_sheet();
  const ProgressiveMesh moved = simplify(sheet(3), {0.2, BoundaryPolicy::move}).mesh;
  const ProgressiveMesh locked = simplify(sheet(4), {0.5, BoundaryPolicy::lock}).mesh;
  std::vector<std::string> pms{pm_bytes(moved), pm_bytes(locked), hoppe_pm()};
  BakedMesh loaded = bake(locked, {});
  loaded.payload = {2, std::vector<std::byte>(2 * locked.splits.size(), std::byte{7})};
  std::vector<std::string> bakeds{baked_bytes(bake(moved, {})), baked_bytes(bake(locked, {})), baked_bytes(loaded)};
  std::string binary_stl(84 + 50, '\0');
  binary_stl[80] = 1;
  const float one = 1;  // of the second corner x, of the third y
  std::memcpy(binary_stl.data() + 84 + 24, &one, sizeof one);
  std::memcpy(binary_stl.data() + 84 + 40, &one, sizeof one);
  // Files that no program of ours writes. A format that has only a reader needs one here.
  std::map<std::string_view, std::vector<std::string>> by_hand{
      {".obj",
       {"# c\nv 0 0 0\nv 1 0 0\nv 0 1 0 1.0\nv 1 1 0.5e-1\nvt 0 1\nvt 1 1\nvn 0 0 1\nvn 0 1 0\nvn 1 0 0\nf 1/2/3 2//1 "
        "\\\n3\nf -1 -2 -3\nf 1 2 3 4\nl 1 2\n",
        "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nv 1 1 0\ng a\ng b\nf 1 2 3 4 5\nf 1 6 3 4 5 2\nf 1 1 2 3 4 4 "
        "5\np 1\n",
        "v 0 0 0 1 0 0.5\nv 1 0 0 1 1 1\nv 0 1 0 0 0 0\nvt 0 1\nvt .5\nvn 0 0 1\nf 1/1/1 2/-1/-1 3/1/1\nf 2/1/1 1/1/1 "
        "3/2/1\n"}},
      {".off",
       {"COFF # c\n4 2 0\n0 0 0 1 1 1 1\n1 0 0\n0 1 0\n\n1 1 0.5\n3 0 1 2 9\n4 0 1 3 2\n",
        "STN4nOFF 3 3 1 0 0 0 0 1 0 0 1 0 0 1 0 0 1 0 0 1 1 0 0 1 0 1 0 0 1 0 1 3 0 1 2"}},
      {".ply",
       {big_endian_ply(),
        "ply\nformat ascii 1.0\ncomment c\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element edge 1\nproperty int a\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 "
        "0 0\n0 1 0\n7\n3 0 1 2\n",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty "
        "double u\nproperty double v\nproperty ushort diffuse_red\nproperty ushort diffuse_green\nproperty ushort "
        "diffuse_blue\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 0 1 9 9 9\n1 0 0 1 1 "
        "0 0 65535\n0 1 0 .5 0 1 2 3\n3 0 1 2\n"}},
      {".stl",
       {binary_stl,
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
        "endsolid\n",
        "solid a facet normal 0 0 1 colour 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet "
        "endsolid a"}},
      {".gltf",
       {written_in(*format_named(".glb"), textured, StripForm::restart),
        written_in(*format_named(".glb"), textured, StripForm::lengths),
        written_in(*format_named(".glb"), textured, StripForm::stitched),
        written_in(*format_named(".glb"), textured, StripForm::list), intricate_glb(), text_gltf()}}};
  std::vector<Target> targets{
      {"pm", pms, refusing(check_pm), 10000},
      {"baked", bakeds, refusing(play_baked), 2000},
      {"baked-gltf",
       {baked_glb_bytes(bakeds[0], {StripForm::lengths}).bytes, baked_glb_bytes(bakeds[1], {StripForm::restart}).bytes,
        baked_glb_bytes(bakeds[2], {StripForm::list}).bytes},
       refusing(play_baked_gltf),
       2000}};
  // Every other format that is read, by its row.
  for (const MeshFormat& format : mesh_formats()) {
    const std::string name(format.extension.substr(1));
    const bool is_known = std::any_of(targets.begin(), targets.end(), [&](const Target& t) { return t.name == name; });
    if (!reads(format) || is_known || name == "glb") continue;  // .glb has the reader of .gltf
    std::vector<std::string> seeds = std::move(by_hand[format.extension]);
    for (const Soup& mesh : {sheet(2), textured})
      if (writes_mesh(format)) seeds.push_back(format.write_mesh(mesh));
    if (format.holds_strips) seeds.push_back(written_in(format, sheet(2), format.usual_form));
    targets.push_back({name, std::move(seeds),
                       refusing([&format](std::string_view bytes) { return play_format(format, bytes); }), 10000});
  }
  return targets;
}

}  // namespace restrip::fuzz
