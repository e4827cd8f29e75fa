#include "level_list.hpp"

#include <map>
#include <utility>

#include "way.hpp"

namespace restrip::bench {

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
