#include "model/side_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

namespace restrip::verify {
namespace {

/// Builds a side and checks the limits.
class SideBuilder {
 public:
  explicit SideBuilder(unsigned triangles) : used_(triangles) { side_.triangles = triangles; }

  void add_edge(const JsonValue& where, unsigned one, unsigned other) {
    if (one == other) where.refuse(fmt::format("expected two different triangles, found {} twice", one));
    if (!seen_.insert({std::min(one, other), std::max(one, other)}).second)
      where.refuse(fmt::format("expected each edge once, {} and {} are joined above", one, other));
    side_.edges.push_back({one, other});
  }
  void use(const JsonValue& where, unsigned triangle) {
    if (++used_[triangle] > 3)
      where.refuse(fmt::format("expected at most three edges and ports of triangle {}, this is the fourth", triangle));
  }
  void add_port(const JsonValue& where, unsigned owner) {
    side_.owner_of_port.push_back(owner);
    use(where, owner);
  }
  void expect_colors(const JsonValue& where, unsigned most) const {
    if (side_.colors() > most)
      where.refuse(fmt::format("expected at most {} edges and ports together, found {} and {}", most,
                               side_.inner_edges(), side_.ports()));
  }
  Side& side() { return side_; }

 private:
  Side side_;
  std::vector<unsigned> used_;
  std::set<std::array<unsigned, 2>> seen_;
};

Side read_graph(const JsonValue& value) {
  value.expect_members({"triangles", "edges", "ports"});
  SideBuilder builder(static_cast<unsigned>(value["triangles"].number(1, most_triangles, "a number")));
  Side& side = builder.side();
  const auto triangle_at = [&](const JsonValue& where) { return where.place(side.triangles, "triangle"); };
  const JsonValue edges = value["edges"];
  for (const JsonValue& edge : edges.elements("edges, pairs of triangles", 0, most_colors_of_a_user - 1)) {
    const std::vector<JsonValue> ends = edge.elements("triangles", 2, 2);
    const std::array<unsigned, 2> pair = {triangle_at(ends[0]), triangle_at(ends[1])};
    builder.add_edge(edge, pair[0], pair[1]);
    for (std::size_t end = 0; end < 2; ++end) builder.use(ends[end], pair[end]);
  }
  for (const JsonValue& port : value["ports"].elements("ports, the triangle of each", 1, most_ports))
    builder.add_port(port, triangle_at(port));
  builder.expect_colors(edges, most_colors_of_a_user);
  for (unsigned triangle = 0; triangle < side.triangles; ++triangle) side.names.push_back(std::to_string(triangle));
  return side;
}

/// Names appear in reports.
void expect_name(const std::string& name) {
  const auto fits = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); };
  if (name.empty() || name.size() > longest_word || !std::all_of(name.begin(), name.end(), fits))
    throw std::invalid_argument(
        fmt::format("expected 1 to {} letters and digits as the name, found \"{}\"", longest_word, name));
}

/// A row of triangles, each joined to the next.
struct Chain {
  JsonValue where;
  bool ring = false;
  std::vector<std::string> triangles;
};

class PatternReader {
 public:
  PatternReader(const JsonValue& value, const NamedNumbers& numbers) : value_(value), numbers_(numbers) {}

  Side read() {
    value_.expect_members({"ring", "rings", "path", "paths", "chord", "chords", "ports"});
    if (value_.has("ring") && value_.has("path")) value_.refuse("expected \"ring\" or \"path\", not both");
    read_chains();
    number_triangles();
    SideBuilder builder(static_cast<unsigned>(names_.size()));
    builder.side().names = names_;
    const auto join = [&](const JsonValue& where, unsigned one, unsigned other) {
      builder.add_edge(where, one, other);
      for (const unsigned end : {one, other}) builder.use(where, end);
    };
    for (const Chain& chain : chains_) {
      const std::vector<std::string>& row = chain.triangles;
      for (std::size_t i = 0; i + 1 < row.size(); ++i)
        join(chain.where, number_of_.at(row[i]), number_of_.at(row[i + 1]));
      if (chain.ring) join(chain.where, number_of_.at(row.back()), number_of_.at(row.front()));
    }
    for (const JsonValue& chord : one_or_more("chord", "chords")) {
      const std::vector<JsonValue> ends = chord.elements("triangles", 2, 2);
      join(chord, triangle_at(ends[0]), triangle_at(ends[1]));
    }
    add_ports(builder);
    builder.expect_colors(value_, most_colors);
    if (chains_.size() == 1) builder.side().around = around_of(builder.side(), chains_.front());
    return builder.side();
  }

 private:
  /// The meaning of an element: one triangle by its name, or x_from … x_(to-1).
  std::vector<std::string> read_element(const JsonValue& value) {
    const std::string text = value.text();
    try {
      if (text.find('[') == std::string::npos) {
        expect_name(text);
        return {text};
      }
      const NamedRange range = range_of(text, numbers_);
      if (!indices_.contains(range.name)) indexed_names_.push_back(range.name);
      std::set<unsigned>& indices = indices_[range.name];
      std::vector<std::string> element;
      for (unsigned i = range.from; i < range.to; ++i) {
        indices.insert(i);
        element.push_back(fmt::format("{}{}", range.name, i));
      }
      return element;
    } catch (const std::invalid_argument& error) {
      value.refuse(error.what());
    }
  }

  /// The value of the first member, or the items of the second.
  std::vector<JsonValue> one_or_more(std::string_view one, std::string_view more) const {
    std::vector<JsonValue> values;
    if (const std::optional<JsonValue> single_one = value_.member(one)) values.push_back(*single_one);
    if (const std::optional<JsonValue> list = value_.member(more))
      for (const JsonValue& item : list->elements("lists")) values.push_back(item);
    return values;
  }

  void read_chains() {
    for (const bool ring : {true, false})
      for (const JsonValue& chain : ring ? one_or_more("ring", "rings") : one_or_more("path", "paths")) {
        chains_.push_back({chain, ring, {}});
        for (const JsonValue& part : chain.elements("triangles")) {
          const std::vector<std::string> element = read_element(part);
          std::vector<std::string>& triangles = chains_.back().triangles;
          triangles.insert(triangles.end(), element.begin(), element.end());
        }
        if (ring && chains_.back().triangles.size() < 3)
          chain.refuse(
              fmt::format("expected a ring of three triangles or more, found {}", chains_.back().triangles.size()));
      }
    if (chains_.empty()) static_cast<void>(value_["path"]);
  }

  /// Indexed triangles first, by name and index, then the others in order of appearance.
  void number_triangles() {
    for (const std::string& name : indexed_names_)
      for (const unsigned i : indices_.at(name)) names_.push_back(fmt::format("{}{}", name, i));
    indexed_ = names_.size();
    const std::set<std::string> indexed(names_.begin(), names_.end());
    for (const Chain& chain : chains_) {
      std::set<std::string> seen;
      for (const std::string& name : chain.triangles) {
        if (!seen.insert(name).second)
          chain.where.refuse(fmt::format("expected each triangle once, {} occurs twice", name));
        if (!indexed.contains(name) && std::find(names_.begin(), names_.end(), name) == names_.end())
          names_.push_back(name);
      }
    }
    if (names_.empty() || names_.size() > most_triangles)
      value_.refuse(fmt::format("expected 1 to {} triangles, found {}", most_triangles, names_.size()));
    for (unsigned i = 0; i < names_.size(); ++i) number_of_[names_[i]] = i;
  }

  unsigned number_of(const JsonValue& where, const std::string& name) const {
    const auto found = number_of_.find(name);
    if (found == number_of_.end()) where.refuse(fmt::format("no triangle is named {}", name));
    return found->second;
  }
  unsigned triangle_at(const JsonValue& value) { return number_of(value, value.text()); }

  void add_ports(SideBuilder& builder) {
    const std::optional<JsonValue> ports = value_.member("ports");
    if (ports) {
      for (const JsonValue& port : ports->elements("triangles, one for each port"))
        for (const std::string& owner : read_element(port)) builder.add_port(port, number_of(port, owner));
    } else {
      for (unsigned i = 0; i < indexed_; ++i) builder.add_port(value_, i);
    }
    if (const unsigned count = builder.side().ports(); count == 0 || count > most_ports)
      ports.value_or(value_).refuse(fmt::format("expected 1 to {} ports, found {}", most_ports, count));
  }

  /// What lies around each triangle, if the pattern is a fan or a quadrilateral; otherwise nothing.
  ///
  /// In a fan the chain runs counter-clockwise around a vertex. Its triangles have one port each, on the outside, in
  /// the order of the chain. Inserted triangles have none: a ring and at most one chord on the inside make them the
  /// two triangles of an edge. In a path without a chord their third side is on the boundary, as are the ends of the
  /// path. A quadrilateral is a path of two triangles with two ports each, which follow each other.
  std::vector<std::array<unsigned, 3>> around_of(const Side& side, const Chain& chain) const {
    const auto row = [&](std::size_t i) { return number_of_.at(chain.triangles.at(i)); };
    const auto length = static_cast<unsigned>(chain.triangles.size());
    const unsigned along = chain.ring ? length : length - 1;  // edges of the chain, before the chords
    std::vector<std::vector<unsigned>> ports(side.triangles);
    for (unsigned port = 0; port < side.ports(); ++port) ports[side.owner_of_port[port]].push_back(port);
    std::vector<std::array<unsigned, 3>> around(side.triangles);
    const unsigned chords = side.inner_edges() - along;
    if (!chain.ring && length == 2 && chords == 0 && ports[0].size() == 2 && ports[1].size() == 2) {
      for (unsigned triangle = 0; triangle < 2; ++triangle) {
        const auto [low, high] = std::pair(ports[triangle][0], ports[triangle][1]);
        if (high != low + 1 && high != low + 3) return {};  // not next to each other among the four
        const bool wraps = high == low + 3;
        around[triangle] = {0, first_port_side + (wraps ? high : low), first_port_side + (wraps ? low : high)};
      }
      return around;
    }
    if (chords > 1) return {};
    std::vector<unsigned> order;  // of the ports along the chain
    for (unsigned i = 0; i < length; ++i) {
      const unsigned triangle = row(i);
      const unsigned before = i > 0 ? i - 1 : chain.ring ? length - 1 : boundary_side;
      const unsigned after = i < along ? i : boundary_side;
      const bool on_chord = chords == 1 && (side.edges[along][0] == triangle || side.edges[along][1] == triangle);
      const bool is_inserted = ports[triangle].empty();
      if (ports[triangle].size() > 1 || (is_inserted ? (chain.ring || chords == 1) && !on_chord : on_chord)) return {};
      for (const unsigned port : ports[triangle]) order.push_back(port);
      if (is_inserted)
        around[triangle] = {before, after, on_chord ? along : boundary_side};
      else
        around[triangle] = {before, first_port_side + order.back(), after};
    }
    if (chain.ring) std::rotate(order.begin(), std::min_element(order.begin(), order.end()), order.end());
    return std::is_sorted(order.begin(), order.end()) ? around : std::vector<std::array<unsigned, 3>>{};
  }

  const JsonValue& value_;
  NamedNumbers numbers_;
  std::vector<std::string> indexed_names_;  ///< of indexed triangles before their indices, in order of first appearance
  std::map<std::string, std::set<unsigned>> indices_;
  std::vector<Chain> chains_;
  std::vector<std::string> names_;
  std::size_t indexed_ = 0;
  std::map<std::string, unsigned> number_of_;
};

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
  NamedRange range{text.substr(0, open), value_of(open + 1, comma), value_of(comma + 1, text.size() - 1)};
  expect_name(range.name);
  return range;
}

Sides read_sides(const JsonValue& description, const NamedNumbers& numbers) {
  if (description["before"].is_list()) return read_surface(description, numbers);
  if (const std::optional<JsonValue> boundary = description.member("boundary"))
    boundary->refuse("expected patches that are given by their triangles where there is this member");
  return {read_side(description["before"], numbers), read_side(description["after"], numbers), 0, {}, {}};
}

Side read_side(const JsonValue& value, const NamedNumbers& numbers) {
  const bool is_pattern = value.has("ring") || value.has("rings") || value.has("path") || value.has("paths");
  return is_pattern ? PatternReader(value, numbers).read() : read_graph(value);
}

}  // namespace restrip::verify
