// `restrip draw`: draws a mesh and its strips, or writes the data from which scripts/pictures.py draws them.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "app/options.hpp"
#include "common/counted.hpp"
#include "common/output.hpp"
#include "lod/coloring_check.hpp"
#include "lod/mesh_files.hpp"
#include "meshes/made_mesh.hpp"
#include "meshes/soup_builder.hpp"
#include "meshes/strip_file.hpp"
#include "meshes/text_cursor.hpp"
#include "pictures/scene.hpp"
#include "replay/methods.hpp"
#include "replay/source.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/rules/rules.hpp"

namespace restrip::tools {
namespace {

/// Draws a mesh and its strips at one level (.svg, .png), or writes the data (.json) from which scripts/pictures.py
/// draws the picture in README: the mesh, its strips, and the rule of one split. A file with strips is drawn with them
/// unless the level, the policy, the cost or the base is named.
struct DrawCommand {
  NamedFile mesh;  ///< may be a progressive mesh; empty: the built-in mesh
  NamedFile out;
  SimplifyOptions simplify;
  bool simplify_given = false;
  std::string policy;         ///< its name; empty: the default (methods.hpp)
  std::optional<Cost> cost;   ///< the cost to minimise; by default what the policy supports
  std::size_t triangles = 0;  ///< minimum size of the level; 0: the finest level
  Camera camera;
  PictureSize size;
  MendingOptions mending;
  std::string json;
};

/// Moves each vertex to the mean of its neighbours, so that the jitter of the made mesh does not hide it in a picture.
void smooth(Soup& soup, int rounds) {
  for (; rounds > 0; --rounds) {
    std::vector<std::array<float, 3>> sum(soup.points.size());  // 32 bits, as in the shipped picture
    std::vector<float> count(soup.points.size(), 0);
    for (const Corners& t : soup.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Point& p = soup.points[t[(i + 1) % 3]];
        auto& [x, y, z] = sum[t[i]];
        x += static_cast<float>(p.x);
        y += static_cast<float>(p.y);
        z += static_cast<float>(p.z);
        count[t[i]] += 1;
      }
    }
    for (std::size_t v = 0; v < sum.size(); ++v)
      if (count[v] > 0) soup.points[v] = {sum[v][0] / count[v], sum[v][1] / count[v], sum[v][2] / count[v]};
  }
}

/// The data that scripts/pictures.py draws: the mesh, its strips, and the rule of one split.
std::string facts_of(std::span<const Point> points, const std::vector<StripCorners>& strips) {
  // Six triangles: five in one strip that enters and leaves, the sixth in a separate strip.
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

const std::vector<std::string> drawn_extensions{".svg", ".png", ".json"};

int run(const DrawCommand& command) {
  const files::Output out = open_output(command.out, drawn_extensions);
  Report report(command.json);
  const std::string format = command.out.extension();
  if (format.empty())  // a device
    throw BadInput(fmt::format("{}: its format is not known; name it by --to, or a file that ends in {}",
                               command.out.string(), fmt::join(drawn_extensions, ", ")));
  // The named mesh, or the built-in one, with the strips of the file unless the command asks for others.
  const bool others = command.triangles != 0 || command.simplify_given || !command.policy.empty() || command.cost;
  ReadMesh read;
  if (!command.mesh.empty()) read = read_mesh_file(command.mesh);
  auto* const soup = std::get_if<Soup>(&read);
  StripMesh mesh;
  Source source;
  std::string policy = "file";  // how the strips were kept; file: they come from the file
  if (soup != nullptr && !others && !soup->strips.empty()) {
    source.subject.mended = mend(*soup, command.mesh.string(), command.mending);
    std::vector<std::uint32_t> origin;
    mesh = StripMesh::build(soup->triangles, soup->points.size(), nullptr, &origin);
    color_as_in_file(mesh, *soup, origin);
    source.mesh.points = std::move(soup->points);
  } else {
    if (command.mesh.empty()) {
      constexpr std::size_t triangles_in_a_picture = 2400;
      Soup torus = make_mesh(triangles_in_a_picture);
      smooth(torus, 4);
      source = simplified("built-in torus", std::move(torus), command.simplify);
    } else {
      source = source_of(std::move(read), command.mesh, command.mending, command.simplify, command.simplify_given);
    }
    PreparedMethod::Given given;
    given.cost = command.cost;
    if (source.baked) given.baked = &*source.baked;
    const PreparedMethod prepared(
        command.policy.empty() ? default_method(source.baked.has_value()) : method_named(command.policy), source.mesh,
        given);
    mesh = level_mesh(prepared, command.triangles == 0 ? source.mesh.fine_triangles() : command.triangles);
    policy = prepared.method().name;
  }
  const std::vector<Point>& points = source.mesh.points;
  const Mended& mended = source.subject.mended;
  if (const std::vector<std::string> faults = find_faults(mesh); !faults.empty()) {
    for (const std::string& fault : faults) fmt::print(stderr, "{}\n", fault);
    return 1;
  }
  const Strips order = extract_strips(mesh);
  std::vector<StripCorners> strips(order.size());
  for (std::size_t s = 0; s < order.size(); ++s)
    for (const Triangle t : order[s]) strips[s].push_back(mesh.corners(t));

  report.json = {{"triangles", mesh.triangle_count()}, {"strips", strips.size()}};
  report.add(mended);
  report.text += fmt::format("{}: {} in {}", command.out.string(), counted(mesh.triangle_count(), "triangle"),
                             counted(strips.size(), "strip"));
  if (format == ".json") {
    out.write(facts_of(points, strips));
  } else {
    if (format != ".svg" && format != ".png")  // a pipe of any name
      throw BadInput(fmt::format("unknown extension '{}'; pictures are written as .svg, .png", format));
    const Scene scene = scene_of(points, strips, command.camera, command.size);
    const Picture picture = format == ".svg" ? svg_of(scene) : png_of(scene);
    out.write(picture.bytes);
    report.json["policy"] = policy;
    report.json["width"] = command.size.width;
    report.json["height"] = command.size.height;
    report.json["triangles_drawn"] = scene.faces.size();
    report.json["strips_shown"] = picture.strips;
    report.text += fmt::format("; {} the camera, {} in the picture",
                               counted(scene.faces.size(), "triangle faces", "triangles face"),
                               counted(picture.strips, "strip is", "strips are"));
  }
  report.text += "\n";
  report.print();
  return 0;
}

/// "a,b"
template <class Number>
std::optional<std::array<Number, 2>> two_numbers(const std::string& word) {
  const std::size_t comma = word.find(',');
  if (comma == std::string::npos) return std::nullopt;
  const auto first = parse<Number>(std::string_view(word).substr(0, comma));
  const auto second = parse<Number>(std::string_view(word).substr(comma + 1));
  if (!first || !second) return std::nullopt;
  return std::array<Number, 2>{*first, *second};
}

}  // namespace

Subcommand add_draw(CLI::App& app) {
  const auto kept = std::make_shared<DrawCommand>();
  DrawCommand& command = *kept;
  CLI::App* sub =
      app.add_subcommand("draw", "Draw a mesh at a level of detail, with its strips maintained as by replay");
  add_mesh_option(*sub, command.mesh, help_of_mesh(levels_kept) + "; without one a torus");
  add_output_option(*sub, command.out, drawn_extensions,
                    ".svg, .png, or .json: the mesh, its strips and a rule, from which scripts/pictures.py draws")
      ->required();
  sub->add_option("--triangles", command.triangles,
                  "the least number of triangles of the level (default: the finest level)")
      ->check(whole_number_from(1, max_triangles));
  add_simplify_options(*sub, command.simplify);
  add_policy_option(*sub, command.policy);
  add_cost_option(*sub, command.cost);
  const std::vector<const CLI::Option*> only_pictures{
      sub->add_option_function<std::string>(
             "--camera",
             [&command](const std::string& word) {
               const auto angles = two_numbers<double>(word);
               if (!angles || !(std::abs((*angles)[0]) <= 360) || !(std::abs((*angles)[1]) <= 90))
                 throw CLI::ValidationError(
                     "--camera", fmt::format("{} is not an azimuth from -360 to 360 and elevation from -90 to 90, in "
                                             "degrees, with a comma between",
                                             word));
               command.camera = {(*angles)[0], (*angles)[1]};
             },
             "in degrees: 0,0 looks along -z, 90,0 along -x, 0,90 down along -y")
          ->option_text(
              fmt::format("AZIMUTH,ELEVATION (default: {},{})", command.camera.azimuth, command.camera.elevation)),
      sub->add_option_function<std::string>(
             "--size",
             [&command](const std::string& word) {
               const auto sides = two_numbers<std::uint32_t>(word);
               if (!sides || std::min((*sides)[0], (*sides)[1]) < least_picture_side ||
                   std::max((*sides)[0], (*sides)[1]) > most_picture_side)
                 throw CLI::ValidationError(
                     "--size", fmt::format("{} is not a width and height from {} to {}, with a comma between", word,
                                           least_picture_side, most_picture_side));
               command.size = {(*sides)[0], (*sides)[1]};
             },
             "of the picture, in pixels")
          ->option_text(fmt::format("WIDTH,HEIGHT (default: {},{})", command.size.width, command.size.height))};
  add_mending_options(*sub, command.mending);
  add_json_option(*sub, command.json);
  sub->callback([sub, only_pictures, &command] {
    command.simplify_given = simplify_options_given(*sub);
    refuse_cost_elsewhere(command.cost, command.policy);
    for (const CLI::Option* option : only_pictures)
      if (!option->empty() && command.out.extension() == ".json")
        throw CLI::ValidationError(option->get_name(), "only pictures have one: .svg and .png");
  });
  sub->footer(
      "Triangles that face away from the camera are not drawn. A file that has strips is drawn with them, unless\n"
      "--triangles, --policy, --cost, --base or --boundary asks for others. --base 1 draws strips from scratch.\n"
      "Operation files are drawn by scripts/pictures.py.\n"
      "Example: restrip draw bunny.obj --policy quick --triangles 5000 --camera 20,10 -o bunny.png");
  return {sub, [kept] { return run(*kept); }};
}

}  // namespace restrip::tools
