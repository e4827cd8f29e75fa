#include "subject.hpp"

#include <map>
#include <tuple>

#include "lod/mesh_files.hpp"
#include "lod/simplify.hpp"
#include "meshes/made_mesh.hpp"
#include "restrip/search/stripify.hpp"
#include "settings.hpp"

namespace restrip::bench {
namespace {

std::filesystem::path file_of(const std::string& name) {
  return settings().meshes / (name == "dragon" ? "dragon_vrip.ply" : name + ".obj");
}

}  // namespace

std::vector<std::string> subject_names() {
  std::vector<std::string> names{"made"};
  if (settings().meshes.empty()) return names;
  for (const char* name : {"bunny", "dragon"})
    if (std::filesystem::exists(file_of(name))) names.emplace_back(name);
  return names;
}

const Subject& subject(const std::string& name) {
  static std::map<std::string, Subject> all;
  const auto [place, is_new] = all.try_emplace(name);
  Subject& made = place->second;
  if (!is_new) return made;
  made.mesh =
      tools::simplify(name == "made" ? tools::make_mesh(settings().quick ? 2'000 : tools::default_made_triangles)
                                     : tools::read_mesh(file_of(name)))
          .mesh;
  made.base = StripMesh::build(made.mesh.base, made.mesh.points.size());
  stripify(made.base, Effort::full, Cost::strips());
  made.triangles = made.mesh.fine_triangles();
  return made;
}

bool has_plan(const std::string& name, const tools::Way& way) { return name != "dragon" || !way.bakes; }

const tools::Plan& plan(const std::string& name, const tools::Way& way, const Cost& cost) {
  static std::map<std::tuple<std::string, std::string, unsigned, unsigned, unsigned>, tools::Plan> made;
  const std::tuple key{name, way.name, cost.restart, cost.swap, cost.isolated};
  const auto found = made.find(key);
  if (found != made.end()) return found->second;
  const Subject& of = subject(name);
  tools::Plan::Given given;
  given.cost = cost;
  if (cost == Cost::strips()) given.base = &of.base;
  return made.emplace(key, tools::Plan(way, of.mesh, given)).first->second;
}

}  // namespace restrip::bench
