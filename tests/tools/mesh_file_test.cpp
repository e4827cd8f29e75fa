// Claims: a mesh file arrives triangle by triangle as it is, in every format; and what cannot be read is refused with a
// sentence that names the file and the fault.
#include "meshes/mesh_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <fstream>

#include "common/bad_input.hpp"
#include "files/output.hpp"
#include "files/reading.hpp"
#include "lod/mesh_files.hpp"
#include "meshes/made_mesh.hpp"
#include "scratch_folder.hpp"
#include "shapes.hpp"

namespace restrip::tools {
namespace {

using Reader = Soup (*)(std::string_view, const std::string&);

Soup bare_obj(std::string_view bytes, const std::string& name) { return read_obj(bytes, name); }
Soup bare_ply(std::string_view bytes, const std::string& name) { return read_ply(bytes, name); }
Soup full_obj(std::string_view bytes, const std::string& name) { return read_obj(bytes, name, ReadAttributes::yes); }
Soup full_ply(std::string_view bytes, const std::string& name) { return read_ply(bytes, name, ReadAttributes::yes); }

std::string refusal(Reader read, std::string_view bytes) {
  try {
    (void)read(bytes, "some.file");
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

void expect_refused(Reader read, std::string_view bytes, const std::string& because) {
  const std::string text = refusal(read, bytes);
  EXPECT_TRUE(text.starts_with("some.file:")) << "for: " << bytes << "\nsaid: " << text;
  EXPECT_NE(text.find(because), std::string::npos) << "for: " << bytes << "\nsaid: " << text;
}

TEST(Obj, CornersWithTextureAndNormalIndices) {
  const Soup soup = read_obj(
      "# c\nv 0 0 0\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1 2 3\nf 1/1 2/1 3/1\nf 1//1 2//1 3//1\nf 1/1/1 "
      "2/1/1 3/1/1\n",
      "f");
  EXPECT_EQ(soup.points.size(), 3U);
  EXPECT_EQ(soup.triangles, std::vector<Corners>(4, Corners{0, 1, 2}));
}

TEST(Obj, NegativeCornersCountFromTheVerticesBefore) {
  const Soup soup = read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 1\nf -4 -3 -1\n", "f");
  EXPECT_EQ(soup.triangles, (std::vector<Corners>{{0, 1, 2}, {0, 1, 3}}));
}

TEST(Obj, PolygonsBecomeFansAndAreCounted) {
  const Soup soup = read_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 1 2\n", "f");
  EXPECT_EQ(soup.triangles, (std::vector<Corners>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(soup.polygons, 1U);
  EXPECT_EQ(soup.stubs, 1U);
}

TEST(Obj, DegenerateAndDuplicateFacesArrive) {
  const Soup soup = read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 1 2\nf 1 2 3\nf 1 2 3\n", "f");
  EXPECT_EQ(soup.triangles, (std::vector<Corners>{{0, 0, 1}, {0, 1, 2}, {0, 1, 2}}));
}

TEST(Obj, LinesMayEndInAnyWayAndGoOn) {
  const Soup soup = read_obj("v 0 0 0\r\nv 1 0 0\r\nv 0 1 \\\n 0\r\nf 1 \\\r\n 2 3", "f");
  EXPECT_EQ(soup.triangles, (std::vector<Corners>{{0, 1, 2}}));
}

TEST(Obj, Refusals) {
  expect_refused(bare_obj, "", "no vertices");
  expect_refused(bare_obj, "v 0 0 0\nv 1 0 0\n", "no triangles");
  expect_refused(bare_obj, "v 0 0 0\nv 1 0\n", ":2: a vertex needs three numbers");
  expect_refused(bare_obj, "v 0 0 nan\n", "infinite or not a number");
  expect_refused(bare_obj, "v 0 0 1e300\n", "infinite or not a number");
  expect_refused(bare_obj, "v 0 0 0\nf 0 1 1\n", "counted from 1");
  expect_refused(bare_obj, "v 0 0 0\nf -2 1 1\n", "is no vertex");
  expect_refused(bare_obj, "v 0 0 0\nf 1 1 x\n", "is no vertex");
  expect_refused(bare_obj, "v 0 0 0\nf 1 1 2\n", "refers to vertex 1 (counted from 0), but there are 1");
  expect_refused(bare_obj, "v 0 0 0\nf 1 1 99999999999999999999\n", "is no vertex");
}

TEST(Obj, RefusalsOfAttributes) {
  const std::string two = "v 0 0 0\nv 1 0 0\n";
  expect_refused(full_obj, two + "f 1 2 3\n", "refers to vertex 2 (counted from 0), but there are 2");
  // What comes behind as another vertex is no vertex of the file.
  expect_refused(full_obj, two + "vt 0 0\nvt 1 1\nf 1/1 1/2 2/1\nf 3/1 1/2 2/2\n", "refers to vertex 2");
  expect_refused(full_obj, two + "vt 0\nf 1/1 2/2 1/1\n", "refers to `vt` 2 (counted from 1), but there are 1");
  expect_refused(full_obj, two + "vn 0 0 1\nf 1//1 2//3 1//1\n", "refers to `vn` 3 (counted from 1), but there are 1");
  expect_refused(full_obj, two + "vn 0 1\n", ":3: a `vn` of 2 numbers needs 3");
  expect_refused(full_obj, two + "vt\n", ":3: a `vt` of 0 numbers needs 1");
  expect_refused(full_obj, two + "vn 0 nan 1\n", ":3: 'nan' is no number that is finite");
  expect_refused(full_obj, two + "vt 0 x\n", ":3: 'x' is no number that is finite");
  expect_refused(full_obj, "v 0 0 0 1 1 1e99\n", ":1: '1e99' is no number that is finite");
  expect_refused(full_obj, two + "vt 0 0\nf 1/0 2/1 1/1\n", "'1/0' is no vertex");
  expect_refused(full_obj, two + "vt 0 0\nf 1/-2 2/1 1/1\n", "'1/-2' is no vertex");
  expect_refused(full_obj, two + "vn 0 0 1\nf 1//z 2/1 1/1\n", "'1//z' is no vertex");
}

TEST(Off, CommentsAndColoursAreSteppedOver) {
  const Soup soup = read_off(
      "# made by hand\n\nCOFF # colours\n3 1 0\n\n0 0 0 255 0 0\n1 0 0 255 0 0\n# here too\n0 1 0 255 0 0\n3 0 1 2 1 0 "
      "0\n",
      "f");
  EXPECT_EQ(soup.points.size(), 3U);
  EXPECT_EQ(soup.triangles, (std::vector<Corners>{{0, 1, 2}}));
}

TEST(Off, CountsMayFollowTheKeyword) {
  EXPECT_EQ(read_off("OFF 3 1 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "f").triangles.size(), 1U);
}

TEST(Off, Refusals) {
  expect_refused(read_off, "", "does not begin with OFF");
  expect_refused(read_off, "4OFF\n", "does not begin with OFF");
  expect_refused(read_off, "OFF BINARY\n", "binary OFF");
  expect_refused(read_off, "OFF\n3\n", "the file ends");
  expect_refused(read_off, "OFF\n4000000000 1 0\n", "more than its");
  expect_refused(read_off, "OFF\n3 4000000000 0\n0 0 0\n1 0 0\n0 1 0\n", "more than its");
  expect_refused(read_off, "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "the file ends");
  expect_refused(read_off, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n", "expected a corner");
  expect_refused(read_off, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 x\n3 0 1 2\n", ":5: expected a coordinate, found 'x'");
  expect_refused(read_off, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "refers to vertex 3");
  expect_refused(read_off, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "expected a corner");
}

constexpr std::string_view ply_text =
    "ply\nformat ascii 1.0\ncomment c\nelement vertex 3\nproperty float x\nproperty float y\nproperty uchar "
    "red\nproperty double z\n"
    "element face 1\nproperty uchar flags\nproperty list uchar int vertex_index\nend_header\n0 0 9 0\n1 0 9 0\n0 1 9 "
    "0\n7 3 0 1 2\n";

TEST(Ply, TextWithOtherProperties) {
  const Soup soup = read_ply(ply_text, "f");
  EXPECT_EQ(soup.points, (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(soup.triangles, (std::vector<Corners>{{0, 1, 2}}));
}

TEST(Ply, AttributesOfSomeVerticesAreLeftOut) {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string colors = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  const std::string rest =
      "element vertex 1\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int "
      "vertex_index\nend_header\n0 0 9 1 2 3\n1 0 9 1 2 3\n0 1 9\n3 0 1 2\n";
  const Soup soup = full_ply(header + colors + rest, "f");
  EXPECT_EQ(soup.points.size(), 3U);
  EXPECT_TRUE(soup.attributes.empty());
  EXPECT_EQ(soup.left_out_attributes, std::vector<std::string>{"COLOR_0"});
  expect_refused(full_ply, header + colors + "end_header\n0 0 9 1 2 3\n1 0 9 1 2 256\n",
                 "vertex 1 has a colour 256, which is none of 0 to 255");
}

std::string ply_binary(bool big) {
  std::string bytes = fmt::format(
      "ply\nformat binary_{}_endian 1.0\nelement material 1\nproperty list uchar short ids\nelement vertex 3\nproperty "
      "float x\n"
      "property float y\nproperty float z\nelement face 1\nproperty list uchar uint vertex_indices\nend_header\n",
      big ? "big" : "little");
  const auto put = [&](std::uint32_t value, unsigned size) {
    for (unsigned i = 0; i < size; ++i)
      bytes.push_back(static_cast<char>(value >> (8 * (big ? size - 1 - i : i)) & 0xFFU));
  };
  put(2, 1), put(0xFFFF, 2), put(1, 2);
  for (const float value : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, -2.5F}) put(std::bit_cast<std::uint32_t>(value), 4);
  put(3, 1), put(0, 4), put(1, 4), put(2, 4);
  return bytes;
}

TEST(Ply, BothByteOrders) {
  for (const bool big : {false, true}) {
    const Soup soup = read_ply(ply_binary(big), "f");
    EXPECT_EQ(soup.points, (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, -2.5F}}));
    EXPECT_EQ(soup.triangles, (std::vector<Corners>{{0, 1, 2}}));
  }
}

TEST(Ply, EveryPrefixIsRefused) {
  for (const bool big : {false, true}) {
    const std::string whole = ply_binary(big);
    for (std::size_t size = 0; size < whole.size(); ++size)
      EXPECT_NE(refusal(bare_ply, std::string_view(whole).substr(0, size)), "") << size;
  }
}

TEST(Ply, Refusals) {
  const auto with = [](std::string_view what, std::string_view instead) {
    std::string text(ply_text);
    return text.replace(text.find(what), what.size(), instead);
  };
  expect_refused(bare_ply, "", "does not begin with `ply`");
  expect_refused(bare_ply, "ply\nformat ascii 1.0\n", "ends before `end_header`");
  expect_refused(bare_ply, "ply\nend_header\n", "no `format` line");
  expect_refused(bare_ply, with("ascii", "ebcdic"), ":2: unknown format");
  expect_refused(bare_ply, with("element vertex 3", "element vertex 3000000000"), "more than its remaining");
  expect_refused(bare_ply, with("element vertex 3", "element vertex many"), "without a count");
  expect_refused(bare_ply, with("double z", "quad z"), "unknown type 'quad'");
  expect_refused(bare_ply, with("double z", "double w"), "no property `z`");
  expect_refused(bare_ply, with("list uchar", "list float"), "must be an integer");
  expect_refused(bare_ply, with("7 3 0 1 2", "7 3000 0 1 2"), "a list `vertex_index` of length 3000");
  expect_refused(bare_ply, with("7 3 0 1 2", "7 3 0 1 -2"), "which is no vertex");
  expect_refused(bare_ply, with("7 3 0 1 2", "7 3 0 1 5"), "refers to vertex 5");
  expect_refused(bare_ply, with("7 3 0 1 2", "7 3 0 1"), "ends among the faces");
  expect_refused(bare_ply, with("comment c", "commend c"), "unknown keyword");
}

// A turn the other way is a repeated index; what draws nothing is no triangle.
TEST(Ply, StripsAreTheTrianglesThatTheyDraw) {
  const auto with = [](std::string_view lists) {
    return fmt::format(
        "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
        "element tristrips {}\nproperty uchar material\nproperty list int int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n{}",
        std::count(lists.begin(), lists.end(), '\n'), lists);
  };
  const auto triangles = [&](std::string_view lists) { return read_ply(with(lists), "f").triangles; };
  EXPECT_EQ(triangles("9 4 0 1 2 3\n"), (std::vector<Corners>{{0, 1, 2}, {2, 1, 3}}));
  EXPECT_EQ(triangles("9 5 0 1 2 1 3\n"), (std::vector<Corners>{{0, 1, 2}, {2, 1, 3}})) << "a swap";
  EXPECT_EQ(triangles("9 8 0 1 2 -1 2 1 3 -1\n9 2 0 1\n9 3 2 3 4\n"),
            (std::vector<Corners>{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}}));
  const auto strips = [&](std::string_view lists) { return read_ply(with(lists), "f").strips; };
  EXPECT_EQ(strips("9 8 0 1 2 -1 2 1 3 -1\n9 2 0 1\n9 3 2 3 4\n"),
            (std::vector<std::uint32_t>{0, 1, 2, strip_end, 2, 1, 3, strip_end, 2, 3, 4}));
  EXPECT_EQ(strips("9 5 0 1 2 1 3\n"), (std::vector<std::uint32_t>{0, 1, 2, 1, 3}));
  expect_refused(bare_ply, with("9 5 0 1 2 2 6\n"), "refers to vertex 6");
  expect_refused(bare_ply, with("9 3 0 1 6\n"), "refers to vertex 6");
  expect_refused(bare_ply, with("9 3 0 1 -2\n"), "strip list 0 has a corner -2, which is no vertex");
  expect_refused(bare_ply, with("9 3 0 1\n"), "ends among the strips");
  expect_refused(bare_ply, with("9 2 0 1\n"), "no triangles");
}

std::string stl_binary(const Soup& soup) {
  std::string bytes(80, ' ');
  bytes.replace(0, 5, "solid");  // as many programs write it, although it is not text
  const auto put = [&](std::uint32_t value) {
    for (unsigned i = 0; i < 4; ++i) bytes.push_back(static_cast<char>(value >> (8 * i) & 0xFFU));
  };
  put(static_cast<std::uint32_t>(soup.triangles.size()));
  for (const Corners& t : soup.triangles) {
    for (unsigned i = 0; i < 3; ++i) put(0);
    for (const std::uint32_t v : t)
      for (const float x : {soup.points[v].x, soup.points[v].y, soup.points[v].z}) put(std::bit_cast<std::uint32_t>(x));
    bytes += std::string(2, '\0');
  }
  return bytes;
}

TEST(Stl, CornersAtOnePlaceBecomeOneVertex) {
  const Soup soup = read_stl(stl_binary(tetrahedron()), "f");
  EXPECT_EQ(soup.points.size(), 4U);
  EXPECT_EQ(soup.triangles.size(), 4U);
  const Soup text = read_stl(
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex -0 1e0 0\nendloop\nendfacet\n"
      "facet normal 0 0 1\nouter loop\nvertex 0 1 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\nendfacet\nendsolid a\n",
      "f");
  EXPECT_EQ(text.points.size(), 4U);
  EXPECT_EQ(text.triangles, (std::vector<Corners>{{0, 1, 2}, {2, 1, 3}}));
}

TEST(Stl, Refusals) {
  const std::string whole = stl_binary(tetrahedron());
  expect_refused(read_stl, "", "is it complete?");
  expect_refused(read_stl, std::string_view(whole).substr(5, 60), "is it complete?");
  expect_refused(read_stl, whole.substr(0, whole.size() - 1), "");
  expect_refused(read_stl, std::string(79, '\n') + "x", "is it complete?");
  expect_refused(read_stl, "solid a\nfacet\nouter loop\nvertex 0 0 0\nendloop\nendfacet\n",
                 ":6: a facet whose number of vertices is not three");
  expect_refused(read_stl, "solid a\nfacet\nouter loop\nvertex 0 0 0\n", "ends inside a facet");
  expect_refused(read_stl, "solid a\nfacet\nouter loop\nvertex 0 0\n", "three numbers");
}

using InFolder = ScratchFolder;

TEST_F(InFolder, WhatIsWrittenIsRead) {
  const Soup soup = make_mesh(1000);
  for (const char* name : {"a.obj", "a.off", "a.ply", "A.OBJ"}) {
    files::Output(folder_ / name).write(mesh_bytes(soup, files::extension_of(name)));
    const Soup again = read_mesh(folder_ / name);
    EXPECT_EQ(again.points, soup.points) << name;
    EXPECT_EQ(again.triangles, soup.triangles) << name;
  }
  // STL has corners without indices: the same triangles in the same places.
  const Soup stl = read_stl(mesh_bytes(soup, ".stl"), "f");
  ASSERT_EQ(stl.triangles.size(), soup.triangles.size());
  EXPECT_EQ(stl.points.size(), soup.points.size());
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_EQ(stl.points[stl.triangles[t][i]], soup.points[soup.triangles[t][i]]) << t;
}

TEST_F(InFolder, Refusals) {
  const auto refused = [](const std::filesystem::path& file) {
    try {
      (void)read_mesh(file);
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refused(folder_ / "none.obj").find("none.obj: no such file"), std::string::npos);
  EXPECT_NE(refused(folder_).find("is a directory"), std::string::npos);
  std::ofstream(folder_ / "empty.ply");
  EXPECT_NE(refused(folder_ / "empty.ply").find("the file is empty"), std::string::npos);
  std::ofstream(folder_ / "a.xyz") << "0 0 0\n";
  EXPECT_NE(refused(folder_ / "a.xyz").find("unknown extension '.xyz'"), std::string::npos);
  EXPECT_THROW((void)mesh_bytes(tetrahedron(), ".xyz"), BadInput);
}

}  // namespace
}  // namespace restrip::tools
