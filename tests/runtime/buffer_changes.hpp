// Whether buffers draw their mesh.
#pragma once

#include "check_buffer.hpp"
#include "output/strip_buffer.hpp"
#include "output/triangle_list_buffer.hpp"

namespace restrip {

inline BufferReport check_buffer(const StripBuffer& buffer, const StripMesh& mesh) {
  const bool narrow = buffer.width() == IndexWidth::bits16;
  return detail::compare_drawn(narrow ? triangles_of_strips(buffer.indices16()) : triangles_of_strips(buffer.indices()),
                               triangles_of(mesh));
}
inline BufferReport check_buffer(const TriangleListBuffer& buffer, const StripMesh& mesh) {
  const bool narrow = buffer.width() == IndexWidth::bits16;
  return detail::compare_drawn(narrow ? triangles_of_list(buffer.indices16()) : triangles_of_list(buffer.indices()),
                               triangles_of(mesh));
}

}  // namespace restrip
