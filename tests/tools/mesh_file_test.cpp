// Claims: a mesh file of any format is read triangle by triangle without changes, or refused with a sentence that names
// the file and the fault.
#include "meshes/mesh_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <utility>

#include "folders.hpp"
#include "lod/mesh_files.hpp"
#include "meshes/little_endian.hpp"
#include "meshes/soup.hpp"
#include "shapes.hpp"
#include "support/alterations.hpp"
#include "support/refusal_of.hpp"

namespace restrip::tools {
namespace {

void expect_refused(std::string_view extension, std::string_view bytes, const std::string& because,
                    ReadAttributes attributes = ReadAttributes::no) {
  const std::string text = refusal_of([&] { (void)read_as(extension, bytes, attributes); });
  EXPECT_TRUE(text.starts_with("some.file:")) << "for: " << bytes << "\nsaid: " << text;
  EXPECT_NE(text.find(because), std::string::npos) << "for: " << bytes << "\nsaid: " << text;
}

TEST(Obj, CornersWithTextureAndNormalIndices) {
  const Soup soup = read_as(
      ".obj",
      "# c\nv 0 0 0\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1 2 3\nf 1/1 2/1 3/1\nf 1//1 2//1 3//1\nf 1/1/1 "
      "2/1/1 3/1/1\nf 1 2\n");
  EXPECT_EQ(soup.points.size(), 3U);
  EXPECT_EQ(soup.triangles, std::vector<Corners>(4, Corners{0, 1, 2}));
  EXPECT_EQ(soup.stubs, 1U);
}

TEST(Obj, LinesAfterThreeVertices) {
  const Corners one{0, 1, 2};
  for (const auto& [lines, triangles] : std::vector<std::pair<std::string, std::vector<Corners>>>{
           {"f -3 -2 -1\nv 0 0 1\nf -4 -3 -1\n", {one, {0, 1, 3}}},  // negative ones count from the vertices before
           {"f 1 1 2\nf 1 2 3\nf 1 2 3\n", {{0, 0, 1}, one, one}},   // degenerate and duplicate faces arrive
           {"v 0 1 \\\n 0\r\nf 1 \\\r\n 2 3", {one}},  // lines end in any way, and go on after a backslash
           {"f 1/1 2/2\\\n 3/3", {one}},
           {"f 1 2\\\r3\\", {one}},
           {"usemtl a\\\nf 1 2 3\\\r\n", {one}},
           {"mtllib c:\\m\\f 1 1 1\nf 1 2 3\n", {one}}})
    EXPECT_EQ(read_as(".obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + lines).triangles, triangles) << lines;
}

TEST(Obj, ValuesThatFacesNameAndTheFileLacksAreMissing) {
  const Soup soup = read_as(".obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/4/1 2/4/1 3/4/1\n", ReadAttributes::yes);
  EXPECT_EQ(soup.triangles.size(), 1U);
  EXPECT_TRUE(soup.attributes.empty());
  EXPECT_EQ(left_out_in_words(soup.left_out),
            "texture coordinates (missing from the file), normals (missing from the file)");
}

// Whatever is wrong with an attribute, the triangles are read.
TEST(Obj, AttributesThatCannotBeUsedAreLeftOut) {
  const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (const auto& [lines, left_out] : std::vector<std::pair<std::string, std::string>>{
           {"vt 0\nf 1/1 2/2 3/1\n", "texture coordinates (a face refers to `vt` 2, and there are 1)"},
           {"vn 0 0 1\nf 1//1 2//3 3//1\n", "normals (a face refers to `vn` 3, and there are 1)"},
           {"vn 0 0 1\nf 1//1 2//0 3//1\n", "normals (line 5: '2//0' names no `vn`)"},
           {"vn 0 0 1\nf 1//1 2//-2 3//1\n", "normals (line 5: '2//-2' names no `vn`)"},
           {"vn 0 0 1\nf 1//1 2//z 3//1\n", "normals (line 5: '2//z' names no `vn`)"},
           {"vn 0 0 1\nvt 0 0\nf 1/0/1 2/1/1 3/1/1\n", "texture coordinates (line 6: '1/0/1' names no `vt`)"},
           {"vn 0 1\nf 1//1 2//1 3//1\n", "normals (line 4: a `vn` of 2 numbers)"},
           {"vt\nf 1/1 2/1 3/1\n", "texture coordinates (line 4: a `vt` of 0 numbers)"},
           {"vt 0 x\nf 1/1 2/1 3/1\n", "texture coordinates (line 4: 'x' is not a number)"},
           {"vn 0 0 1\nvn 0 nan 1\nf 1//1 2//2 3//1\n", "normals (`vn` 2 is infinite or not a number)"},
           {"vt 1e300 0\nf 1/1 2/1 3/1\n", "texture coordinates (`vt` 1 is infinite or not a number)"},
           {"vn 0 nan 1\nvn 0 0 1\nf 1//2 2//2 3//2\n", ""},
           {"vt 0 0 0\nf 1/1 2/1 3/1\n", ""},
           {"vt 0 0 0.5\nf 1/1 2/1 3/1\n", "third texture coordinates"}}) {
    const Soup soup = read_as(".obj", three + lines, ReadAttributes::yes);
    EXPECT_EQ(soup.triangles, (std::vector<Corners>{{0, 1, 2}})) << lines;
    EXPECT_EQ(left_out_in_words(soup.left_out), left_out) << lines;
    EXPECT_EQ(read_as(".obj", three + lines).triangles.size(), 1U) << lines;
  }
  const auto of_colors = [](const std::string& colors) {
    return left_out_in_words(read_as(".obj",
                                     "v 0 0 0 " + colors + "\nv 1 0 0 0 0 0\nv 0 1 0 0 0 0\nv 9 9 9 nan 0 0\nf 1 2 3\n",
                                     ReadAttributes::yes)
                                 .left_out);
  };
  EXPECT_EQ(of_colors("1 1 1e99"), "colours (infinite or not a number at vertex 0)");
  EXPECT_EQ(of_colors("1 1 red"), "colours (infinite or not a number at vertex 0)");
  EXPECT_EQ(of_colors("1 1 1"), "colours that are infinite or not a number, of 1 vertex in no triangle");
}

// left_out_test.py has the parts of each format that are left out.
TEST(Obj, UnknownLinesAreNamedUpToALimit) {
  std::string many = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n\x7fx\n";
  for (int i = 0; i < 1000; ++i) many += fmt::format("word{}\n", i);
  const std::vector<std::string> left_out = read_as(".obj", many).left_out;
  EXPECT_EQ(left_out.size(), 65U);
  EXPECT_TRUE(left_out_in_words(left_out).starts_with("lines `\\x7fx`, lines `word0`"));
  EXPECT_TRUE(left_out_in_words(left_out).ends_with("more parts of other kinds"));
}

TEST(Obj, NumbersThatUnderflowAreZeroOrTheNearest) {
  const Soup soup = read_as(".obj", "v 1e-400 -1e-999 4e-324\nv 1 0 1e-310\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(soup.points[0], (Point{0, 0, 4e-324}));
  EXPECT_EQ(soup.points[1].z, 1e-310);
  expect_refused(".obj", "v 1e400 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "found '1e400'");
}

TEST(Meshes, OneAlterationIsNamed) {
  for (const corpus::Alteration& alteration : corpus::alterations("meshes.txt"))
    for (const ReadAttributes attributes : {ReadAttributes::no, ReadAttributes::yes})
      expect_refused(alteration.of.substr(alteration.of.rfind('.')),
                     alteration.in(corpus::text_to_alter(alteration.of)), alteration.says, attributes);
}

TEST(Off, CommentsAndColoursAreSteppedOver) {
  const Soup soup = read_as(
      ".off",
      "# made by hand\n\nCOFF # colours\n3 1 0\n\n0 0 0 255 0 0\n1 0 0 255 0 0\n# here too\n0 1 0 255 0 0\n3 0 1 2 1 0 "
      "0\n");
  EXPECT_EQ(soup.points.size(), 3U);
  EXPECT_EQ(soup.triangles, (std::vector<Corners>{{0, 1, 2}}));
}

TEST(Off, HeadersHaveManyForms) {
  const std::string body = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 2 1 3\n";
  const std::vector<Corners> both{{0, 1, 2}, {2, 1, 3}};
  for (const char* header : {"OFF4 2 0\n", "OFF 4 2 0\n", "OFF\n4 2 5\n", "OFF\n4 2\n", "4 2 0\n", "OFF\n4\n2\n0\n",
                             "OFF 4 2\n0\n", "nOFF 3\n4 2 0\n", "COFF\n4 2 0\n", "STCNOFF 4 2 0\n", "NCSTOFF4 2 0\n"})
    EXPECT_EQ(read_as(".off", header + body).triangles, both) << header;
  EXPECT_EQ(read_as(".off", "OFF 4 2 0 0 0 0 1 0 0 0 1 0 1 1 0 3 0 1 2 3 2 1 3").triangles, both);
  EXPECT_EQ(read_as(".off", "OFF\n4 2 0\n0\n0\n0\n1 0\n0 0 1 0\n1 1 0 3\n0 1 2 3 2 1 3\n").triangles, both);
  EXPECT_EQ(read_as(".off", "4OFF 4 2 0\n0 0 0 1\n1 0 0 1\n0 1 0 1\n1 1 0 1\n3 0 1 2\n3 2 1 3\n").triangles, both);
}

// For every text format: a byte order mark, and each kind of line end.
TEST(Texts, MayBeginWithAByteOrderMarkAndEndLinesInAnyWay) {
  for (const auto& [extension, text] : std::vector<std::pair<std::string, std::string>>{
           {".obj", "v 0 0 0\nv 1 0 0 # c\nv 0 1 0\nf 1 2 3\n"},
           {".obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n"},
           {".off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
           {".ply",
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement "
            "face 1\nproperty list uchar int vertex_index\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
           {".stl",
            "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
            "endfacet\nendsolid a\n"}})
    for (const char* mark : {"", "\xEF\xBB\xBF"})
      for (const char* end : {"\n", "\r\n", "\r"}) {
        std::string written = mark;
        for (const char c : text) written += c == '\n' ? std::string(end) : std::string(1, c);
        const Soup soup = read_as(extension, written, ReadAttributes::yes);
        EXPECT_EQ(soup.points, (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})) << text;
        EXPECT_EQ(soup.triangles, (std::vector<Corners>{{0, 1, 2}})) << text;
      }
}

TEST(Ply, TextWithOtherProperties) {
  const Soup soup = read_as(".ply", corpus::text_to_alter("mesh.ply"));
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
  const Soup soup = read_as(".ply", header + colors + rest, ReadAttributes::yes);
  EXPECT_EQ(soup.points.size(), 3U);
  EXPECT_TRUE(soup.attributes.empty());
  EXPECT_EQ(soup.left_out, std::vector<std::string>{"COLOR_0"});
  expect_refused(".ply", header + colors + "end_header\n0 0 9 1 2 3\n1 0 9 1 2 256\n",
                 "vertex 1 has a colour 256, which is not from 0 to 255; --no-attributes reads the mesh",
                 ReadAttributes::yes);
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
    const Soup soup = read_as(".ply", ply_binary(big));
    EXPECT_EQ(soup.points, (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, -2.5F}}));
    EXPECT_EQ(soup.triangles, (std::vector<Corners>{{0, 1, 2}}));
  }
}

TEST(Ply, EveryPrefixIsRefused) {
  for (const bool big : {false, true}) {
    const std::string whole = ply_binary(big);
    for (std::size_t size = 0; size < whole.size(); ++size)
      expect_refused(".ply", std::string_view(whole).substr(0, size), "");
  }
}

TEST(Ply, WhatNoTriangleUsesMayBeNoNumber) {
  const auto with = [](std::string_view last) {
    return fmt::format(
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
        "property float nx\nproperty float ny\nproperty float nz\nelement face 1\nproperty list uchar int "
        "vertex_index\n"
        "end_header\nnan inf 0 0 0 nan\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n{}\n",
        last);
  };
  const Soup soup = read_as(".ply", with("3 1 2 3"), ReadAttributes::yes);
  EXPECT_EQ(soup.points[0], (Point{0, 0, 0}));
  EXPECT_EQ(soup.attributes.at(0).value(0), (Attribute::Value{0, 0, 1}));
  EXPECT_EQ(left_out_in_words(soup.left_out),
            "a coordinate that is infinite or not a number, of 1 vertex in no triangle, "
            "normals that are infinite or not a number, of 1 vertex in no triangle");
  expect_refused(".ply", with("3 0 2 3"), "vertex 0 has a coordinate that is infinite or not a number");
}

TEST(Ply, ABodyMayBeginWithTheByteOfALineFeed) {
  for (const char* end : {"\n", "\r\n", "\r"}) {
    std::string file;
    for (const char* line :
         {"ply", "format binary_little_endian 1.0", "element vertex 3", "property char x", "property char y",
          "property char z", "element face 1", "property list uchar uchar vertex_index", "end_header"})
      file += std::string(line) + end;
    file += std::string("\n\n\r\1\0\0\0\1\0\3\0\1\2", 13);
    EXPECT_EQ(read_as(".ply", file).points[0], (Point{10, 10, 13}));
  }
}

// A turn the other way is a repeated index, which draws no triangle.
TEST(Ply, StripsAreTheTrianglesThatTheyDraw) {
  const auto with = [](std::string_view lists) {
    return fmt::format(
        "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
        "element tristrips {}\nproperty uchar material\nproperty list int int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n{}",
        std::count(lists.begin(), lists.end(), '\n'), lists);
  };
  const auto triangles = [&](std::string_view lists) { return read_as(".ply", with(lists)).triangles; };
  EXPECT_EQ(triangles("9 4 0 1 2 3\n"), (std::vector<Corners>{{0, 1, 2}, {2, 1, 3}}));
  EXPECT_EQ(triangles("9 5 0 1 2 1 3\n"), (std::vector<Corners>{{0, 1, 2}, {2, 1, 3}})) << "a swap";
  EXPECT_EQ(triangles("9 8 0 1 2 -1 2 1 3 -1\n9 2 0 1\n9 3 2 3 4\n"),
            (std::vector<Corners>{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}}));
  const auto strips = [&](std::string_view lists) { return read_as(".ply", with(lists)).strips; };
  EXPECT_EQ(strips("9 8 0 1 2 -1 2 1 3 -1\n9 2 0 1\n9 3 2 3 4\n"),
            (std::vector<std::uint32_t>{0, 1, 2, strip_end, 2, 1, 3, strip_end, 2, 3, 4}));
  EXPECT_EQ(strips("9 5 0 1 2 1 3\n"), (std::vector<std::uint32_t>{0, 1, 2, 1, 3}));
  // The restart as an unsigned number.
  EXPECT_EQ(triangles("9 7 0 1 2 4294967295 2 1 3\n"), (std::vector<Corners>{{0, 1, 2}, {2, 1, 3}}));
  expect_refused(".ply", with("9 5 0 1 2 2 6\n"), "refers to vertex 6");
  expect_refused(".ply", with("9 3 0 1 6\n"), "refers to vertex 6");
  expect_refused(".ply", with("9 3 0 1 -2\n"), "strip list 0 has a corner -2, which is not a vertex");
  expect_refused(".ply", with("9 3 0 1\n"), "ends among the strips");
  expect_refused(".ply", with("9 2 0 1\n"), "no triangles");
}

std::string stl_binary(const Soup& soup) {
  std::string bytes = "solid" + std::string(75, ' ');  // as many programs write it, although it is not text
  put(bytes, static_cast<std::uint32_t>(soup.triangles.size()));
  for (const Corners& t : soup.triangles) {
    bytes += std::string(12, '\0');
    for (const std::uint32_t v : t) put(bytes, soup.points[v]);
    bytes += std::string(2, '\0');
  }
  return bytes;
}

TEST(Stl, CornersAtOnePlaceBecomeOneVertex) {
  const Soup soup = read_as(".stl", stl_binary(tetrahedron()));
  EXPECT_EQ(soup.points.size(), 4U);
  EXPECT_EQ(soup.triangles.size(), 4U);
  const Soup text = read_as(
      ".stl",
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex -0 1e0 0\nendloop\nendfacet\n"
      "facet normal 0 0 1\nouter loop\nvertex 0 1 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\nendfacet\nendsolid a\n");
  EXPECT_EQ(text.points.size(), 4U);
  EXPECT_EQ(text.triangles, (std::vector<Corners>{{0, 1, 2}, {2, 1, 3}}));
}

TEST(Stl, LettersMayBeLargeAndMoreBytesFollow) {
  std::string upper =
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
      "0\nendloop\nendfacet\nendsolid\n";
  for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  EXPECT_EQ(read_as(".stl", upper).triangles.size(), 1U);
  const std::string whole = stl_binary(tetrahedron());
  EXPECT_TRUE(read_as(".stl", whole).left_out.empty());
  const Soup longer = read_as(".stl", whole + "more");
  EXPECT_EQ(longer.triangles.size(), 4U);
  EXPECT_EQ(left_out_in_words(longer.left_out), "4 bytes after the facets");
  std::string coloured = whole;
  coloured.back() = 'c';
  EXPECT_EQ(left_out_in_words(read_as(".stl", coloured).left_out), "colours");
}

TEST(Stl, BinaryFilesThatAreNotComplete) {
  const std::string whole = stl_binary(tetrahedron());
  expect_refused(".stl", std::string_view(whole).substr(5, 60), "is it complete?");
  expect_refused(".stl", whole.substr(0, whole.size() - 1), "");
  expect_refused(".stl", std::string(79, '\n') + "x", "is it complete?");
}

using InFolder = ScratchFolder;

TEST_F(InFolder, ExtensionsMayBeLarge) {
  put("A.OBJ", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(read_mesh(folder_ / "A.OBJ").triangles.size(), 1U);
}

}  // namespace
}  // namespace restrip::tools
