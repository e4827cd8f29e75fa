#include "paper/patch_drawing.hpp"

#include <cmath>
#include <numbers>

namespace restrip::tools {
namespace {

Place middle(const Place& a, const Place& b, const Place& c) { return {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3}; }
Place between(const Place& a, const Place& b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2}; }

/// Triangles with their dual graph on top.
class Patch {
 public:
  std::size_t add(const Place& a, const Place& b, const Place& c, bool is_new) {
    drawing_.faces.push_back({a, b, c, is_new});
    drawing_.nodes.push_back(middle(a, b, c));
    return drawing_.nodes.size() - 1;
  }
  void join(std::size_t i, std::size_t j, const Place& across, bool solid) {
    drawing_.strokes.push_back({node(i), across, solid});
    drawing_.strokes.push_back({across, node(j), solid});
  }
  void port(std::size_t i, const Place& a, const Place& b, bool solid) {
    const Place door = between(a, b);
    drawing_.strokes.push_back(
        {node(i), {door.x + (door.x - node(i).x) * 0.7, door.y + (door.y - node(i).y) * 0.7}, solid});
  }
  [[nodiscard]] PatchDrawing drawing() && { return std::move(drawing_); }

 private:
  [[nodiscard]] const Place& node(std::size_t i) const { return drawing_.nodes[i]; }

  PatchDrawing drawing_;
};

/// The rim of a fan, counter-clockwise as seen (y points down in a drawing), turned so that the first arc is below. It
/// is closed: k + 1 places, the last one the first again, so that triangle i lies between places i and i + 1.
std::vector<Place> rim_of(const SplitPosition& at) {
  const double step = 2 * std::numbers::pi / static_cast<double>(at.k);
  const double start = std::numbers::pi / 2 + step * static_cast<double>(at.a) / 2;
  std::vector<Place> places;
  for (std::size_t i = 0; i < at.k; ++i) {
    const double angle = start - step * static_cast<double>(i);
    places.push_back({200 + 150 * std::cos(angle), 200 + 150 * std::sin(angle)});
  }
  places.push_back(places.front());
  return places;
}

}  // namespace

PatchDrawing fan_drawing(SplitPosition at, Word loop, Word ports) {
  const std::vector<Place> places = rim_of(at);
  const std::size_t k = at.k;
  const Place center{200, 200};
  Patch patch;
  for (std::size_t i = 0; i < k; ++i) patch.add(center, places[i], places[i + 1], false);
  for (std::size_t i = 0; i < k; ++i) {
    patch.join(i, (i + 1) % k, between(center, places[i + 1]), has(loop, i));
    patch.port(i, places[i], places[i + 1], has(ports, i));
  }
  return std::move(patch).drawing();
}

PatchDrawing split_drawing(SplitPosition at, Word inner, Word ports) {
  const std::size_t k = at.k;
  const std::size_t a = at.a;
  const std::vector<Place> places = rim_of(at);
  // v_s owns the first arc, v_t the second; each moves toward its own side.
  const auto toward = [&](std::size_t first, std::size_t last) {
    Place sum;
    for (std::size_t i = first; i <= last; ++i) {
      sum.x += places[i].x;
      sum.y += places[i].y;
    }
    const auto n = static_cast<double>(last - first + 1);
    return Place{200 + (sum.x / n - 200) * 0.45, 200 + (sum.y / n - 200) * 0.45};
  };
  const Place v_s = toward(0, a);
  const Place v_t = toward(a, k);
  Patch patch;
  for (std::size_t i = 0; i < k; ++i) patch.add(i < a ? v_s : v_t, places[i], places[i + 1], false);
  const std::size_t node_a = patch.add(v_s, v_t, places[0], true);
  const std::size_t node_d = patch.add(v_t, v_s, places[a], true);
  // Around the ring: A, the first arc, D, the second arc.
  std::vector<std::size_t> ring{node_a};
  for (std::size_t i = 0; i < a; ++i) ring.push_back(i);
  ring.push_back(node_d);
  for (std::size_t i = a; i < k; ++i) ring.push_back(i);
  for (std::size_t j = 0; j < k + 2; ++j) {
    const bool first = j <= a;
    const std::size_t spoke = first ? j : j - 1;
    patch.join(ring[j], ring[(j + 1) % (k + 2)], between(first ? v_s : v_t, places[spoke]), has(inner, j));
  }
  patch.join(node_a, node_d, between(v_s, v_t), has(inner, k + 2));
  for (std::size_t i = 0; i < k; ++i) patch.port(i, places[i], places[i + 1], has(ports, i));
  return std::move(patch).drawing();
}

}  // namespace restrip::tools
