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

namespace {

/// The triangles of a side, with the value that lists each.
struct ListedTriangles {
  NamedTriangles triangles;
  std::vector<JsonValue> listed;
};

class SurfaceReader {
 public:
  SurfaceReader(const JsonValue& description, const NamedNumbers& numbers)
      : description_(description), numbers_(numbers) {}

  Sides read() const {
    const ListedTriangles before = read_triangles("before");
    const ListedTriangles after = read_triangles("after");
    NamedSurface surface{before.triangles, after.triangles, {}};
    std::vector<JsonValue> stretches;
    if (const std::optional<JsonValue> boundary = description_.member("boundary"))
      stretches = boundary->elements("stretches", 0, most_colors_of_a_user);
    for (const JsonValue& stretch : stretches) {
      const std::vector<JsonValue> ends = stretch.elements("vertices", 2, 2);
      surface.boundary.push_back({vertex(ends[0], {}, 0), vertex(ends[1], {}, 0)});
    }
    try {
      Sides sides = graphs_of(surface);
      expect_limits(description_["before"], sides.before);
      expect_limits(description_["after"], sides.after);
      return sides;
    } catch (const SurfaceFault& fault) {
      if (!fault.element) description_[fault.member].refuse(fault.what + position());
      const std::vector<JsonValue>& elements = fault.member == "boundary" ? stretches
                                               : fault.member == "before" ? before.listed
                                                                          : after.listed;
      elements.at(*fault.element).refuse(fault.what + position());
    }
  }

 private:
  bool is_family() const { return !numbers_.names.empty(); }
  /// For reports: " (k = 5)".
  std::string position() const {
    std::string text;
    for (std::size_t i = 0; i < numbers_.names.size(); ++i)
      text += fmt::format("{}{} = {}", i == 0 ? " (" : ", ", numbers_.names[i], numbers_.values.at(i));
    return text + (text.empty() ? "" : ")");
  }

  /// In a family, three vertices may be followed by an index and its values: one triangle for each value.
  ListedTriangles read_triangles(const char* member) const {
    ListedTriangles all;
    const JsonValue side = description_[member];
    for (const JsonValue& item : side.elements("triangles", 1, most_triangles)) {
      const std::vector<JsonValue> words =
          is_family() ? item.elements("words: three vertices, and an index with its values", 3, 4)
                      : item.elements("vertices", 3, 3);
      const NamedRange index = words.size() == 4 ? index_of(words[3]) : NamedRange{"", 0, 1};
      for (unsigned i = index.from; i < index.to; ++i) {
        all.triangles.push_back(
            {vertex(words[0], index.name, i), vertex(words[1], index.name, i), vertex(words[2], index.name, i)});
        all.listed.push_back(item);
        if (all.triangles.size() > most_triangles)
          side.refuse(fmt::format("expected 1 to {} triangles{}", most_triangles, position()));
      }
    }
    return all;
  }

  NamedRange index_of(const JsonValue& value) const {
    try {
      NamedRange range = range_of(value.text("an index with its values"), numbers_);
      const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
      if (range.name.empty() || range.name.size() > longest_word ||
          !std::all_of(range.name.begin(), range.name.end(), is_letter) ||
          std::find(numbers_.names.begin(), numbers_.names.end(), range.name) != numbers_.names.end())
        throw std::invalid_argument(fmt::format(
            "expected an index of lower-case letters other than the numbers of the family, found \"{}\"", range.name));
      return range;
    } catch (const std::invalid_argument& error) {
      value.refuse(error.what());
    }
  }

  /// "u[i+1]" is u_3 for i = 2. Names of a single operation are taken as they are.
  std::string vertex(const JsonValue& value, const std::string& index, unsigned i) const {
    std::string text = value.text("the name of a vertex");
    const std::size_t open = text.find('[');
    if (!is_family() || open == std::string::npos) return text;
    if (!text.ends_with(']')) value.refuse(fmt::format("expected a vertex as \"u[i+1]\", found \"{}\"", text));
    std::vector<std::string> names = numbers_.names;
    Numbers values = numbers_.values;
    if (!index.empty()) {
      names.push_back(index);
      values.push_back(i);
    }
    try {
      const std::int64_t place = Sum(text.substr(open + 1, text.size() - open - 2), names).of(values);
      if (place < 0)
        throw std::invalid_argument(fmt::format("expected no negative index, found {}{}", place, position()));
      return fmt::format("{}_{}", text.substr(0, open), place);
    } catch (const std::invalid_argument& error) {
      value.refuse(error.what());
    }
  }

  void expect_limits(const JsonValue& value, const Side& side) const {
    if (side.ports() == 0 || side.ports() > most_ports)
      value.refuse(fmt::format("expected 1 to {} ports, found {}{}", most_ports, side.ports(), position()));
    if (side.colors() > most_colors_of_a_user)
      value.refuse(fmt::format("expected at most {} edges and ports together, found {} and {}{}", most_colors_of_a_user,
                               side.inner_edges(), side.ports(), position()));
  }

  const JsonValue& description_;
  const NamedNumbers& numbers_;
};

}  // namespace

Sides read_surface(const JsonValue& description, const NamedNumbers& numbers) {
  return SurfaceReader(description, numbers).read();
}

}  // namespace restrip::verify
