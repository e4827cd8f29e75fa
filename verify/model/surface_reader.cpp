#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "model/side_reader.hpp"

namespace restrip::verify {
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
