#include "replay/live_measure.hpp"

#include <fmt/format.h>

#include <utility>

#include "lod/coloring_check.hpp"
#include "measure/vertex_cache.hpp"
#include "restrip/output/strips.hpp"

namespace restrip::tools {

LiveMeasure::LiveMeasure(StripMesh& mesh, const BufferOptions& options, std::size_t operations_per_update,
                         std::size_t most_triangles)
    : mesh_(mesh), options_(options), buffer_({.form = options.form, .width = IndexWidth::bits32}) {
  report_.operations_per_update = operations_per_update;
  buffer_.reserve(2 * most_triangles);  // poor strips have more than two indices a triangle
  buffer_.rebuild(mesh_);
  mesh_.watch(&changed_);
}

std::size_t LiveMeasure::update() {
  std::size_t written = 0;
  const RangeOptions ranges{.merge_gap = options_.form == StripForm::list ? std::size_t{0} : RangeOptions().merge_gap};
  for (const IndexRange& range : buffer_.update(mesh_, changed_, ranges)) written += range.count;
  changed_.clear();
  return written;
}

void LiveMeasure::count_operation() {
  ++operations_;
  if (operations_ % report_.operations_per_update == 0) written_ += update();
}

BufferState LiveMeasure::look(const std::string& at, std::vector<std::string>& faults) {
  written_ += update();
  const auto indices = buffer_.indices();
  std::vector<Corners> drawn;
  if (options_.form == StripForm::list)
    for (std::size_t i = 2; i < indices.size(); i += 3) drawn.push_back({indices[i - 2], indices[i - 1], indices[i]});
  else
    drawn = decode_strips(indices);
  if (sorted_triangles(std::move(drawn)) != sorted_triangles(corners_of(mesh_)))
    faults.push_back(fmt::format("at {} triangles the index buffer that was kept in step does not draw the mesh",
                                 mesh_.triangle_count()));
  const std::size_t triangles = mesh_.triangle_count();
  BufferState here{at,
                   triangles,
                   strip_indices(mesh_).size(),
                   indices.size(),
                   acmr(indices, 16, triangles),
                   acmr(indices, 32, triangles)};
  if (!at.empty()) report_.states.push_back(here);
  return here;
}

LiveBufferReport LiveMeasure::report() const {
  LiveBufferReport report = report_;
  if (operations_ == 0) return report;
  const double bytes = static_cast<double>(buffer_.index_bytes()) / static_cast<double>(operations_);
  report.bytes_per_operation = bytes * static_cast<double>(written_);
  return report;
}

}  // namespace restrip::tools
