#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "model/side_reader.hpp"
#include "model/triangles.hpp"

namespace restrip::verify {
namespace {

/// The triangles of a side, with the index of each in the list of the file.
struct ListedTriangles {
  NamedTriangles triangles;
  std::vector<std::size_t> item;
};

class SurfaceReader {
 public:
  SurfaceReader(const JsonValue& description, const NamedNumbers& numbers)
      : description_(description), numbers_(numbers) {}

  Sides read() const {
    const ListedTriangles before = read_triangles("before");
    const ListedTriangles after = read_triangles("after");
    NamedSurface surface{before.triangles, after.triangles, {}};
    if (const std::optional<JsonValue> boundary = description_.member("boundary"))
      for (const JsonValue& ends : boundary->list("a list of stretches", most_colors_of_a_graph)) {
        const std::vector<JsonValue> names = list_of(ends, 2, 2, "two vertices");
        surface.boundary.push_back({vertex(names[0], {}, 0), vertex(names[1], {}, 0)});
      }
    std::set<std::string> vertices;
    for (const NamedTriangles* side : {&surface.before, &surface.after})
      for (const auto& names : *side) vertices.insert(names.begin(), names.end());
    try {
      SurfaceGraphs graphs = graphs_of(surface);
      return {side_of(description_.required("before"), graphs.before),
              side_of(description_.required("after"), graphs.after), static_cast<unsigned>(vertices.size()),
              std::move(graphs.before.placed), std::move(graphs.after.placed)};
    } catch (const SurfaceFault& fault) {
      const JsonValue member = description_.required(fault.member);
      if (!fault.element) member.fail_found(fault.what + position());
      const bool in_before = fault.member == "before";
      const bool on_boundary = fault.member == "boundary";
      member.item(on_boundary ? *fault.element : (in_before ? before : after).item.at(*fault.element))
          .fail_found(fault.what + position());
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

  static std::vector<JsonValue> list_of(const JsonValue& value, std::size_t least, std::size_t most,
                                        const std::string& expected) {
    std::vector<JsonValue> items = value.list(expected, most);
    if (items.size() < least) value.fail_found(fmt::format("expected {}", expected));
    return items;
  }

  /// In a family, three vertices may be followed by an index and its values: one triangle for each value.
  ListedTriangles read_triangles(const char* member) const {
    ListedTriangles all;
    const JsonValue side = description_.required(member);
    const std::vector<JsonValue> items = side.list("a list of 1 to 16 triangles", most_triangles);
    for (std::size_t item = 0; item < items.size(); ++item) {
      const std::vector<JsonValue> words =
          list_of(items[item], 3, is_family() ? 4 : 3,
                  is_family() ? "three vertices, and an index with its values" : "three vertices");
      const NamedRange index = words.size() == 4 ? index_of(words[3]) : NamedRange{"", 0, 1};
      for (unsigned i = index.from; i < index.to; ++i) {
        all.triangles.push_back(
            {vertex(words[0], index.name, i), vertex(words[1], index.name, i), vertex(words[2], index.name, i)});
        all.item.push_back(item);
        if (all.triangles.size() > most_triangles)
          side.fail_found(fmt::format("expected 1 to {} triangles{}", most_triangles, position()));
      }
    }
    return all;
  }

  NamedRange index_of(const JsonValue& value) const {
    try {
      NamedRange range = range_of(value.string("an index with its values"), numbers_);
      const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
      if (!std::all_of(range.name.begin(), range.name.end(), is_letter) ||
          std::find(numbers_.names.begin(), numbers_.names.end(), range.name) != numbers_.names.end())
        throw std::invalid_argument(fmt::format(
            "expected an index of lower-case letters other than the numbers of the family, found \"{}\"", range.name));
      return range;
    } catch (const std::invalid_argument& error) {
      value.fail_found(error.what());
    }
  }

  /// "u[i+1]" is u_3 for i = 2. Names of a single operation are taken as they are.
  std::string vertex(const JsonValue& value, const std::string& index, unsigned i) const {
    std::string text = value.string("the name of a vertex");
    const std::size_t open = text.find('[');
    if (!is_family() || open == std::string::npos) return text;
    if (!text.ends_with(']')) value.fail_found(fmt::format("expected a vertex as \"u[i+1]\", found \"{}\"", text));
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
      value.fail_found(error.what());
    }
  }

  Side side_of(const JsonValue& value, PatchGraph& graph) const {
    Side side{graph.triangles, std::move(graph.edges), std::move(graph.owner_of_port), {}};
    if (side.ports() == 0 || side.ports() > most_ports_of_a_graph)
      value.fail_found(
          fmt::format("expected 1 to {} ports, found {}{}", most_ports_of_a_graph, side.ports(), position()));
    if (side.colors() > most_colors_of_a_graph)
      value.fail_found(fmt::format("expected at most {} edges and ports together, found {} and {}{}",
                                   most_colors_of_a_graph, side.inner_edges(), side.ports(), position()));
    return side;
  }

  const JsonValue& description_;
  const NamedNumbers& numbers_;
};

}  // namespace

Sides read_surface(const JsonValue& description, const NamedNumbers& numbers) {
  return SurfaceReader(description, numbers).read();
}

}  // namespace restrip::verify
