#include "model/side_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace restrip::verify {
namespace {

/// The triangles t_0 ... with an index have one port each, on the outside, in the order of the ring or path, which runs
/// counter-clockwise around a vertex. The inserted triangles A and D have none: a ring, or a path with a chord, has
/// them at both sides of an edge, joined by the chord. In a path without a chord the third side of A is on the
/// boundary, as are the ends of every path. Trusted: tests/verify/families_test.cpp compares every position with
/// handwritten patches.
Side read_fan(const JsonValue& value, const NamedNumbers& numbers) {
  value.expect_members({"ring", "path", "chord"});
  const bool is_ring = value.has("ring");
  Side side;
  std::vector<std::string> row;
  std::vector<std::string> inserted;
  for (const JsonValue& element : value[is_ring ? "ring" : "path"].elements("triangles")) {
    const std::string text = element.text();
    if (text.find('[') == std::string::npos) {
      row.push_back(text);
      inserted.push_back(text);
      continue;
    }
    const NamedRange range = range_of(text, numbers);
    for (unsigned i = range.from; i < range.to; ++i) {
      row.push_back(fmt::format("{}{}", range.name, i));
      side.names.push_back(row.back());
      side.owner_of_port.push_back(i);
    }
  }
  side.names.insert(side.names.end(), inserted.begin(), inserted.end());
  side.triangles = static_cast<unsigned>(side.names.size());
  const auto number_of = [&](const std::string& name) {
    return static_cast<unsigned>(std::find(side.names.begin(), side.names.end(), name) - side.names.begin());
  };
  const std::size_t along = is_ring ? row.size() : row.size() - 1;  // edges of the ring or path, before the chord
  for (std::size_t i = 0; i < along; ++i)
    side.edges.push_back({number_of(row[i]), number_of(row[(i + 1) % row.size()])});
  const bool has_chord = value.has("chord");
  if (has_chord) side.edges.push_back({number_of("A"), number_of("D")});
  side.around.resize(side.triangles);
  for (std::size_t i = 0; i < row.size(); ++i) {
    const unsigned triangle = number_of(row[i]);
    const auto before = static_cast<unsigned>(i > 0 ? i - 1 : is_ring ? row.size() - 1 : boundary_side);
    const auto after = static_cast<unsigned>(i < along ? i : boundary_side);
    if (triangle < side.ports())
      side.around[triangle] = {before, first_port_side + triangle, after};
    else
      side.around[triangle] = {before, after, has_chord ? static_cast<unsigned>(along) : boundary_side};
  }
  return side;
}

}  // namespace

NamedRange range_of(const std::string& text, const NamedNumbers& numbers) {
  const std::size_t open = text.find('[');
  const std::size_t comma = text.find(',');
  if (open == std::string::npos || comma == std::string::npos || comma < open || !text.ends_with(')'))
    throw std::invalid_argument(fmt::format("expected a range as \"t[0,k)\", found \"{}\"", text));
  const auto value_of = [&](std::size_t from, std::size_t to) {
    const std::int64_t sum = Sum(text.substr(from, to - from), numbers.names).of(numbers.values);
    if (sum < 0 || sum > most_triangles)
      throw std::invalid_argument(
          fmt::format("expected numbers from 0 to {} in \"{}\", found {}", most_triangles, text, sum));
    return static_cast<unsigned>(sum);
  };
  return {text.substr(0, open), value_of(open + 1, comma), value_of(comma + 1, text.size() - 1)};
}

Sides read_sides(const JsonValue& description, const NamedNumbers& numbers, Author author) {
  if (author == Author::user || description["before"].is_list()) return read_surface(description, numbers);
  return {read_fan(description["before"], numbers), read_fan(description["after"], numbers), 0, {}, {}};
}

Side read_fan_after(const JsonValue& description, const NamedNumbers& numbers) {
  return read_fan(description["after"], numbers);
}

}  // namespace restrip::verify
