#include "way.hpp"

namespace restrip::bench {

Player::Player(const std::string& name, Way way) : subject_(&subject(name)), way_(way) {
  if (way == Way::baked) baked_ = &baked_subject(name);
  mesh_.reserve(subject_->triangles, subject_->mesh.points.size());
  restart();
}

std::size_t Player::level_of(double share) const {
  const auto wanted = static_cast<std::size_t>(share * static_cast<double>(subject_->triangles));
  std::size_t triangles = subject_->mesh.base.size();
  std::size_t level = 0;
  for (const tools::Record& record : subject_->mesh.splits) {
    if (triangles >= wanted) break;
    triangles += record.v_l != none && record.v_r != none ? 2 : 1;
    ++level;
  }
  return level;
}

void Player::restart(const StripMesh& mesh, std::size_t level) {
  mesh_ = mesh;
  level_ = level;
  if (way_ == Way::baked)
    player_.emplace(mesh_, baked_->records, level);
  else if (way_ != Way::bare && way_ != Way::rules)
    keeper_.emplace(mesh_, policy_of(way_));
}

void Player::restart() { restart(way_ == Way::baked ? baked_->base : subject_->base, 0); }

void Player::up_to(std::size_t level) {
  const std::vector<tools::Record>& splits = subject_->mesh.splits;
  if (player_) {
    for (; level_ < level; ++level_) player_->split(level_, spokes_of(mesh_, splits[level_]), splits[level_].v_t);
    return;
  }
  with_operations(way_, mesh_, keeper_, [&](const auto& operations) {
    for (; level_ < level; ++level_) operations.split(spokes_of(mesh_, splits[level_]), splits[level_].v_t);
  });
}

void Player::down_to(std::size_t level) {
  const std::vector<tools::Record>& splits = subject_->mesh.splits;
  const auto chord = [&](std::size_t i) { return mesh_.spoke(splits[i].v_s, splits[i].v_t); };
  if (player_) {
    for (; level_ > level; --level_) player_->collapse(level_ - 1, chord(level_ - 1));
    return;
  }
  with_operations(way_, mesh_, keeper_, [&](const auto& operations) {
    for (; level_ > level; --level_) operations.collapse(chord(level_ - 1));
  });
}

}  // namespace restrip::bench
