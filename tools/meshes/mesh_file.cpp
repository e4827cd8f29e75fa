#include "meshes/mesh_file.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <iterator>

#include "meshes/little_endian.hpp"
#include "meshes/positions.hpp"

namespace restrip::tools {

std::string off_bytes(const Soup& soup) {
  std::string text = fmt::format("OFF\n{} {} 0\n", soup.points.size(), soup.triangles.size());
  auto out = std::back_inserter(text);
  for (const Point& p : soup.points) {
    put_coordinates(text, p);
    text += '\n';
  }
  for (const Corners& t : soup.triangles) fmt::format_to(out, "3 {} {} {}\n", t[0], t[1], t[2]);
  return text;
}

/// The attribute bytes and the normal are zero: programs compute normals from the corners.
std::string stl_bytes(const Soup& soup) {
  std::string bytes(80, ' ');
  bytes.reserve(84 + 50 * soup.triangles.size());
  put(bytes, static_cast<std::uint32_t>(soup.triangles.size()));
  for (const Corners& t : soup.triangles) {
    bytes.append(12, '\0');
    for (const std::uint32_t corner : t) put(bytes, soup.points[corner]);
    bytes.append(2, '\0');
  }
  return bytes;
}

}  // namespace restrip::tools
