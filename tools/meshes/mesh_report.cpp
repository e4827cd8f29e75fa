#include "meshes/mesh_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <span>

#include "common/counted.hpp"
#include "common/disjoint_sets.hpp"
#include "meshes/edges.hpp"
#include "meshes/strip_file.hpp"

namespace restrip::tools {
namespace {

class Surveyor {
 public:
  explicit Surveyor(const Soup& soup) : soup_(soup), fans_(3 * soup.triangles.size()) {
    report_.vertices = soup.points.size();
    report_.triangles = soup.triangles.size();
    report_.polygons = soup.polygons;
    report_.stubs = soup.stubs;
  }

  MeshReport survey() {
    count_triangles();
    std::vector<std::uint32_t> boundary;
    for_each_edge(soup_, [&](std::span<const Side> edge) { meet(edge, boundary); });
    count_fans();
    count_loops(boundary);
    count_duplicates();
    report_.coincident_vertices = coincident_vertices(soup_);
    if (!soup_.strips.empty()) count_strips_in_file();
    const MeshReport& r = report_;
    report_.euler_characteristic = static_cast<std::int64_t>(r.used_vertices) - static_cast<std::int64_t>(r.edges) +
                                   static_cast<std::int64_t>(r.triangles - r.degenerate_faces);
    if (r.degenerate_faces + r.duplicate_faces + r.non_manifold_edges + r.inconsistent_edges + r.bow_tie_vertices == 0)
      report_.genus = (2 * static_cast<std::int64_t>(r.components) - static_cast<std::int64_t>(r.boundary_loops) -
                       r.euler_characteristic) /
                      2;
    return std::move(report_);
  }

 private:
  [[nodiscard]] std::uint32_t vertex(std::uint32_t corner) const { return vertex_at(soup_, corner); }

  void count_triangles() {
    std::vector<std::uint32_t> around(soup_.points.size(), 0);
    DisjointSets pieces(soup_.points.size());
    for (const Corners& t : soup_.triangles) {
      if (degenerate(t)) {
        ++report_.degenerate_faces;
        continue;
      }
      for (const std::uint32_t v : t) ++around[v];
      pieces.unite(t[0], t[1]);
      pieces.unite(t[0], t[2]);
    }
    for (std::uint32_t v = 0; v < around.size(); ++v) {
      if (around[v] == 0) continue;
      ++report_.used_vertices;
      report_.components += static_cast<std::size_t>(pieces.find(v) == v);
      if (around[v] >= report_.triangles_per_vertex.size())
        report_.triangles_per_vertex.resize(around[v] + std::size_t{1}, 0);
      ++report_.triangles_per_vertex[around[v]];
    }
  }

  void meet(std::span<const Side> edge, std::vector<std::uint32_t>& boundary) {
    ++report_.edges;
    if (edge.size() == 1) {
      ++report_.boundary_edges;
      boundary.push_back(edge[0].corner);
    }
    if (edge.size() == 2 && vertex(edge[0].corner) == vertex(edge[1].corner)) ++report_.inconsistent_edges;
    if (edge.size() > 2) ++report_.non_manifold_edges;
    // Around both ends, the triangles of the edge belong to one group.
    for (const Side& side : edge.subspan(1)) {
      const bool same_way = vertex(side.corner) == vertex(edge[0].corner);
      fans_.unite(edge[0].corner, same_way ? side.corner : next_corner(side.corner));
      fans_.unite(next_corner(edge[0].corner), same_way ? next_corner(side.corner) : side.corner);
    }
  }

  void count_fans() {
    std::vector<std::uint8_t> groups(soup_.points.size(), 0);
    for (std::uint32_t corner = 0; corner < 3 * soup_.triangles.size(); ++corner)
      if (!degenerate(soup_.triangles[corner / 3]) && fans_.find(corner) == corner)
        if (std::uint8_t& n = groups[vertex(corner)]; n < 2 && ++n == 2) ++report_.bow_tie_vertices;
  }

  /// Boundary edges follow each other if they end at the same group of triangles. At a bow-tie vertex two loops touch
  /// but stay separate.
  void count_loops(const std::vector<std::uint32_t>& boundary) {
    DisjointSets loops(3 * soup_.triangles.size());
    for (const std::uint32_t corner : boundary) loops.unite(fans_.find(corner), fans_.find(next_corner(corner)));
    std::vector<std::uint32_t> roots;
    roots.reserve(boundary.size());
    for (const std::uint32_t corner : boundary) roots.push_back(loops.find(fans_.find(corner)));
    std::sort(roots.begin(), roots.end());
    report_.boundary_loops = static_cast<std::size_t>(std::unique(roots.begin(), roots.end()) - roots.begin());
  }

  void count_duplicates() {
    std::vector<Corners> faces;
    faces.reserve(soup_.triangles.size());
    for (Corners t : soup_.triangles) {
      if (degenerate(t)) continue;
      std::sort(t.begin(), t.end());
      faces.push_back(t);
    }
    std::sort(faces.begin(), faces.end());
    for (std::size_t i = 1; i < faces.size(); ++i)
      report_.duplicate_faces += static_cast<std::size_t>(faces[i] == faces[i - 1]);
  }

  void count_strips_in_file() {
    std::vector<std::uint32_t> origin;
    StripMesh mesh = StripMesh::build(soup_.triangles, soup_.points.size(), nullptr, &origin);
    const FileStrips colored = color_as_in_file(mesh, soup_, origin);
    report_.strips = {mesh.triangle_count() - colored.solid, colored.cut, soup_.strips.size()};
  }

  const Soup& soup_;
  MeshReport report_;
  DisjointSets fans_;  ///< corners at one vertex whose triangles are connected by edges
};

}  // namespace

MeshReport report_on(const Soup& soup) { return Surveyor(soup).survey(); }

std::string as_text(const MeshReport& report, const std::string& name, const Mended& mended) {
  std::string text = name + "\n" + as_text(mended);
  auto out = std::back_inserter(text);
  const auto row = [&](const char* what, auto value, const std::string& remark = "") {
    fmt::format_to(out, "  {:<28}{:>12}{}\n", what, value, remark.empty() ? "" : "   " + remark);
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
      fmt::format_to(out, "  {:>20}{:>12}{:>9.2f} %\n", n, count,
                     100.0 * static_cast<double>(count) / static_cast<double>(report.used_vertices));
  return text;
}

std::string as_json(const MeshReport& report, const Mended& mended) {
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
  return json.dump(2) + "\n";
}

}  // namespace restrip::tools
