#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "pictures/scene.hpp"

namespace restrip::tools {
namespace {

/// The distance of a point of the plane from the segment p q, in pixels.
double distance_from(const Spot& p, const Spot& q, double x, double y) noexcept {
  const double along_x = q.x - p.x;
  const double along_y = q.y - p.y;
  const double square = along_x * along_x + along_y * along_y;
  const double share = square > 0 ? std::clamp(((x - p.x) * along_x + (y - p.y) * along_y) / square, 0.0, 1.0) : 0.0;
  return std::hypot(x - p.x - share * along_x, y - p.y - share * along_y);
}

constexpr std::uint32_t no_face = 0xFFFF'FFFF;

/// The number of the visible face at each pixel.
std::vector<std::uint32_t> visible_faces(const Scene& scene) {
  const auto [width, height] = scene.size;
  std::vector<std::uint32_t> faces(std::size_t{width} * height, no_face);
  std::vector<double> depths(faces.size(), -std::numeric_limits<double>::infinity());
  const auto first = [](double a, double b, double c) {
    return static_cast<std::uint32_t>(std::max(0.0, std::floor(std::min({a, b, c}))));
  };
  const auto last = [](double a, double b, double c, std::uint32_t side) {
    return static_cast<std::uint32_t>(std::min(static_cast<double>(side), std::ceil(std::max({a, b, c}))));
  };
  for (std::size_t number = 0; number < scene.faces.size(); ++number) {
    const auto& [p, q, r] = scene.faces[number].corners;
    const std::uint32_t left = first(p.x, q.x, r.x);
    const std::uint32_t right = last(p.x, q.x, r.x, width);
    const std::uint32_t low = last(p.y, q.y, r.y, height);
    for (std::uint32_t y = first(p.y, q.y, r.y); y < low; ++y)
      for (std::uint32_t x = left; x < right; ++x) {
        const auto side = [at_x = x + 0.5, at_y = y + 0.5](const Spot& from, const Spot& to) {  // positive inside
          return (to.y - from.y) * (at_x - from.x) - (to.x - from.x) * (at_y - from.y);
        };
        const double of_p = side(q, r);
        const double of_q = side(r, p);
        const double of_r = side(p, q);
        // A pixel on an edge belongs to both triangles, however the sums are rounded.
        constexpr double on_edge = -1e-9;
        const double sum = of_p + of_q + of_r;
        if (std::min({of_p, of_q, of_r}) < on_edge * sum) continue;
        const double depth = (of_p * p.depth + of_q * q.depth + of_r * r.depth) / sum;
        const std::size_t at = std::size_t{y} * width + x;
        if (depth <= depths[at]) continue;
        depths[at] = depth;
        faces[at] = static_cast<std::uint32_t>(number);
      }
  }
  return faces;
}

}  // namespace

Picture png_of(const Scene& scene) {
  if (scene.faces.size() >= no_face) throw std::runtime_error("a picture of too many triangles");
  // Thinner edges would have gaps: the nearest pixel may be half a diagonal away.
  const double edge = scene.edge_width > 0 ? std::max(scene.edge_width / 2, 0.5) : 0;
  const double line = std::max(scene.line_width / 2, 0.75);
  const std::vector<std::uint32_t> visible = visible_faces(scene);
  std::vector<Color> pixels(visible.size(), background_color);
  std::vector<bool> shown(scene.colors.size());
  for (std::size_t at = 0; at < visible.size(); ++at) {
    if (visible[at] == no_face) continue;
    const Face& face = scene.faces[visible[at]];
    const double x = static_cast<double>(at % scene.size.width) + 0.5;
    const std::size_t row = at / scene.size.width;
    const double y = static_cast<double>(row) + 0.5;
    bool is_edge = false;
    for (std::size_t i = 0; i < 3; ++i)
      is_edge = is_edge || distance_from(face.corners[i], face.corners[(i + 1) % 3], x, y) < edge;
    bool is_strip = !is_edge;
    if (scene.style == StripStyle::lines) {
      const Spot center = center_of(face);
      double nearest = std::hypot(x - center.x, y - center.y);
      for (std::size_t i = 0; i < face.door_count; ++i)
        nearest = std::min(nearest, distance_from(center, face.doors[i], x, y));
      is_strip = nearest < line;
    }
    pixels[at] = is_strip ? scene.colors[face.strip] : is_edge ? edge_color : surface_color;
    if (is_strip) shown[face.strip] = true;
  }

  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = scene.size.width;
  image.height = scene.size.height;
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t bytes = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string png(bytes, '\0');
  static_assert(sizeof(Color) == 3);
  if (png_image_write_to_memory(&image, png.data(), &bytes, 0, pixels.data(), 0, nullptr) == 0)
    throw std::runtime_error(fmt::format("libpng could not make the picture: {}", image.message));
  png.resize(bytes);
  return {std::move(png), static_cast<std::size_t>(std::count(shown.begin(), shown.end(), true))};
}

}  // namespace restrip::tools
