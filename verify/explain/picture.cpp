#include "explain/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace restrip::verify {
namespace {

struct Point {
  double x = 0;
  double y = 0;
  friend Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
  friend Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
  friend Point operator*(double factor, Point a) { return {factor * a.x, factor * a.y}; }
};

constexpr double width = 250;
constexpr double height = 270;
constexpr double scale = 76;          // of the unit circle
constexpr double port_radius = 1.15;  // the radius at which ports end

/// Counter-clockwise from the top, as ports are numbered; in pictures y points down.
Point on_circle(double radius, double turn) {
  const double angle = (turn + 0.25) * 2 * std::numbers::pi;
  return {radius * std::cos(angle), -radius * std::sin(angle)};
}

double turn_of(const Side& side, unsigned port) { return static_cast<double>(port) / side.ports(); }

/// Where the triangles lie in the unit circle, on which their ports pull: each amid its neighbours, pushed away by the
/// other triangles.
std::vector<Point> places_of(const Side& side) {
  std::vector<Point> places(side.triangles);
  for (unsigned i = 0; i < side.triangles; ++i) places[i] = on_circle(0.3, static_cast<double>(i) / side.triangles);
  for (int round = 0; round < 300; ++round) {
    std::vector<Point> sum(side.triangles);
    std::vector<double> count(side.triangles);
    const auto pull = [&](unsigned triangle, Point to) {
      sum[triangle] = sum[triangle] + to;
      ++count[triangle];
    };
    for (const auto& [one, other] : side.edges) {
      pull(one, places[other]);
      pull(other, places[one]);
    }
    for (unsigned port = 0; port < side.ports(); ++port)
      pull(side.owner_of_port[port], on_circle(1, turn_of(side, port)));
    std::vector<Point> next = places;
    for (unsigned i = 0; i < side.triangles; ++i) {
      Point push;
      for (const Point& other : places) {
        const Point away = places[i] - other;
        const double square = away.x * away.x + away.y * away.y;
        if (square > 0) push = push + 0.025 / (square + 0.02) * away;
      }
      if (count[i] > 0) next[i] = places[i] + 0.3 * (1 / count[i] * sum[i] + push - places[i]);
    }
    places = std::move(next);
  }
  return places;
}

class PanelPicture {
 public:
  PanelPicture(const Panel& panel, Point corner) : panel_(panel), centre_(corner + Point{width / 2, height / 2 + 12}) {
    const Side& side = *panel.side;
    const std::vector<Point> places = places_of(side);
    text({corner.x + width / 2, corner.y + 18}, panel.title, "title");
    for (std::size_t i = 0; i < panel.world.connected.size(); ++i) outside(panel.world.connected[i], i);
    for (unsigned port = 0; port < side.ports(); ++port) {
      const Point end = on_circle(port_radius, turn_of(side, port));
      line(places[side.owner_of_port[port]], end, is_solid(panel.colors.ports, port),
           is_solid(panel.marked.ports, port));
      text(at(on_circle(port_radius - 0.05, turn_of(side, port) - 0.035)) + Point{0, 4}, std::to_string(port), "port");
    }
    for (unsigned edge = 0; edge < side.inner_edges(); ++edge)
      line(places[side.edges[edge][0]], places[side.edges[edge][1]], is_solid(panel.colors.inner, edge),
           is_solid(panel.marked.inner, edge));
    for (unsigned i = 0; i < side.triangles; ++i) {
      const Point p = at(places[i]);
      text_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"11\"/>\n", p.x, p.y);
      const std::string name = name_of(side, i);
      text(p + Point{0, 4}, name.size() <= 3 ? name : std::to_string(i), "node");
    }
  }
  const std::string& text() const { return text_; }

 private:
  Point at(Point p) const { return centre_ + scale * p; }

  void line(Point from, Point to, bool solid, bool marked) {
    const Point a = at(from);
    const Point b = at(to);
    text_ += fmt::format("<path class=\"{}{}\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>\n",
                         solid         ? "solid"
                         : panel_.only ? "either"
                                       : "dashed",
                         marked ? " marked" : "", a.x, a.y, b.x, b.y);
  }
  void text(Point p, const std::string& words, const char* kind) {
    text_ += fmt::format("<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", kind, p.x, p.y, words);
  }
  /// An arc between two ports, around the patch the shorter way.
  void outside(const std::array<unsigned, 2>& ports, std::size_t number) {
    const double radius = port_radius + 0.2 + 0.08 * static_cast<double>(number);
    const double from = turn_of(*panel_.side, ports[0]);
    const double to = turn_of(*panel_.side, ports[1]);
    const Point a = at(on_circle(port_radius, from));
    const Point b = at(on_circle(radius, from));
    const Point c = at(on_circle(radius, to));
    const Point d = at(on_circle(port_radius, to));
    text_ += fmt::format(
        "<path class=\"outside\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}A{:.1f} {:.1f} 0 0 {} {:.1f} {:.1f}L{:.1f} "
        "{:.1f}\"/>\n",
        a.x, a.y, b.x, b.y, scale * radius, scale * radius, to - from <= 0.5 ? 0 : 1, c.x, c.y, d.x, d.y);
  }

  const Panel& panel_;
  Point centre_;
  std::string text_;
};

}  // namespace

std::string picture_of(const std::vector<Panel>& panels) {
  const std::size_t in_row = std::min<std::size_t>(4, panels.size());
  const std::size_t rows = (panels.size() + in_row - 1) / in_row;
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\">\n"
      "<style>rect {{ fill: #fff }} path {{ fill: none; stroke: #222; stroke-linecap: round }} .solid {{ stroke-width: "
      "4 }} "
      ".dashed {{ stroke: #6b7280; stroke-width: 1.5; stroke-dasharray: 5 5 }} .marked {{ stroke: #c11 }} "
      ".either {{ stroke: #ccc }} .outside {{ stroke: #27c; stroke-width: 3 }} circle {{ fill: #fff; stroke: #222 }} "
      "text {{ font: 11px sans-serif; text-anchor: middle }} .title {{ font-size: 13px }} .port {{ fill: #666 "
      "}}</style>\n"
      "<rect width=\"100%\" height=\"100%\"/>\n",
      width * static_cast<double>(in_row), height * static_cast<double>(rows));
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const std::size_t row = i / in_row;
    text +=
        PanelPicture(panels[i], {width * static_cast<double>(i % in_row), height * static_cast<double>(row)}).text();
  }
  return text + "</svg>\n";
}

}  // namespace restrip::verify
