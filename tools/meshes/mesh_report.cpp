#include "meshes/mesh_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>

#include "common/counted.hpp"
#include "common/disjoint_sets.hpp"
#include "meshes/edges.hpp"
#include "meshes/strip_file.hpp"

namespace restrip::tools {

MeshReport report_on(const Soup& soup) {
  MeshReport report;
  report.vertices = soup.points.size();
  report.triangles = soup.triangles.size();
  report.polygons = soup.polygons;
  report.stubs = soup.stubs;
  report.coincident_vertices = coincident_vertices(soup);

  // Triangles around each vertex, and connected pieces of vertices.
  std::vector<std::uint32_t> around(soup.points.size(), 0);
  DisjointSets pieces(soup.points.size());
  for (const Corners& t : soup.triangles) {
    if (degenerate(t)) {
      ++report.degenerate_faces;
      continue;
    }
    for (const std::uint32_t v : t) ++around[v];
    pieces.unite(t[0], t[1]);
    pieces.unite(t[0], t[2]);
  }
  for (std::uint32_t v = 0; v < around.size(); ++v) {
    if (around[v] == 0) continue;
    ++report.used_vertices;
    report.components += static_cast<std::size_t>(pieces.find(v) == v);
    if (around[v] >= report.triangles_per_vertex.size())
      report.triangles_per_vertex.resize(around[v] + std::size_t{1}, 0);
    ++report.triangles_per_vertex[around[v]];
  }

  // Edges. Around both ends, the triangles of an edge belong to one group.
  DisjointSets fans(3 * soup.triangles.size());  // corners at one vertex whose triangles are connected by edges
  std::vector<std::uint32_t> boundary;
  for_each_edge(soup, [&](std::span<const Side> edge) {
    ++report.edges;
    if (edge.size() == 1) {
      ++report.boundary_edges;
      boundary.push_back(edge[0].corner);
    }
    const auto same_way = [&](const Side& side) {
      return vertex_at(soup, side.corner) == vertex_at(soup, edge[0].corner);
    };
    if (edge.size() == 2 && same_way(edge[1])) ++report.inconsistent_edges;
    if (edge.size() > 2) ++report.non_manifold_edges;
    for (const Side& side : edge.subspan(1)) {
      fans.unite(edge[0].corner, same_way(side) ? side.corner : next_corner(side.corner));
      fans.unite(next_corner(edge[0].corner), same_way(side) ? next_corner(side.corner) : side.corner);
    }
  });
  std::vector<std::uint8_t> groups(soup.points.size(), 0);
  for (std::uint32_t corner = 0; corner < 3 * soup.triangles.size(); ++corner)
    if (!degenerate(soup.triangles[corner / 3]) && fans.find(corner) == corner)
      if (std::uint8_t& n = groups[vertex_at(soup, corner)]; n < 2 && ++n == 2) ++report.bow_tie_vertices;

  // Boundary edges follow each other if they end at the same group of triangles. At a bow-tie vertex two loops touch
  // but stay separate.
  DisjointSets loops(3 * soup.triangles.size());
  for (const std::uint32_t corner : boundary) loops.unite(fans.find(corner), fans.find(next_corner(corner)));
  for (std::uint32_t& corner : boundary) corner = loops.find(fans.find(corner));
  std::sort(boundary.begin(), boundary.end());
  report.boundary_loops = static_cast<std::size_t>(std::unique(boundary.begin(), boundary.end()) - boundary.begin());

  std::vector<Corners> faces;
  faces.reserve(soup.triangles.size());
  for (Corners t : soup.triangles) {
    if (degenerate(t)) continue;
    std::sort(t.begin(), t.end());
    faces.push_back(t);
  }
  std::sort(faces.begin(), faces.end());
  for (std::size_t i = 1; i < faces.size(); ++i)
    report.duplicate_faces += static_cast<std::size_t>(faces[i] == faces[i - 1]);

  if (!soup.strips.empty()) {
    std::vector<std::uint32_t> origin;
    StripMesh mesh = StripMesh::build(soup.triangles, soup.points.size(), nullptr, &origin);
    const FileStrips colored = color_as_in_file(mesh, soup, origin);
    report.strips = {mesh.triangle_count() - colored.solid, colored.cut, soup.strips.size()};
  }
  const MeshReport& r = report;
  report.euler_characteristic = static_cast<std::int64_t>(r.used_vertices) - static_cast<std::int64_t>(r.edges) +
                                static_cast<std::int64_t>(r.triangles - r.degenerate_faces);
  if (r.degenerate_faces + r.duplicate_faces + r.non_manifold_edges + r.inconsistent_edges + r.bow_tie_vertices == 0)
    report.genus = (2 * static_cast<std::int64_t>(r.components) - static_cast<std::int64_t>(r.boundary_loops) -
                    r.euler_characteristic) /
                   2;
  return report;
}

std::string as_text(const MeshReport& report, const std::string& name, const Mended& mended) {
  std::string text = name + "\n" + as_text(mended);
  const auto row = [&](const char* what, auto value, const std::string& remark = "") {
    text += fmt::format("  {:<28}{:>12}{}\n", what, value, remark.empty() ? "" : "   " + remark);
  };
  // Lists faults that occur.
  const auto fault = [&](const char* what, std::size_t value, const char* remark) {
    if (value != 0) row(what, value, remark);
  };
  row("vertices", report.vertices, fmt::format("{} used", report.used_vertices));
  row("triangles", report.triangles);
  row("edges", report.edges);
  row("boundary edges", report.boundary_edges, "in " + counted(report.boundary_loops, "loop"));
  row("components", report.components);
  row("Euler characteristic", report.euler_characteristic);
  if (report.genus) row("genus", *report.genus, report.components > 1 ? "all components together" : "");
  fault("faces cut into triangles", report.polygons, "they had more than three corners");
  fault("faces left out", report.stubs, "they have fewer than three corners");
  fault("degenerate faces", report.degenerate_faces, "a corner twice; they are in no strip");
  fault("duplicate faces", report.duplicate_faces, "the same three corners as an earlier face");
  fault("non-manifold edges", report.non_manifold_edges,
        "three triangles or more; strips cross them in pairs, no operation there");
  fault("inconsistent edges", report.inconsistent_edges,
        "two triangles of opposite orientation; no strip crosses them; --orient turns triangles");
  fault("bow-tie vertices", report.bow_tie_vertices, "several fans at one vertex; no operation there");
  fault("coincident vertices", report.coincident_vertices,
        "at the place of another; strips end at seams; --weld joins");
  if (report.strips)
    row("strips of the file", report.strips->strips,
        fmt::format("{}{}", counted(report.strips->indices, "index", "indices"),
                    report.strips->cut == 0 ? ""
                                            : fmt::format("; cut at {}: consecutive triangles share no edge",
                                                          counted(report.strips->cut, "place"))));
  if (report.manifold()) text += "  an oriented manifold: every operation has its rule everywhere\n";
  text += "\n  triangles per vertex    vertices\n";
  for (std::size_t n = 1; n < report.triangles_per_vertex.size(); ++n)
    if (const std::size_t count = report.triangles_per_vertex[n]; count != 0)
      text += fmt::format("  {:>20}{:>12}{:>9.2f} %\n", n, count,
                          100.0 * static_cast<double>(count) / static_cast<double>(report.used_vertices));
  return text;
}

nlohmann::ordered_json as_json(const MeshReport& report, const Mended& mended) {
  nlohmann::ordered_json json{
      {"vertices", report.vertices},
      {"used_vertices", report.used_vertices},
      {"triangles", report.triangles},
      {"edges", report.edges},
      {"boundary_edges", report.boundary_edges},
      {"boundary_loops", report.boundary_loops},
      {"components", report.components},
      {"euler_characteristic", report.euler_characteristic},
      {"genus", nullptr},
      {"manifold", report.manifold()},
      {"polygons", report.polygons},
      {"stubs", report.stubs},
      {"degenerate_faces", report.degenerate_faces},
      {"duplicate_faces", report.duplicate_faces},
      {"non_manifold_edges", report.non_manifold_edges},
      {"inconsistent_edges", report.inconsistent_edges},
      {"bow_tie_vertices", report.bow_tie_vertices},
      {"coincident_vertices", report.coincident_vertices},
  };
  if (report.genus) json["genus"] = *report.genus;
  if (report.strips)
    json.update(nlohmann::ordered_json{{"strips", report.strips->strips},
                                       {"cut_strips", report.strips->cut},
                                       {"strip_indices", report.strips->indices}});
  nlohmann::ordered_json histogram = nlohmann::ordered_json::object();
  for (std::size_t n = 1; n < report.triangles_per_vertex.size(); ++n)
    if (report.triangles_per_vertex[n] != 0) histogram[std::to_string(n)] = report.triangles_per_vertex[n];
  json["triangles_per_vertex"] = std::move(histogram);
  add_to(json, mended);
  return json;
}

// What was changed when a mesh was read, and how its strips were written.

std::string as_text(const Mended& mended) {
  std::string text;
  if (mended.asked.weld)
    text += fmt::format("welded: {} with others at the same place; {} vanished\n",
                        counted(mended.welded_vertices, "vertex", "vertices"),
                        counted(mended.vanished_triangles, "triangle"));
  if (mended.asked.orient) text += fmt::format("oriented: {} turned\n", counted(mended.turned_triangles, "triangle"));
  if (mended.closed_seams != 0)
    text += fmt::format("seams closed: {} at the same place as others, one with them now\n",
                        counted(mended.closed_seams, "vertex", "vertices"));
  if (!mended.left_out.empty()) text += fmt::format("left out: {}\n", left_out_in_words(mended.left_out));
  if (mended.rounding.matters)
    text += fmt::format("coordinates rounded to 32 bits, by {:.2g} at most; {} at the place of another thereby\n",
                        mended.rounding.largest, counted(mended.rounding.coinciding, "vertex lies", "vertices lie"));
  return text;
}

void add_to(nlohmann::ordered_json& report, const Mended& mended) {
  if (mended.rounding.matters)
    report["rounded"] = {{"largest", mended.rounding.largest}, {"coinciding_vertices", mended.rounding.coinciding}};
  if (mended.asked.weld || mended.asked.orient)
    report["mended"] = {{"welded_vertices", mended.welded_vertices},
                        {"vanished_triangles", mended.vanished_triangles},
                        {"turned_triangles", mended.turned_triangles}};
  if (mended.closed_seams != 0) report["closed_seams"] = mended.closed_seams;
  if (!mended.left_out.empty()) report["left_out_content"] = mended.left_out;
}

std::string as_text(const WrittenStrips& written, const std::string& name) {
  if (written.index_bits == 0) return {};
  std::string text = fmt::format("{}: {} of {} bits, {}", name, counted(written.indices, "index", "indices"),
                                 written.index_bits, name_of(written.form));
  if (written.batches > 1) text += fmt::format(", in {}", counted(written.batches, "batch", "batches"));
  if (written.wanted)
    text += fmt::format("; a list, because the form {} has more (--keep-strips writes it)", name_of(*written.wanted));
  text += '\n';
  if (!written.required_extensions.empty())
    text += fmt::format("{}: requires {}, a proposal that few viewers know; the others refuse the file\n", name,
                        fmt::join(written.required_extensions, ", "));
  return text;
}

void add_to(nlohmann::ordered_json& json, const WrittenStrips& written) {
  if (written.index_bits == 0) return;
  json["file"] = {{"form", name_of(written.form)},
                  {"index_bits", written.index_bits},
                  {"indices", written.indices},
                  {"batches", written.batches}};
  if (written.wanted) json["file"]["list_in_place_of"] = name_of(*written.wanted);
  if (!written.required_extensions.empty()) json["required_extensions"] = written.required_extensions;
}

}  // namespace restrip::tools
