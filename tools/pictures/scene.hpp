// A mesh and its strips as seen by a camera, and the pictures of it: SVG and PNG.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "meshes/soup.hpp"

namespace restrip::tools {

/// The triangles of one strip, in order.
using StripCorners = std::vector<Corners>;

/// The direction of view, in degrees: a parallel projection with the y axis upright. At 0,0 the camera looks along -z;
/// the azimuth moves it around the y axis towards +x, the elevation up towards +y.
struct Camera {
  double azimuth = 30;
  double elevation = 20;  ///< from -90 to 90
};

struct PictureSize {
  std::uint32_t width = 800;
  std::uint32_t height = 600;
};
inline constexpr std::uint32_t least_picture_side = 16;
inline constexpr std::uint32_t most_picture_side = 8192;

struct Color {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
};
inline constexpr Color background_color{255, 255, 255};
inline constexpr Color edge_color{48, 52, 58};

/// In pixels; y points down, and a greater depth is nearer to the camera.
struct Spot {
  double x = 0;
  double y = 0;
  double depth = 0;
};

/// A triangle that faces the camera.
struct Face {
  std::array<Spot, 3> corners;
  std::size_t strip = 0;
};
[[nodiscard]] Spot center_of(const Face& face) noexcept;

struct Scene {
  PictureSize size;
  std::vector<Face> faces;    ///< far ones first, by their centres
  std::vector<Color> colors;  ///< of each strip; about a thousand strips have different ones
  double edge_width = 0;      ///< width of triangle edges, in pixels; 0: triangles are too small to show them
};

/// The whole mesh, visible or not, fits into the picture with a margin of a fortieth of the shorter side. Triangles
/// that face away are left out. O(n log n) for n triangles.
[[nodiscard]] Scene scene_of(std::span<const Point> points, std::span<const StripCorners> strips, const Camera& camera,
                             const PictureSize& size);

struct Picture {
  std::string bytes;
  std::size_t strips = 0;  ///< number of strips visible by colour
};

/// One polygon per face, far ones first, so that near ones cover them. Correct unless triangles of very different size
/// overlap.
[[nodiscard]] Picture svg_of(const Scene& scene);

/// Uses a depth buffer; 15 bytes a pixel. Without antialiasing: every pixel has the colour of the background, of an
/// edge, or of a strip. Throws std::runtime_error if libpng fails.
[[nodiscard]] Picture png_of(const Scene& scene);

}  // namespace restrip::tools
