#include "lod/handle_order.hpp"

#include "restrip/mesh/checks.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"

namespace restrip::tools {

std::vector<Triangle> handles_along_strips(const ProgressiveMesh& mesh, StripMesh base) {
  base.reserve(mesh.fine_triangles(), mesh.points.size());
  for (const Record& record : mesh.splits) {
    const auto where = spokes_of(base, record);
    if (check_split(base, where, record.v_t) != Refusal::granted) break;
    base.insert_vertex(where, record.v_t);
  }
  stripify(base, Effort::fast);
  const Strips strips = extract_strips(base);
  std::vector<Triangle> handles(strips.order.size());
  for (Triangle place = 0; place < handles.size(); ++place) handles[strips.order[place]] = place;
  return handles;
}

}  // namespace restrip::tools
