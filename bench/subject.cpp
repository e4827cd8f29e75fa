#include "subject.hpp"

#include <map>

#include "lod/simplify.hpp"
#include "meshes/made_mesh.hpp"
#include "meshes/mesh_file.hpp"
#include "restrip/search/stripify.hpp"
#include "settings.hpp"

namespace restrip::bench {
namespace {

std::filesystem::path file_of(const std::string& name) {
  return settings().meshes / (name == "dragon" ? "dragon_vrip.ply" : name + ".obj");
}

tools::Soup read(const std::string& name) {
  if (name == "made") return tools::make_mesh(settings().quick ? 2'000 : tools::default_made_triangles);
  return tools::read_mesh(file_of(name));
}

Subject make(const std::string& name) {
  Subject made;
  made.mesh = tools::simplify(read(name)).mesh;
  made.base = StripMesh::build(made.mesh.base, made.mesh.points.size());
  stripify(made.base, Effort::full);
  made.triangles = made.mesh.fine_triangles();
  return made;
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
  static std::map<std::string, Subject> made;
  const auto found = made.find(name);
  return found != made.end() ? found->second : made.emplace(name, make(name)).first->second;
}

bool has_baked(const std::string& name) { return name != "dragon"; }

const tools::BakedMesh& baked_subject(const std::string& name) {
  static std::map<std::string, tools::BakedMesh> made;
  const auto found = made.find(name);
  return found != made.end() ? found->second : made.emplace(name, tools::bake(subject(name).mesh)).first->second;
}

}  // namespace restrip::bench
