#include "draw.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

#include "restrip/strips.hpp"

namespace restrip::replay {
namespace {

struct Place {
  double x = 0;
  double y = 0;
};

Place middle(const Place& a, const Place& b, const Place& c) { return {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3}; }
Place between(const Place& a, const Place& b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2}; }

std::string triangle(const Place& a, const Place& b, const Place& c, const std::string& fill) {
  return fmt::format(
      "<polygon points=\"{:.1f},{:.1f} {:.1f},{:.1f} {:.1f},{:.1f}\" fill=\"{}\" stroke=\"#444\" "
      "stroke-width=\"0.7\"/>\n",
      a.x, a.y, b.x, b.y, c.x, c.y, fill);
}

std::string dual_edge(const Place& a, const Place& b, bool solid) {
  return fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" stroke-width=\"{}\"{}/>\n", a.x, a.y,
      b.x, b.y, solid ? "#c2185b" : "#777", solid ? 5 : 2, solid ? "" : " stroke-dasharray=\"5 5\"");
}

std::string node(const Place& at) {
  return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\" fill=\"#c2185b\"/>\n", at.x, at.y);
}

/// Colours that differ from one strip to the next: hues by the golden ratio.
std::string color_of(std::size_t strip) {
  const double turn = 0.618033988749895 * static_cast<double>(strip + 1);
  return fmt::format("hsl({:.0f} 65% {}%)", 360 * (turn - std::floor(turn)), 55 + 12 * (strip % 3));
}

/// Triangles with their dual graph on top.
class Patch {
 public:
  std::size_t add(const Place& a, const Place& b, const Place& c, bool is_new) {
    triangles_ += triangle(a, b, c, is_new ? "#ffe082" : "#e3f2fd");
    nodes_.push_back(middle(a, b, c));
    return nodes_.size() - 1;
  }
  void join(std::size_t i, std::size_t j, const Place& across, bool solid) {
    edges_ += dual_edge(nodes_[i], across, solid) + dual_edge(across, nodes_[j], solid);
  }
  void port(std::size_t i, const Place& a, const Place& b, bool solid) {
    const Place door = between(a, b);
    edges_ +=
        dual_edge(nodes_[i], {door.x + (door.x - nodes_[i].x) * 0.7, door.y + (door.y - nodes_[i].y) * 0.7}, solid);
  }
  [[nodiscard]] std::string text() const {
    std::string all = triangles_ + edges_;
    for (const Place& at : nodes_) all += node(at);
    return all;
  }

 private:
  std::string triangles_;
  std::string edges_;
  std::vector<Place> nodes_;
};

/// The rim of a fan, counter-clockwise as seen (y points down in a drawing), turned so that the first arc is below.
std::vector<Place> rim_of(const SplitPosition& at) {
  const double step = 2 * std::numbers::pi / static_cast<double>(at.k);
  const double start = std::numbers::pi / 2 + step * static_cast<double>(at.a) / 2;
  std::vector<Place> places;
  for (std::size_t i = 0; i < at.k; ++i) {
    const double angle = start - step * static_cast<double>(i);
    places.push_back({200 + 150 * std::cos(angle), 200 + 150 * std::sin(angle)});
  }
  return places;
}

std::string fan_on(const std::vector<Place>& places, Word loop, Word ports) {
  const std::size_t k = places.size();
  const Place center{200, 200};
  Patch patch;
  for (std::size_t i = 0; i < k; ++i) patch.add(center, places[i], places[(i + 1) % k], false);
  for (std::size_t i = 0; i < k; ++i) {
    patch.join(i, (i + 1) % k, between(center, places[(i + 1) % k]), has(loop, i));
    patch.port(i, places[i], places[(i + 1) % k], has(ports, i));
  }
  return patch.text();
}

}  // namespace

std::string draw_fan(SplitPosition at, Word loop, Word ports) { return fan_on(rim_of(at), loop, ports); }

std::string draw_split(SplitPosition at, Word loop, Word ports) {
  const std::size_t k = at.k;
  const std::size_t a = at.a;
  const Word inner = split_rule(at, loop, ports).colors;
  const std::vector<Place> places = rim_of(at);
  // v_s owns the first arc, v_t the second; each moves toward its own side.
  const auto toward = [&](std::size_t first, std::size_t last) {
    Place sum;
    for (std::size_t i = first; i <= last; ++i) {
      sum.x += places[i % k].x;
      sum.y += places[i % k].y;
    }
    const auto n = static_cast<double>(last - first + 1);
    return Place{200 + (sum.x / n - 200) * 0.45, 200 + (sum.y / n - 200) * 0.45};
  };
  const Place v_s = toward(0, a);
  const Place v_t = toward(a, k);
  Patch patch;
  for (std::size_t i = 0; i < k; ++i) patch.add(i < a ? v_s : v_t, places[i], places[(i + 1) % k], false);
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
    patch.join(ring[j], ring[(j + 1) % (k + 2)], between(first ? v_s : v_t, places[spoke % k]), has(inner, j));
  }
  patch.join(node_a, node_d, between(v_s, v_t), has(inner, k + 2));
  for (std::size_t i = 0; i < k; ++i) patch.port(i, places[i], places[(i + 1) % k], has(ports, i));
  return patch.text();
}

std::string draw_mesh(const StripMesh& mesh, const std::vector<Point>& points) {
  // Seen from above and in front; the depth decides what hides what.
  const auto seen = [](const Point& p) {
    constexpr double tilt = 0.9;
    const double y = static_cast<double>(p.y);
    const double z = static_cast<double>(p.z);
    return std::array<double, 3>{static_cast<double>(p.x), y * std::cos(tilt) - z * std::sin(tilt),
                                 y * std::sin(tilt) + z * std::cos(tilt)};
  };
  std::array<double, 4> box{1e300, -1e300, 1e300, -1e300};
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    if (!mesh.alive(t)) continue;
    for (const Vertex v : mesh.corners(t)) {
      const auto at = seen(points[v]);
      box = {std::min(box[0], at[0]), std::max(box[1], at[0]), std::min(box[2], at[1]), std::max(box[3], at[1])};
    }
  }
  const double scale = (drawing_size - 20) / std::max({box[1] - box[0], box[3] - box[2], 1e-30});
  const auto place = [&](const std::array<double, 3>& at) {
    return Place{drawing_size / 2 + (at[0] - (box[0] + box[1]) / 2) * scale,
                 drawing_size / 2 - (at[1] - (box[2] + box[3]) / 2) * scale};
  };
  struct Face {
    double depth = 0;
    Triangle triangle = 0;
    std::size_t strip = 0;
  };
  std::vector<Face> faces;
  const Strips strips = extract_strips(mesh);
  for (std::size_t s = 0; s < strips.size(); ++s) {
    for (const Triangle t : strips[s]) {
      const auto [a, b, c] = mesh.corners(t);
      const auto p = seen(points[a]);
      const auto q = seen(points[b]);
      const auto r = seen(points[c]);
      const double facing = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
      if (facing > 0) faces.push_back({p[2] + q[2] + r[2], t, s});
    }
  }
  std::sort(faces.begin(), faces.end(), [](const Face& x, const Face& y) {
    return x.depth != y.depth ? x.depth < y.depth : x.triangle < y.triangle;
  });
  std::string text;
  for (const Face& face : faces) {
    const auto [a, b, c] = mesh.corners(face.triangle);
    text += triangle(place(seen(points[a])), place(seen(points[b])), place(seen(points[c])), color_of(face.strip));
  }
  return text;
}

std::string svg_of(const std::vector<Panel>& panels) {
  const double width = drawing_size * static_cast<double>(panels.size());
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"sans-serif\" "
      "font-size=\"17\">\n"
      "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"#fff\"/>\n",
      width, drawing_size + 40);
  for (std::size_t i = 0; i < panels.size(); ++i)
    text += fmt::format(
        "<g transform=\"translate({:.0f} 0)\">\n{}<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"middle\" "
        "fill=\"#222\">{}</text>\n</g>\n",
        drawing_size * static_cast<double>(i), panels[i].drawing, drawing_size / 2, drawing_size + 22,
        panels[i].caption);
  return text + "</svg>\n";
}

}  // namespace restrip::replay
