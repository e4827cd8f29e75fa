// `restrip draw`: a mesh and its strips as a picture, or as the facts from which scripts/pictures.py draws one.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/commands.hpp"
#include "app/level_file.hpp"
#include "app/source.hpp"
#include "common/bad_input.hpp"
#include "common/report_output.hpp"
#include "files/output.hpp"
#include "files/reading.hpp"
#include "lod/coloring_check.hpp"
#include "meshes/file_strips.hpp"
#include "pictures/picture_file.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/rules/rules.hpp"

namespace restrip::tools {
namespace {

/// Moves each vertex to the mean of its neighbours, so that the made mesh's jitter does not hide it in a picture.
void smooth(Soup& soup, int rounds) {
  for (; rounds > 0; --rounds) {
    std::vector<Point> sum(soup.points.size());
    std::vector<float> count(soup.points.size(), 0);
    for (const Corners& t : soup.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Point& p = soup.points[t[(i + 1) % 3]];
        Point& s = sum[t[i]];
        s = {s.x + p.x, s.y + p.y, s.z + p.z};
        count[t[i]] += 1;
      }
    }
    for (std::size_t v = 0; v < sum.size(); ++v)
      if (count[v] > 0) soup.points[v] = {sum[v].x / count[v], sum[v].y / count[v], sum[v].z / count[v]};
  }
}

Source built_in_source(const DrawCommand& command) {
  constexpr std::size_t triangles_in_a_picture = 2400;
  Soup soup = make_mesh(triangles_in_a_picture);
  smooth(soup, 4);
  return simplified("built-in torus", std::move(soup), command.simplify);
}

/// A mesh and its strips.
struct Colored {
  StripMesh mesh;
  std::vector<Point> points;
  Mended mended;
  std::string policy;  ///< how the strips were kept; file: they are those of the file
};

Colored colored_as_in_file(Soup soup, const Mended& mended) {
  std::vector<std::uint32_t> origin;
  StripMesh mesh = StripMesh::build(soup.triangles, soup.points.size(), nullptr, &origin);
  color_as_in_file(mesh, soup, origin);
  return {std::move(mesh), std::move(soup.points), mended, "file"};
}

Colored colored_by_policy(const Source& source, const DrawCommand& command) {
  Plan::Given given;
  given.cost = command.cost;
  if (source.baked) given.baked = &*source.baked;
  const Plan plan(command.way.empty() ? usual_way(source.baked.has_value()) : way_named(command.way), source.mesh,
                  given);
  return {level_mesh(plan, command.triangles == 0 ? source.mesh.fine_triangles() : command.triangles),
          source.mesh.points, source.subject.mended, plan.way().name};
}

/// The built-in mesh where none is named, and the strips of the file where no others are asked for.
Colored colored(const DrawCommand& command) {
  if (command.mesh.empty()) return colored_by_policy(built_in_source(command), command);
  const bool others =
      command.triangles != 0 || command.simplify_given || !command.way.empty() || !(command.cost == Cost::strips());
  if (others || is_baked(command.mesh) || is_progressive(command.mesh))
    return colored_by_policy(source_of(command.mesh, command.mending, command.simplify, command.simplify_given),
                             command);
  Mended mended;
  Soup soup = read_mesh(command.mesh, command.mending, mended);
  if (!soup.strips.empty()) return colored_as_in_file(std::move(soup), mended);
  Source source = simplified(command.mesh.string(), std::move(soup), command.simplify);
  source.subject.mended = mended;
  return colored_by_policy(source, command);
}

/// What scripts/pictures.py draws: the mesh, its strips, and the rule of one split.
std::string facts_of(std::span<const Point> points, const std::vector<StripCorners>& strips) {
  // Six triangles, five of them in one strip that enters and leaves, the last one in a strip of its own.
  constexpr SplitPosition at{6, 3};
  constexpr Word loop = 0b001111;
  constexpr Word ports = 0b110001;
  nlohmann::ordered_json picture{
      {"points", nlohmann::ordered_json::array()},
      {"strips", strips},
      {"rule",
       {{"k", at.k}, {"a", at.a}, {"loop", loop}, {"ports", ports}, {"inner", split_rule(at, loop, ports).colors}}}};
  for (const Point& p : points) picture["points"].push_back({p.x, p.y, p.z});
  return picture.dump() + "\n";
}

}  // namespace

std::vector<std::string> drawn_extensions() {
  std::vector<std::string> all = picture_extensions();
  all.emplace_back(".json");
  return all;
}

int run(const DrawCommand& command) {
  const files::Output out(command.out, {drawn_extensions(), {command.mesh}});
  const ReportOutput report(command.json, {command.mesh, command.out});
  const std::string format = files::extension_of(command.out);
  if (format.empty())  // a device
    throw BadInput(fmt::format("{}: has no extension that names a format; name a file that ends in {}",
                               command.out.string(), fmt::join(drawn_extensions(), ", ")));
  const auto [mesh, points, mended, policy] = colored(command);
  if (const std::vector<std::string> faults = find_faults(mesh); !faults.empty()) {
    for (const std::string& fault : faults) fmt::print(stderr, "{}\n", fault);
    return 1;
  }
  const Strips order = extract_strips(mesh);
  std::vector<StripCorners> strips(order.size());
  for (std::size_t s = 0; s < order.size(); ++s)
    for (const Triangle t : order[s]) strips[s].push_back(mesh.corners(t));

  nlohmann::ordered_json json{{"triangles", mesh.triangle_count()}, {"strips", strips.size()}};
  std::string text = as_text(mended) + fmt::format("{}: {} triangles in {} strips", command.out.string(),
                                                   mesh.triangle_count(), strips.size());
  if (format == ".json") {
    out.write(facts_of(points, strips));
  } else {
    const Scene scene = scene_of(points, strips, command.camera, command.size, command.style);
    const Picture picture = picture_of(scene, format);
    out.write(picture.bytes);
    json["policy"] = policy;
    json["width"] = command.size.width;
    json["height"] = command.size.height;
    json["triangles_drawn"] = scene.faces.size();
    json["strips_shown"] = picture.strips;
    text +=
        fmt::format("; {} triangles face the camera, {} strips are in the picture", scene.faces.size(), picture.strips);
  }
  add_to(json, mended);
  report.print(text + "\n", json.dump(2) + "\n");
  return 0;
}

}  // namespace restrip::tools
