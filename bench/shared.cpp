#include "shared.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <span>
#include <utility>

#include "common/random.hpp"
#include "lod/mesh_files.hpp"
#include "lod/simplify.hpp"
#include "meshes/made_mesh.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/rules/rules.hpp"

namespace restrip::bench {
namespace {

std::filesystem::path file_of(const std::string& name) {
  return settings().meshes / (name == "dragon" ? "dragon_vrip.ply" : name + ".obj");
}

/// The parts of a mesh that collapses change: the triangles around both ends, and the spokes of the apexes.
class Claims {
 public:
  explicit Claims(const StripMesh& mesh)
      : mesh_(mesh), triangles_(mesh.triangle_bound(), false), apexes_(mesh.vertex_bound(), false) {}

  /// False, and nothing is claimed, if an earlier collapse changes a part of the same.
  bool claim(StripMesh::Halfedge chord) {
    const StripMesh::Halfedge back = mesh_.opposite(chord);
    edge_triangles(mesh_, chord, patch_);
    const std::array apexes{mesh_.to(StripMesh::next(chord)), mesh_.to(StripMesh::next(back))};
    const auto taken = [this](Triangle t) { return triangles_[t]; };
    if (std::any_of(patch_.begin(), patch_.end(), taken) || apexes_[apexes[0]] || apexes_[apexes[1]]) return false;
    for (const Triangle t : patch_) triangles_[t] = true;
    for (const Vertex v : apexes) apexes_[v] = true;
    return true;
  }

 private:
  const StripMesh& mesh_;
  std::vector<bool> triangles_;
  std::vector<bool> apexes_;
  std::vector<Triangle> patch_;
};

/// Adds a collapse if it is legal, interior and apart from those before, and leaves a fan that the tables know: on real
/// meshes most splits are of such fans, while the edges of a made mesh, picked at random, would have many larger ones.
void add_site(const StripMesh& mesh, Claims& claims, StripMesh::Halfedge chord, Sites& sites) {
  if (check_collapse(mesh, chord) != Refusal::granted || mesh.leaves_boundary(chord) ||
      mesh.leaves_boundary(mesh.opposite(chord)) ||
      spoke_count(mesh, mesh.from(chord)) + spoke_count(mesh, mesh.to(chord)) > table_max_k + 4 || !claims.claim(chord))
    return;
  const StripMesh::Halfedge back = mesh.opposite(chord);
  sites.chords.push_back(chord);
  sites.records.push_back(
      {mesh.from(chord), mesh.to(chord), mesh.to(StripMesh::next(chord)), mesh.to(StripMesh::next(back))});
}

}  // namespace

const Settings& settings() {
  static const Settings given = [] {
    Settings s;
    s.quick = std::getenv("RESTRIP_BENCH_QUICK") != nullptr;
    if (const char* folder = std::getenv("RESTRIP_MESHES"); folder != nullptr && !s.quick) s.meshes = folder;
    return s;
  }();
  return given;
}

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
  made.triangles = made.mesh.fine_triangles();
  return made;
}

bool is_measured(const std::string& name, const Method& method) { return name != "dragon" || !method.bakes; }

const tools::PreparedMethod& prepared(const std::string& name, const Method& method) {
  static std::map<std::pair<std::string, std::string>, tools::PreparedMethod> made;
  const std::pair key{name, method.name};
  const auto found = made.find(key);
  if (found != made.end()) return found->second;
  return made.emplace(key, tools::PreparedMethod(method, subject(name).mesh, {})).first->second;
}

Player::Player(const std::string& name, const Method& method)
    : subject_(&subject(name)), prepared_(&prepared(name, method)) {
  mesh_.reserve(subject_->triangles, subject_->mesh.points.size());
  restart();
}

std::size_t Player::level_of(double share) const {
  return subject_->mesh.splits_to(static_cast<std::size_t>(share * static_cast<double>(subject_->triangles)));
}

void Player::restart(const StripMesh& mesh, std::size_t level) {
  mesh_ = mesh;
  level_ = level;
  maintainer_ = prepared_->begin(mesh_);
  maintainer_->restart(level);
}

void Player::restart() { restart(prepared_->base(), 0); }

void Player::up_to(std::size_t level) {
  maintainer_->play_up(std::span(subject_->mesh.splits).subspan(level_, level - level_), level_);
  level_ = level;
}

void Player::down_to(std::size_t level) {
  maintainer_->play_down(std::span(subject_->mesh.splits).subspan(level, level_ - level), level);
  level_ = level;
}

const LevelList& level_list(const std::string& name, int percent) {
  static std::map<std::pair<std::string, int>, LevelList> made;
  const std::pair key{name, percent};
  if (made.contains(key)) return made[key];
  Player player(name, method_named("bare"));
  player.up_to(player.level_of(percent * 0.01));
  LevelList& list = made[key];
  list.mesh = player.mesh();
  std::vector<std::uint32_t> number(list.mesh.vertex_bound(), none);
  for (Triangle t = 0; t < list.mesh.triangle_bound(); ++t) {
    if (!list.mesh.alive(t)) continue;
    for (const Vertex v : list.mesh.corners(t)) {
      if (number[v] == none) number[v] = static_cast<std::uint32_t>(list.vertices++);
      list.indices.push_back(number[v]);
    }
  }
  return list;
}

Sites spread_out_sites(const StripMesh& mesh, std::size_t count) {
  tools::Random random(1);
  Claims claims(mesh);
  Sites sites;
  const auto triangles = static_cast<std::uint32_t>(mesh.triangle_bound());
  for (std::size_t tries = 0; sites.size() < count && tries < 16 * count; ++tries) {
    add_site(mesh, claims, StripMesh::halfedge(random.below(triangles), random.below(3)), sites);
  }
  return sites;
}

Sites neighboring_sites(const StripMesh& mesh, std::size_t count) {
  Claims claims(mesh);
  Sites sites;
  for (Triangle t = 0; t < mesh.triangle_bound() && sites.size() < count; ++t)
    add_site(mesh, claims, StripMesh::halfedge(t, 0), sites);
  return sites;
}

}  // namespace restrip::bench

int main(int count, char** values) {
  benchmark::Initialize(&count, values);
  if (benchmark::ReportUnrecognizedArguments(count, values)) return 1;
  restrip::bench::register_benchmarks();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
