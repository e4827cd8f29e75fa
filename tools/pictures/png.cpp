#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

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

/// The visible face at each pixel.
class FaceBuffer {
 public:
  static constexpr std::uint32_t no_face = 0xFFFF'FFFF;

  explicit FaceBuffer(const PictureSize& size)
      : size_(size),
        faces_(std::size_t{size.width} * size.height, no_face),
        depths_(faces_.size(), -std::numeric_limits<double>::infinity()) {}

  [[nodiscard]] std::uint32_t at(std::uint32_t x, std::uint32_t y) const { return faces_[place(x, y)]; }

  void put(const Face& face, std::uint32_t number) {
    const auto& [p, q, r] = face.corners;
    const auto first = [](double a, double b, double c) { return std::max(0.0, std::floor(std::min({a, b, c}))); };
    const auto last = [](double a, double b, double c, std::uint32_t side) {
      return std::min(static_cast<double>(side), std::ceil(std::max({a, b, c})));
    };
    const auto left = static_cast<std::uint32_t>(first(p.x, q.x, r.x));
    const auto right = static_cast<std::uint32_t>(last(p.x, q.x, r.x, size_.width));
    const auto low = static_cast<std::uint32_t>(last(p.y, q.y, r.y, size_.height));
    for (auto y = static_cast<std::uint32_t>(first(p.y, q.y, r.y)); y < low; ++y)
      for (std::uint32_t x = left; x < right; ++x) put_pixel(face, number, x, y);
  }

 private:
  [[nodiscard]] std::size_t place(std::uint32_t x, std::uint32_t y) const { return std::size_t{y} * size_.width + x; }

  void put_pixel(const Face& face, std::uint32_t number, std::uint32_t x, std::uint32_t y) {
    const double at_x = x + 0.5;
    const double at_y = y + 0.5;
    const auto side = [&](const Spot& from, const Spot& to) {  // positive inside
      return (to.y - from.y) * (at_x - from.x) - (to.x - from.x) * (at_y - from.y);
    };
    const auto& [p, q, r] = face.corners;
    const double of_p = side(q, r);
    const double of_q = side(r, p);
    const double of_r = side(p, q);
    // A pixel on an edge belongs to both triangles, however the sums are rounded.
    constexpr double on_edge = -1e-9;
    const double sum = of_p + of_q + of_r;
    if (std::min({of_p, of_q, of_r}) < on_edge * sum) return;
    const double depth = (of_p * p.depth + of_q * q.depth + of_r * r.depth) / sum;
    const std::size_t at = place(x, y);
    if (depth <= depths_[at]) return;
    depths_[at] = depth;
    faces_[at] = number;
  }

  PictureSize size_;
  std::vector<std::uint32_t> faces_;
  std::vector<double> depths_;
};

/// The colour of a face at a point.
class Paint {
 public:
  explicit Paint(const Scene& scene)
      : scene_(&scene),
        // Thinner edges would have gaps: the nearest pixel may be half a diagonal away.
        edge_(scene.edge_width > 0 ? std::max(scene.edge_width / 2, 0.5) : 0),
        line_(std::max(scene.line_width / 2, 0.75)) {}

  /// Whether the point has the colour of the face's strip.
  [[nodiscard]] bool is_strip(const Face& face, double x, double y) const {
    if (scene_->style == StripStyle::faces) return !is_edge(face, x, y);
    const Spot center = center_of(face);
    double nearest = std::hypot(x - center.x, y - center.y);
    for (std::size_t i = 0; i < face.door_count; ++i)
      nearest = std::min(nearest, distance_from(center, face.doors[i], x, y));
    return nearest < line_;
  }
  [[nodiscard]] bool is_edge(const Face& face, double x, double y) const {
    for (std::size_t i = 0; i < 3; ++i)
      if (distance_from(face.corners[i], face.corners[(i + 1) % 3], x, y) < edge_) return true;
    return false;
  }

 private:
  const Scene* scene_;
  double edge_;
  double line_;
};

std::string encoded(const PictureSize& size, const std::vector<Color>& pixels) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = size.width;
  image.height = size.height;
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t bytes = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string png(bytes, '\0');
  static_assert(sizeof(Color) == 3);
  if (png_image_write_to_memory(&image, png.data(), &bytes, 0, pixels.data(), 0, nullptr) == 0)
    throw std::runtime_error(fmt::format("libpng could not make the picture: {}", image.message));
  png.resize(bytes);
  return png;
}

}  // namespace

Picture png_of(const Scene& scene) {
  if (scene.faces.size() >= FaceBuffer::no_face) throw std::runtime_error("a picture of too many triangles");
  FaceBuffer buffer(scene.size);
  for (std::size_t i = 0; i < scene.faces.size(); ++i) buffer.put(scene.faces[i], static_cast<std::uint32_t>(i));
  const Paint paint(scene);
  std::vector<Color> pixels;
  pixels.reserve(std::size_t{scene.size.width} * scene.size.height);
  std::vector<bool> shown(scene.colors.size());
  for (std::uint32_t y = 0; y < scene.size.height; ++y)
    for (std::uint32_t x = 0; x < scene.size.width; ++x) {
      const std::uint32_t number = buffer.at(x, y);
      if (number == FaceBuffer::no_face) {
        pixels.push_back(background_color);
        continue;
      }
      const Face& face = scene.faces[number];
      if (paint.is_strip(face, x + 0.5, y + 0.5)) {
        pixels.push_back(scene.colors[face.strip]);
        shown[face.strip] = true;
      } else {
        pixels.push_back(paint.is_edge(face, x + 0.5, y + 0.5) ? edge_color : surface_color);
      }
    }
  return {encoded(scene.size, pixels), static_cast<std::size_t>(std::count(shown.begin(), shown.end(), true))};
}

}  // namespace restrip::tools
