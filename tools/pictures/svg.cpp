#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "pictures/scene.hpp"

namespace restrip::tools {

Picture svg_of(const Scene& scene) {
  const auto hex = [](const Color& c) { return fmt::format("#{:02x}{:02x}{:02x}", c.red, c.green, c.blue); };
  constexpr double seam = 0.6;  // covers the gaps that antialiasing leaves between polygons
  const bool edges = scene.edge_width > 0;
  std::string svg = fmt::format(
      R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0}" height="{1}" viewBox="0 0 {0} {1}">)"
      "\n"
      R"(<rect width="{0}" height="{1}" fill="{2}"/>)"
      "\n"
      R"(<g stroke="{3}" stroke-width="{4:.2f}" stroke-linejoin="round" stroke-linecap="round">)"
      "\n",
      scene.size.width, scene.size.height, hex(background_color), hex(edge_color), edges ? scene.edge_width : seam);
  auto out = std::back_inserter(svg);
  std::vector<bool> shown(scene.colors.size());
  for (const Face& face : scene.faces) {
    const std::string color = hex(scene.colors[face.strip]);
    const std::string fill = scene.style == StripStyle::faces ? color : hex(surface_color);
    const auto& [p, q, r] = face.corners;
    fmt::format_to(out, R"(<polygon points="{:.2f},{:.2f} {:.2f},{:.2f} {:.2f},{:.2f}" fill="{}"{}/>)", p.x, p.y, q.x,
                   q.y, r.x, r.y, fill, edges ? "" : fmt::format(R"( stroke="{}")", fill));
    svg += '\n';
    shown[face.strip] = true;
    if (scene.style == StripStyle::faces) continue;
    // From door to door through the centre; a dot for an isolated triangle.
    const Spot center = center_of(face);
    fmt::format_to(out, R"(<path fill="none" stroke="{}" stroke-width="{:.2f}" d=")", color, scene.line_width);
    if (face.door_count == 2) fmt::format_to(out, "M{:.2f},{:.2f}L", face.doors[1].x, face.doors[1].y);
    fmt::format_to(out, "{}{:.2f},{:.2f}", face.door_count == 2 ? "" : "M", center.x, center.y);
    if (face.door_count == 0)
      svg += "h0";
    else
      fmt::format_to(out, "L{:.2f},{:.2f}", face.doors[0].x, face.doors[0].y);
    svg += "\"/>\n";
  }
  svg += "</g>\n</svg>\n";
  return {std::move(svg), static_cast<std::size_t>(std::count(shown.begin(), shown.end(), true))};
}

}  // namespace restrip::tools
