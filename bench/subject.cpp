#include "subject.hpp"

#include <map>

#include "made_mesh.hpp"
#include "mesh_file.hpp"
#include "restrip/stripify.hpp"
#include "settings.hpp"
#include "simplify.hpp"

namespace restrip::bench {
namespace {

std::filesystem::path file_of(const std::string& name) {
  return settings().meshes / (name == "dragon" ? "dragon_vrip.ply" : name + ".obj");
}

replay::Soup read(const std::string& name) {
  if (name == "made") return replay::make_mesh(settings().quick ? 2'000 : replay::default_made_triangles);
  return replay::read_mesh(file_of(name));
}

Subject make(const std::string& name) {
  Subject made;
  made.mesh = replay::simplify(read(name)).mesh;
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

const replay::BakedMesh& baked_subject(const std::string& name) {
  static std::map<std::string, replay::BakedMesh> made;
  const auto found = made.find(name);
  return found != made.end() ? found->second : made.emplace(name, replay::bake(subject(name).mesh)).first->second;
}

}  // namespace restrip::bench
