#include "pictures/scene.hpp"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace restrip::tools {
namespace {

Spot middle(const Spot& p, const Spot& q) noexcept {
  return {(p.x + q.x) / 2, (p.y + q.y) / 2, (p.depth + q.depth) / 2};
}

/// Colours of strips by number: hues a golden ratio apart, in three lightnesses. About a thousand differ.
Color color_of(std::size_t strip) {
  const double turns = std::numbers::phi * static_cast<double>(strip + 1);
  const double hue = 12 * (turns - std::floor(turns));  // in twelfths of the circle
  constexpr double saturation = 0.65;
  const double lightness = 0.55 + 0.12 * static_cast<double>(strip % 3);
  const double spread = saturation * std::min(lightness, 1 - lightness);
  const auto channel = [&](double begin) {
    const double at = std::fmod(begin + hue, 12.0);
    return static_cast<std::uint8_t>(
        std::lround(255 * (lightness - spread * std::clamp(std::min(at - 3, 9 - at), -1.0, 1.0))));
  };
  return {channel(0), channel(8), channel(4)};
}

/// Projects the mesh into the picture.
class Projection {
 public:
  Projection(std::span<const Point> points, std::span<const StripCorners> strips, const Camera& camera,
             const PictureSize& size) {
    const double azimuth = camera.azimuth * std::numbers::pi / 180;
    const double elevation = camera.elevation * std::numbers::pi / 180;
    right_ = {std::cos(azimuth), 0, -std::sin(azimuth)};
    up_ = {-std::sin(elevation) * std::sin(azimuth), std::cos(elevation), -std::sin(elevation) * std::cos(azimuth)};
    near_ = {std::cos(elevation) * std::sin(azimuth), std::sin(elevation), std::cos(elevation) * std::cos(azimuth)};
    constexpr double far_off = std::numeric_limits<double>::infinity();
    Spot low{far_off, far_off, 0};
    Spot high{-far_off, -far_off, 0};
    for (const StripCorners& strip : strips)
      for (const Corners& t : strip)
        for (const std::uint32_t v : t) {
          const Spot s = turned(points[v]);
          low = {std::min(low.x, s.x), std::min(low.y, s.y), 0};
          high = {std::max(high.x, s.x), std::max(high.y, s.y), 0};
        }
    if (low.x > high.x) return;  // nothing is visible
    const auto width = static_cast<double>(size.width);
    const auto height = static_cast<double>(size.height);
    const double margin = std::min(width, height) / 40;
    const double tiny = std::numeric_limits<double>::min();
    scale_ = std::min((width - 2 * margin) / std::max(high.x - low.x, tiny),
                      (height - 2 * margin) / std::max(high.y - low.y, tiny));
    middle_ = middle(low, high);
    to_ = {width / 2, height / 2, 0};
  }

  [[nodiscard]] Spot operator()(const Point& p) const noexcept {
    const Spot s = turned(p);
    return {to_.x + scale_ * (s.x - middle_.x), to_.y - scale_ * (s.y - middle_.y), scale_ * s.depth};
  }

 private:
  using Axis = std::array<double, 3>;
  static double along(const Axis& axis, const Point& p) noexcept {
    return axis[0] * p.x + axis[1] * p.y + axis[2] * p.z;
  }
  [[nodiscard]] Spot turned(const Point& p) const noexcept {
    return {along(right_, p), along(up_, p), along(near_, p)};
  }

  Axis right_{};
  Axis up_{};
  Axis near_{};  ///< towards the camera
  double scale_ = 1;
  Spot middle_;
  Spot to_;
};

}  // namespace

Spot center_of(const Face& face) noexcept {
  const auto& [p, q, r] = face.corners;
  return {(p.x + q.x + r.x) / 3, (p.y + q.y + r.y) / 3, (p.depth + q.depth + r.depth) / 3};
}

Scene scene_of(std::span<const Point> points, std::span<const StripCorners> strips, const Camera& camera,
               const PictureSize& size) {
  const Projection project(points, strips, camera, size);
  Scene scene{size, {}, {}};
  for (std::size_t s = 0; s < strips.size(); ++s) {
    scene.colors.push_back(color_of(s));
    for (const Corners& t : strips[s]) {
      const Face face{{project(points[t[0]]), project(points[t[1]]), project(points[t[2]])}, s};
      // Twice the area, positive if the corners are counter-clockwise as seen: y points down.
      const auto& [p, q, r] = face.corners;
      if ((r.x - p.x) * (q.y - p.y) - (q.x - p.x) * (r.y - p.y) > 0) scene.faces.push_back(face);
    }
  }
  std::stable_sort(scene.faces.begin(), scene.faces.end(),
                   [](const Face& a, const Face& b) { return center_of(a).depth < center_of(b).depth; });
  double edges = 0;
  for (const Face& face : scene.faces)
    for (std::size_t i = 0; i < 3; ++i) {
      const Spot& p = face.corners[i];
      const Spot& q = face.corners[(i + 1) % 3];
      edges += std::hypot(p.x - q.x, p.y - q.y);
    }
  const double edge = edges / (3 * static_cast<double>(std::max<std::size_t>(scene.faces.size(), 1)));
  constexpr double shows_edges = 5;
  scene.edge_width = edge < shows_edges ? 0 : std::clamp(0.03 * edge, 0.6, 1.5);
  return scene;
}

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
  std::vector<bool> shown(scene.colors.size());
  for (const Face& face : scene.faces) {
    const std::string fill = hex(scene.colors[face.strip]);
    const auto& [p, q, r] = face.corners;
    svg += fmt::format(R"(<polygon points="{:.2f},{:.2f} {:.2f},{:.2f} {:.2f},{:.2f}" fill="{}"{}/>)", p.x, p.y, q.x,
                       q.y, r.x, r.y, fill, edges ? "" : fmt::format(R"( stroke="{}")", fill));
    svg += '\n';
    shown[face.strip] = true;
  }
  svg += "</g>\n</svg>\n";
  return {std::move(svg), static_cast<std::size_t>(std::count(shown.begin(), shown.end(), true))};
}

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
    pixels[at] = is_edge ? edge_color : scene.colors[face.strip];
    if (!is_edge) shown[face.strip] = true;
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
