#include "paper/draw.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "paper/patch_drawing.hpp"
#include "restrip/output/strips.hpp"

namespace restrip::tools {
namespace {

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

std::string text_of(const PatchDrawing& drawing) {
  std::string text;
  for (const PatchDrawing::Face& face : drawing.faces)
    text += triangle(face.a, face.b, face.c, face.is_new ? "#ffe082" : "#e3f2fd");
  for (const PatchDrawing::Stroke& stroke : drawing.strokes) text += dual_edge(stroke.from, stroke.to, stroke.solid);
  for (const Place& at : drawing.nodes) text += node(at);
  return text;
}

}  // namespace

std::string draw_fan(SplitPosition at, Word loop, Word ports) { return text_of(fan_drawing(at, loop, ports)); }

std::string draw_split(SplitPosition at, Word loop, Word ports) {
  return text_of(split_drawing(at, split_rule(at, loop, ports).colors, ports));
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

}  // namespace restrip::tools
