// MeshReport as text and as JSON.
#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>

#include "common/counted.hpp"
#include "meshes/mesh_report.hpp"

namespace restrip::tools {

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
