#include "lod/component_strips.hpp"

#include "restrip/mesh/walks.hpp"

namespace restrip::tools {

ComponentStrips::ComponentStrips(const StripMesh& mesh) : component_(mesh.triangle_bound(), none) {
  std::vector<Triangle> met;
  for (Triangle start = 0; start < mesh.triangle_bound(); ++start) {
    if (!mesh.alive(start) || component_[start] != none) continue;
    const auto number = static_cast<std::uint32_t>(components_.size());
    met.assign(1, start);
    component_[start] = number;
    for (std::size_t i = 0; i < met.size(); ++i)
      for_each_neighbor(mesh, met[i], [&](Triangle t) {
        if (component_[t] == none) met.push_back(t);
        component_[t] = number;
      });
    components_.push_back({0, tips(mesh, met)});
    needed_ += components_.back().needed();
  }
  recount(mesh);
}

std::ptrdiff_t ComponentStrips::tips(const StripMesh& mesh, const std::vector<Triangle>& patch) {
  std::ptrdiff_t tips = 0;
  for (const Triangle t : patch) {
    unsigned neighbors = 0;
    for_each_neighbor(mesh, t, [&](Triangle) { ++neighbors; });
    tips += neighbors < 2 ? 1 : 0;
  }
  return tips;
}

void ComponentStrips::recount(const StripMesh& mesh) {
  std::vector<std::ptrdiff_t> ends(components_.size(), 0);
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.alive(t)) ends[component_[t]] += 2 - static_cast<std::ptrdiff_t>(mesh.solid_degree(t));
  for (std::size_t i = 0; i < components_.size(); ++i) components_[i].strips = ends[i] / 2;
}

void ComponentStrips::before_split(const StripMesh& mesh, const std::vector<Triangle>& patch) {
  split_ = component_[patch.front()];
  Component& component = components_[split_];
  needed_ -= component.needed();
  component.tips -= tips(mesh, patch);
}

void ComponentStrips::after_split(const StripMesh& mesh, const std::vector<Triangle>& patch) {
  component_.resize(mesh.triangle_bound(), none);
  for (const Triangle t : patch) component_[t] = split_;
  Component& component = components_[split_];
  component.tips += tips(mesh, patch);
  needed_ += component.needed();
}

}  // namespace restrip::tools
