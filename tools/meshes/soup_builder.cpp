#include "meshes/soup_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/bad_input.hpp"
#include "common/counted.hpp"

namespace restrip::tools {

void refuse_long_lines(std::string_view text, const std::string& name) {
  for (std::size_t line = 1; text.size() > longest_line; ++line) {
    const std::size_t stop = std::min(text.find_first_of("\n\r"), text.size());
    if (stop > longest_line)
      throw BadInput(fmt::format("{}:{}: a line of more than {}, the limit; write a line for each vertex and face",
                                 name, line, size_in_words(longest_line)));
    text.remove_prefix(stop + 1);
  }
}

void SoupBuilder::add_point(double x, double y, double z) {
  if (soup_.points.size() == max_vertices)
    throw BadInput(fmt::format("{}: more than {} vertices", name_, max_vertices));
  Point point{x, y, z};
  const Point rounded = in_32_bits(point);  // checks the range
  if (!std::isfinite(rounded.x) || !std::isfinite(rounded.y) || !std::isfinite(rounded.z)) {
    doubt(soup_.points.size(), "a coordinate that is");
    point = {};
  }
  soup_.points.push_back(point);
}

void SoupBuilder::leave_out(const std::string& attribute) {
  note(soup_.left_out_attributes, attribute);
  constexpr std::size_t most_names = 256;
  if (soup_.left_out_attributes.size() > most_names)
    throw BadInput(fmt::format("{}: has more than {} kinds of attributes that are left out; export it without them",
                               name_, most_names));
}

void SoupBuilder::doubt(std::size_t vertex, const std::string& what) { doubts_[what].push_back(vertex); }

void SoupBuilder::settle_doubts() {
  if (doubts_.empty()) return;
  std::vector<bool> used(soup_.points.size(), false);
  for (const Corners& triangle : soup_.triangles)
    for (const std::uint32_t corner : triangle) used[corner] = true;
  for (const auto& [what, vertices] : doubts_) {
    for (const std::size_t v : vertices)
      if (used[v])
        throw BadInput(fmt::format("{}: vertex {} has {} infinite or not a number; mend or remove it", name_, v, what));
    leave_out(fmt::format("{} infinite or not a number, of {} in no triangle", what,
                          counted(vertices.size(), "vertex", "vertices")));
  }
}

void SoupBuilder::add_face(std::span<const std::uint32_t> corners) {
  if (corners.size() < 3) {
    ++soup_.stubs;
    return;
  }
  if (corners.size() > 3) ++soup_.polygons;
  const std::size_t first = soup_.triangles.size();
  for (std::size_t i = 2; i < corners.size(); ++i) add_triangle({corners[0], corners[i - 1], corners[i]});
  if (!soup_.strips.empty()) add_strips_of_one(first, soup_.triangles.size());
}

void SoupBuilder::add_triangle(const Corners& corners) {
  if (soup_.triangles.size() == max_triangles)
    throw BadInput(fmt::format("{}: more than {} triangles; cut the mesh in pieces", name_, max_triangles));
  soup_.triangles.push_back(corners);
}

void SoupBuilder::begin_strip() {
  if (!soup_.strips.empty()) soup_.strips.push_back(strip_end);
}

void SoupBuilder::add_strips_of_one(std::size_t first, std::size_t end) {
  for (std::size_t t = first; t < end; ++t) {
    if (degenerate(soup_.triangles[t])) continue;
    begin_strip();
    soup_.strips.insert(soup_.strips.end(), soup_.triangles[t].begin(), soup_.triangles[t].end());
  }
}

void SoupBuilder::add_strip(std::span<const std::uint32_t> indices) {
  const std::size_t first = soup_.triangles.size();
  for (std::size_t i = 2; i < indices.size(); ++i) {
    const std::uint32_t third = indices[i];
    const Corners corners =
        i % 2 == 0 ? Corners{indices[i - 2], indices[i - 1], third} : Corners{indices[i - 1], indices[i - 2], third};
    if (!degenerate(corners)) add_triangle(corners);
  }
  if (soup_.triangles.size() == first) return;
  if (soup_.strips.empty()) add_strips_of_one(0, first);  // earlier triangles were in no strip
  begin_strip();
  soup_.strips.insert(soup_.strips.end(), indices.begin(), indices.end());
}

Soup SoupBuilder::finish() && {
  if (soup_.points.empty())
    throw BadInput(fmt::format("{}: no vertices; is the file empty, or of another format than its name says?", name_));
  if (soup_.triangles.empty())
    throw BadInput(fmt::format("{}: {} but no triangles; strips need faces, not points or lines", name_,
                               counted(soup_.points.size(), "vertex", "vertices")));
  const auto check = [this](std::uint32_t corner) {
    if (corner >= soup_.points.size())
      throw BadInput(
          fmt::format("{}: a face refers to vertex {} (counted from 0), but there are {}; is the file complete?", name_,
                      corner, soup_.points.size()));
  };
  for (const Corners& triangle : soup_.triangles)
    for (const std::uint32_t corner : triangle) check(corner);
  for (const std::uint32_t index : soup_.strips)
    if (index != strip_end) check(index);
  settle_doubts();
  if (std::all_of(soup_.triangles.begin(), soup_.triangles.end(), degenerate))
    throw BadInput(fmt::format("{}: {}, each with a corner twice; strips need triangles with three different corners",
                               name_, counted(soup_.triangles.size(), "triangle")));
  return std::move(soup_);
}

}  // namespace restrip::tools
