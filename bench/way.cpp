#include "way.hpp"

#include <map>
#include <span>
#include <utility>

namespace restrip::bench {

Player::Player(const std::string& name, const Way& way, const Cost& cost)
    : subject_(&subject(name)), plan_(&plan(name, way, cost)) {
  mesh_.reserve(subject_->triangles, subject_->mesh.points.size());
  restart();
}

std::size_t Player::level_of(double share) const {
  return subject_->mesh.splits_to(static_cast<std::size_t>(share * static_cast<double>(subject_->triangles)));
}

void Player::restart(const StripMesh& mesh, std::size_t level) {
  mesh_ = mesh;
  level_ = level;
  upkeep_ = plan_->begin(mesh_);
  upkeep_->restart(level);
}

void Player::restart() { restart(plan_->base(), 0); }

void Player::up_to(std::size_t level) {
  upkeep_->play_up(std::span(subject_->mesh.splits).subspan(level_, level - level_), level_);
  level_ = level;
}

void Player::down_to(std::size_t level) {
  upkeep_->play_down(std::span(subject_->mesh.splits).subspan(level, level_ - level), level);
  level_ = level;
}

const LevelList& level_list(const std::string& name, int percent) {
  static std::map<std::pair<std::string, int>, LevelList> made;
  const std::pair key{name, percent};
  if (made.contains(key)) return made[key];
  Player player(name, way_named("bare"));
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

}  // namespace restrip::bench
