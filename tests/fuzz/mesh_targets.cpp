// Meshes and progressive meshes. Of an accepted mesh strips are made; an accepted baked one is written and read again.
#include <fmt/format.h>

#include "common/bad_input.hpp"
#include "lod/bake.hpp"
#include "lod/baked_file.hpp"
#include "lod/coloring_check.hpp"
#include "lod/pm_file.hpp"
#include "lod/simplify.hpp"
#include "meshes/mesh_file.hpp"
#include "meshes/strip_file.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "target.hpp"
#include "tools/shapes.hpp"

namespace restrip::fuzz {
namespace {

using namespace tools;

bool play(const Soup& soup) {
  for (const Corners& t : soup.triangles)
    for (const std::uint32_t corner : t) promise(corner < soup.points.size(), "a corner is a vertex");
  StripMesh mesh = StripMesh::build(soup.triangles, soup.points.size());
  stripify(mesh);
  promise(find_faults(mesh).empty(), "strips from scratch are valid");
  return true;
}

template <class Read>
std::function<bool(std::string_view)> refusing(Read&& read) {
  return [read](std::string_view bytes) {
    try {
      return read(bytes);
    } catch (const BadInput&) {
      return false;
    }
  };
}

bool check_pm(std::string_view bytes) {
  const ProgressiveMesh mesh = parse_pm(bytes, "f");
  promise(mesh.points.size() * 12 < bytes.size(), "there are no more vertices than bytes for them");
  const std::size_t base_points = mesh.points.size() - mesh.splits.size();
  for (const Corners& t : mesh.base)
    for (const std::uint32_t corner : t) promise(corner < base_points, "a corner of the base is a vertex of the base");
  for (const Record& record : mesh.splits) {
    promise(record.v_s < record.v_t && record.v_t < mesh.points.size(), "a vertex is split that is there already");
    for (const Vertex apex : {record.v_l, record.v_r})
      promise(apex == none || apex < record.v_t, "an apex is there already");
  }
  return true;
}

/// With the checksum that the other bytes ask for, so that alterations reach the reader.
std::string sealed(std::string_view bytes) {
  std::string all(bytes.substr(0, bytes.size() - std::min<std::size_t>(bytes.size(), 8)));
  const std::uint64_t hash = fnv1a(all);
  for (unsigned i = 0; i < 8; ++i) all.push_back(static_cast<char>(hash >> (8 * i) & 0xFFU));
  return all;
}

bool play_baked(std::string_view bytes) {
  const std::string again = baked_bytes(parse_baked(sealed(bytes), "f"));
  promise(baked_bytes(parse_baked(again, "g")) == again, "a baked mesh that was written is read");
  return true;
}

std::string big_endian_ply() {
  return "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty double x\nproperty float y\nproperty short z\n"
         "element face 1\nproperty list uint ushort vertex_index\nproperty uchar flag\nend_header\n" +
         std::string(42, '\0') + std::string("\0\0\0\3\0\0\0\1\0\2x", 11);
}

std::string ply_of_strips() {
  const Soup shape = sheet(2);
  StripMesh mesh = StripMesh::build(shape.triangles, shape.points.size());
  stripify(mesh);
  const std::vector<std::uint32_t> indices = strip_indices(mesh);
  return strip_bytes({shape.points, indices, shape.triangles}, ".ply");
}

}  // namespace

std::vector<Target> mesh_targets() {
  const Soup shape = sheet(2);
  const ProgressiveMesh moved = simplify(sheet(3), {0.2, BoundaryPolicy::move}).mesh;
  const ProgressiveMesh locked = simplify(sheet(4), {0.5, BoundaryPolicy::lock}).mesh;
  std::vector<std::string> pms{pm_bytes(moved), pm_bytes(locked)};
  BakedMesh loaded = bake(locked, {});
  loaded.payload = {2, std::vector<std::byte>(2 * locked.splits.size(), std::byte{7})};
  std::vector<std::string> bakeds{baked_bytes(bake(moved, {})), baked_bytes(bake(locked, {})), baked_bytes(loaded)};
  std::string binary_stl(84 + 50, '\0');
  binary_stl[80] = 1;
  const auto soup = [](auto read) {
    return refusing([read](std::string_view bytes) { return play(read(bytes, "f")); });
  };
  return {
      {"obj",
       {mesh_bytes(shape, ".obj"),
        "# c\nv 0 0 0\nv 1 0 0\nv 0 1 0 1.0\nv 1 1 0.5e-1\nvt 0 1\nf 1/2/3 2//1 \\\n3\nf -1 -2 -3\nf 1 2 3 4\nl 1 2\n"},
       soup(read_obj),
       10000},
      {"off",
       {mesh_bytes(shape, ".off"), "COFF # c\n4 2 0\n0 0 0 1 1 1 1\n1 0 0\n0 1 0\n\n1 1 0.5\n3 0 1 2 9\n4 0 1 3 2\n"},
       soup(read_off),
       10000},
      {"ply",
       {mesh_bytes(shape, ".ply"), big_endian_ply(),
        "ply\nformat ascii 1.0\ncomment c\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element edge 1\nproperty int a\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 "
        "0 0\n0 1 0\n7\n3 0 1 2\n",
        ply_of_strips()},
       soup(read_ply),
       10000},
      {"stl",
       {binary_stl,
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
        "endsolid\n"},
       soup(read_stl),
       10000},
      {"pm", pms, refusing(check_pm), 10000},
      {"baked", bakeds, refusing(play_baked), 2000},
  };
}

}  // namespace restrip::fuzz
