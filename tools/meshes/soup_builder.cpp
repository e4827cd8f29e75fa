#include "meshes/soup_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/bad_input.hpp"
#include "common/counted.hpp"
#include "meshes/polygon.hpp"

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

void SoupBuilder::refuse(const std::string& why) const { throw BadInput(fmt::format("{}: {}", name_, why)); }

void SoupBuilder::add_point(double x, double y, double z, std::size_t line) {
  if (soup_.points.size() == max_vertices) refuse(fmt::format("more than {} vertices", max_vertices));
  Point point{x, y, z};
  const Point rounded = in_32_bits(point);  // checks the range
  if (!std::isfinite(rounded.x) || !std::isfinite(rounded.y) || !std::isfinite(rounded.z)) {
    lost_points_.push_back({soup_.points.size(), line});
    point = {};
  }
  soup_.points.push_back(point);
}

Attribute::Value SoupBuilder::usable(const Attribute::Value& value, std::size_t vertex, const std::string& attribute) {
  if (is_finite(value)) return value;
  doubts_[attribute].push_back(vertex);
  return neutral_value(attribute);
}

void SoupBuilder::leave_out(const std::string& part) {
  constexpr std::size_t most_names = 64;
  note(soup_.left_out, soup_.left_out.size() < most_names ? part : "more parts of other kinds");
}

void SoupBuilder::settle_doubts() {
  if (doubts_.empty() && lost_points_.empty()) return;
  std::vector<bool> used(soup_.points.size(), false);
  for (const Corners& triangle : soup_.triangles)
    for (const std::uint32_t corner : triangle) used[corner] = true;
  const auto is_used = [&used](std::size_t vertex) { return used[vertex]; };
  const auto unused = [](std::size_t count) {
    return fmt::format("infinite or not a number, of {} in no triangle", counted(count, "vertex", "vertices"));
  };
  const auto lost = std::find_if(lost_points_.begin(), lost_points_.end(),
                                 [&used](const LostPoint& point) { return used[point.vertex]; });
  if (lost != lost_points_.end())
    throw BadInput(fmt::format("{}{}: vertex {} has a coordinate that is infinite or not a number; mend or remove it",
                               name_, lost->line == 0 ? "" : fmt::format(":{}", lost->line), lost->vertex));
  if (!lost_points_.empty()) leave_out("a coordinate that is " + unused(lost_points_.size()));
  for (const auto& [attribute, vertices] : doubts_) {
    const auto found = std::find_if(vertices.begin(), vertices.end(), is_used);
    if (found == vertices.end()) {
      leave_out(attribute + " that are " + unused(vertices.size()));
      continue;
    }
    leave_out(fmt::format("{} (infinite or not a number at vertex {})", attribute, *found));
    std::erase_if(soup_.attributes, [&name = attribute](const Attribute& one) { return one.name == name; });
  }
}

void SoupBuilder::add_face(std::span<const std::uint32_t> corners) {
  if (corners.size() < 3) {
    ++soup_.stubs;
    return;
  }
  const std::size_t first = soup_.triangles.size();
  for (std::size_t i = 2; i < corners.size(); ++i) add_triangle({corners[0], corners[i - 1], corners[i]});
  if (corners.size() == 3) return;
  ++soup_.polygons;
  polygons_.push_back({first, soup_.triangles.size(), 0});
}

void SoupBuilder::add_triangle(const Corners& corners) {
  if (soup_.triangles.size() == max_triangles)
    refuse(fmt::format("more than {} triangles; cut the mesh in pieces", max_triangles));
  soup_.triangles.push_back(corners);
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
  strip_runs_.push_back({first, soup_.triangles.size(), strips_.size()});
  strips_.insert(strips_.end(), indices.begin(), indices.end());
}

void SoupBuilder::cut_polygons() {
  PolygonCutter cutter(soup_.points);
  for (const Run& polygon : polygons_)
    if (!cutter.cut(std::span(soup_.triangles).subspan(polygon.first, polygon.end - polygon.first)))
      refuse(fmt::format("its polygons take too long to be cut into triangles (at one of {} corners); cut them before",
                         polygon.end - polygon.first + 2));
}

std::vector<std::uint32_t> SoupBuilder::all_strips() const {
  std::vector<std::uint32_t> made;
  if (strip_runs_.empty()) return made;
  made.reserve(strips_.size() + strip_runs_.size());
  const auto add = [&made](auto begin, auto end) {
    if (!made.empty()) made.push_back(strip_end);
    made.insert(made.end(), begin, end);
  };
  std::size_t t = 0;
  const auto add_triangles_to = [&](std::size_t end) {
    for (; t < end; ++t)
      if (!degenerate(soup_.triangles[t])) add(soup_.triangles[t].begin(), soup_.triangles[t].end());
  };
  for (std::size_t i = 0; i < strip_runs_.size(); ++i) {
    const Run& run = strip_runs_[i];
    const std::size_t end = i + 1 < strip_runs_.size() ? strip_runs_[i + 1].index : strips_.size();
    add_triangles_to(run.first);
    add(strips_.begin() + static_cast<std::ptrdiff_t>(run.index), strips_.begin() + static_cast<std::ptrdiff_t>(end));
    t = run.end;
  }
  add_triangles_to(soup_.triangles.size());
  return made;
}

Soup SoupBuilder::finish() && {
  const std::string others =
      soup_.left_out.empty() ? "" : fmt::format(" (left out: {})", left_out_in_words(soup_.left_out));
  if (soup_.points.empty())
    refuse("no vertices" + others + "; is the file empty, or of another format than its name says?");
  if (soup_.triangles.empty())
    refuse(fmt::format("{} but no triangles{}; strips need faces, not points or lines",
                       counted(soup_.points.size(), "vertex", "vertices"), others));
  const auto check = [this](std::uint32_t corner) {
    if (corner >= soup_.points.size())
      refuse(fmt::format("a face refers to vertex {} (counted from 0), but there are {}; is the file complete?", corner,
                         soup_.points.size()));
  };
  for (const Corners& triangle : soup_.triangles)
    for (const std::uint32_t corner : triangle) check(corner);
  for (const std::uint32_t index : strips_) check(index);
  settle_doubts();
  cut_polygons();
  soup_.strips = all_strips();
  if (std::all_of(soup_.triangles.begin(), soup_.triangles.end(), degenerate))
    refuse(fmt::format("{}, each with a corner twice; strips need triangles with three different corners",
                       counted(soup_.triangles.size(), "triangle")));
  return std::move(soup_);
}

}  // namespace restrip::tools
