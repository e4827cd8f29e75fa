// Claims: each format reads what it writes and names the extensions that a viewer needs. The finest level of a
// progressive or baked mesh is the original mesh, with its baked strips. A file is opened once, so pipes work like
// files. The tables of formats in the documents and in the program agree.
#include "lod/mesh_formats.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <future>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "common/output.hpp"
#include "folders.hpp"
#include "lod/bake.hpp"
#include "lod/baked_file.hpp"
#include "lod/coloring_check.hpp"
#include "lod/mesh_files.hpp"
#include "lod/pm_file.hpp"
#include "lod/simplify.hpp"
#include "meshes/made_mesh.hpp"
#include "meshes/soup.hpp"
#include "meshes/strip_file.hpp"
#include "restrip/output/strips.hpp"
#include "shapes.hpp"

namespace restrip::tools {
namespace {

ReadMesh parsed(const MeshFormat& format, const std::string& bytes) {
  return parse_mesh(bytes, format.extension, "some file", no_sibling);
}

/// The triangles by their points, so that vertex numbers do not matter.
std::vector<std::array<std::array<double, 3>, 3>> by_points(const Soup& soup) {
  std::vector<std::array<std::array<double, 3>, 3>> all;  // in 32 bits: text has no more digits than these need
  for (const Corners& t : soup.triangles) {
    auto& c = all.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const Point p = in_32_bits(soup.points[t[i]]);
      c[i] = {p.x, p.y, p.z};
    }
    std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// A mesh in every format that is written.
struct Everything {
  Soup mesh;
  std::vector<std::uint32_t> indices;
  std::vector<Corners> drawn;
  ProgressiveMesh progressive;
  BakeReport report;
  std::string baked;

  explicit Everything(Soup soup) : mesh(std::move(soup)) {
    indices = strip_indices(stripified(mesh));
    drawn = decode_strips(indices);
    progressive = simplify(mesh, {0.2, BoundaryPolicy::move}).mesh;
    baked = baked_bytes(bake(progressive, {20'000}, &report));
  }
};

TEST(MeshFormats, WhatIsWrittenIsRead) {
  std::size_t ways = 0;
  std::size_t requirements = 0;
  for (const Soup& soup : {make_mesh(600), sheet(9)}) {
    const Everything all(soup);
    for (const MeshFormat& format : mesh_formats()) {
      if (!reads(format)) continue;
      const std::string in(format.extension);
      if (writes_mesh(format)) {
        ++ways;
        EXPECT_EQ(by_points(std::get<Soup>(parsed(format, format.write_mesh(all.mesh)))), by_points(soup)) << in;
      }
      if (writes_strips(format))
        for (const StripForm form : {StripForm::restart, StripForm::lengths, StripForm::stitched, StripForm::list}) {
          ++ways;
          const auto [bytes, written, wanted, bits, count, batches, strips, required] =
              written_strips(format, all.mesh.points, all.indices, {form});
          EXPECT_EQ(bytes.find("extensionsRequired") != std::string::npos, !required.empty()) << in;
          for (const std::string& name : required) {
            ++requirements;
            EXPECT_NE(bytes.find(name), std::string::npos) << in;
          }
          const Soup read = std::get<Soup>(parsed(format, bytes));
          const bool reordered = format.forms && form == StripForm::stitched;
          EXPECT_TRUE(reordered || read.triangles == all.drawn) << in;
          EXPECT_EQ(sorted_triangles(read.triangles), sorted_triangles(all.drawn)) << in;
          const bool as_strips = format.holds_strips && !(format.forms && form == StripForm::list);
          if (reordered) {
            EXPECT_EQ(std::count(read.strips.begin(), read.strips.end(), strip_end), 0) << in;
          } else if (as_strips) {
            EXPECT_EQ(read.strips, all.indices) << in;
          } else {
            EXPECT_TRUE(read.strips.empty()) << in;
          }
        }
      if (format.write_progressive != nullptr &&
          !writes_strips(format)) {  // progressive_gltf_test.py tests the other one
        ++ways;
        const auto read = std::get<ProgressiveMesh>(parsed(format, format.write_progressive(all.progressive)));
        EXPECT_EQ(read.splits.size(), all.progressive.splits.size());
      }
      if (writes_baked(format)) {
        ++ways;
        const auto read = std::get<BakedBytes>(parsed(format, format.write_baked(all.baked, {}).bytes));
        EXPECT_EQ(read.bytes, all.baked) << in;
      }
    }
  }
  EXPECT_GE(ways, 2U * (4 + 3 * 4 + 1 + 2));
  EXPECT_GT(requirements, 0U);
}

TEST(MeshFormats, TheFinestLevelIsTheMeshThatWasSimplified) {
  for (const Soup& soup : {make_mesh(600), sheet(9)}) {
    const Everything all(soup);
    const Soup progressive = finest_level(all.progressive);
    EXPECT_EQ(by_points(progressive), by_points(soup));
    EXPECT_TRUE(progressive.strips.empty());
    for (const char* extension : {".baked", ".glb"}) {
      const MeshFormat& format = *format_named(extension);
      const Soup baked = finest_level(parsed(format, format.write_baked(all.baked, {StripForm::list}).bytes));
      EXPECT_EQ(by_points(baked), by_points(soup));
      std::vector<std::uint32_t> origin;
      StripMesh mesh = StripMesh::build(baked.triangles, baked.points.size(), nullptr, &origin);
      EXPECT_EQ(color_as_in_file(mesh, baked, origin).cut, 0U);
      EXPECT_TRUE(find_faults(mesh).empty());
      EXPECT_EQ(count_strips(mesh), all.report.top_strips);
    }
  }
}

/// Corner by corner.
std::vector<Point> corner_points(const Soup& soup) {
  std::vector<Point> points;
  for (const Corners& t : soup.triangles)
    for (const std::uint32_t v : t) points.push_back(soup.points[v]);
  return points;
}

// Coordinates far from the origin: text and PLY keep every digit. If 32 bits would join vertices, that is reported.
TEST(MeshFormats, DigitsAreKeptOrTheirLossIsReported) {
  const std::string far =
      "v 500000.001 4649776.251 10.004\nv 500000.501 4649776.251 10.004\nv 500000.001 4649776.501 10.004\n"
      "v 500000.501 4649776.501 10.004\nf 1 2 3\nf 3 2 4\n";
  const Soup soup = read_as(".obj", far);
  EXPECT_EQ(soup.points[0], (Point{500000.001, 4649776.251, 10.004}));
  EXPECT_EQ(coincident_vertices(soup), 0U) << "--weld would not join them";
  for (const MeshFormat& format : mesh_formats()) {
    Mended mended;
    Soup written = soup;
    leave_out_losses(written, format, mended);
    EXPECT_EQ(as_text(mended).find("2 vertices lie at the place of another") != std::string::npos, format.rounds)
        << format.extension;
    if (format.write_mesh == nullptr || format.rounds) continue;
    const Soup again = std::get<Soup>(parsed(format, format.write_mesh(soup)));
    EXPECT_TRUE(corner_points(again) == corner_points(soup)) << format.extension;
  }
  // 64-bit input is written in 64 bits; otherwise only as many bits as matter.
  const auto ply = [](const char* type) {
    return fmt::format(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty {0} x\nproperty {0} y\nproperty {0} z\nelement face 1\n"
        "property list uchar int vertex_index\nend_header\n0.1 0 0\n1 0.2 0\n0 1 0.3\n3 0 1 2\n",
        type);
  };
  EXPECT_EQ(read_as(".ply", ply_bytes(read_as(".ply", ply("double")))).points[0], (Point{0.1, 0, 0}));
  EXPECT_EQ(read_as(".ply", ply_bytes(read_as(".ply", ply("float")))).points[0], (Point{0.1F, 0, 0}));
  EXPECT_EQ(read_as(".obj", obj_bytes(read_as(".ply", ply("float")))).points[0], (Point{0.1, 0, 0}));
}

using FormatsInFolder = ScratchFolder;

// A pipe can be read once: a second open would block for ever.
TEST_F(FormatsInFolder, AFileIsOpenedOnce) {
  const Everything all(sheet(6));
  std::map<std::string, std::string> written{{".pm", pm_bytes(all.progressive)}};
  for (const MeshFormat& format : mesh_formats()) {
    const std::string extension(format.extension);
    if (reads(format) && writes_mesh(format)) written[extension] = format.write_mesh(all.mesh);
    if (reads(format) && writes_baked(format))
      written[extension] = format.write_baked(all.baked, {StripForm::list}).bytes;
  }
  EXPECT_GE(written.size(), 7U);
  for (const auto& [extension, bytes] : written) {
    const std::filesystem::path pipe = folder_ / ("pipe" + extension);
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const auto writer = std::async(std::launch::async, [&, &to_write = bytes] {
      std::ofstream(pipe, std::ios::binary).write(to_write.data(), static_cast<std::streamsize>(to_write.size()));
    });
    EXPECT_EQ(by_points(read_mesh(pipe)), by_points(all.mesh)) << extension;
  }
}

/// The rows of docs/reference/file-formats.md: formats read and written, by extension. Several rows of one extension
/// are joined.
std::map<std::string, std::array<std::string, 2>> table_of_formats() {
  std::ifstream page(RESTRIP_FORMATS);
  std::map<std::string, std::array<std::string, 2>> rows;
  bool inside = false;
  for (std::string line; std::getline(page, line);) {
    if (line == "| file | read | written |") inside = true;
    if (!inside || line.starts_with("| file") || line.starts_with("| ---")) continue;
    if (line.empty()) break;
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, '|');) cells.push_back(cell);
    if (cells.size() != 4) {
      ADD_FAILURE() << "a row of three cells: " << line;
      break;
    }
    for (std::size_t at = 0; (at = cells[1].find("`.", at)) != std::string::npos;) {
      const std::size_t end = cells[1].find('`', at + 1);
      auto& row = rows[cells[1].substr(at + 1, end - at - 1)];
      for (std::size_t i = 0; i < 2; ++i) row[i] += cells[i + 2];
      at = end + 1;
    }
  }
  return rows;
}

TEST(MeshFormats, AgreeWithTheDocuments) {
  const auto rows = table_of_formats();
  EXPECT_EQ(rows.size(), mesh_formats().size());
  const auto says = [](const std::string& cell, const char* word) { return cell.find(word) != std::string::npos; };
  for (const MeshFormat& format : mesh_formats()) {
    const std::string extension(format.extension);
    ASSERT_TRUE(rows.contains(extension)) << extension;
    const auto& [read, written] = rows.at(extension);
    EXPECT_EQ(says(read, "–"), !reads(format)) << extension;
    const bool writes = writes_any(format) || format.write_progressive != nullptr;
    EXPECT_EQ(says(written, "–"), !writes) << extension;
    EXPECT_EQ(says(written, "attributes"), format.attributes != MeshFormat::Attributes::none) << extension;
    EXPECT_EQ(says(written, "strips"), writes_strips(format)) << extension;
    EXPECT_EQ(says(written, "progressive"), format.write_progressive != nullptr) << extension;
    EXPECT_EQ(says(written, "baked"), writes_baked(format)) << extension;
    EXPECT_EQ(says(written, "--gltf"), format.forms && writes_baked(format)) << extension;
  }
}

}  // namespace
}  // namespace restrip::tools
