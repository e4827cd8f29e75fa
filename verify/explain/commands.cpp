#include "explain/commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>

#include "common/output.hpp"
#include "explain/explanation.hpp"
#include "explain/rule_set.hpp"
#include "judge/report.hpp"
#include "model/input.hpp"
#include "model/program.hpp"

namespace restrip::verify {
namespace {

// ---- coloured patches as an SVG picture: triangles as nodes in the ring of their ports, and what is connected outside

struct Panel {
  std::string title;
  const Side* side = nullptr;
  Colors colors;
  World world;        ///< drawn around the patch
  Colors marked;      ///< edges and ports in red
  bool only = false;  ///< other edges and ports may be solid or dashed: they are thin lines
};

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

/// Panels side by side, four in a row.
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

// ---- the subcommands

Mask mask_of(const std::string& option, const std::string& text, unsigned bits) {
  std::uint64_t value = 0;
  const bool is_hexadecimal = text.starts_with("0x");
  const char* const begin = text.data() + (is_hexadecimal ? 2 : 0);
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value, is_hexadecimal ? 16 : 10);
  if (error != std::errc() || end != text.data() + text.size() || value >= wide_mask_count(bits))
    throw std::invalid_argument(fmt::format(
        "{} {}: expected a mask of at most {} bits, decimal as in dumps or hexadecimal after 0x", option, text, bits));
  return static_cast<Mask>(value);
}

/// The shipped descriptions, or the descriptions in a file.
std::vector<Description> descriptions_of(const std::string& file) {
  return file.empty() ? shipped_descriptions() : parse_descriptions(file, read_file(file));
}

/// The one of this name; without a name the only one.
Description named(const std::vector<Description>& all, const std::string& name) {
  std::string names;
  for (const Description& one : all) {
    if (one.name == name || (name.empty() && all.size() == 1)) return one;
    names += ' ' + one.name;
  }
  throw std::invalid_argument(fmt::format("--family {}: expected one of{}", name, names));
}

/// The patch before, the recolouring if there is one, and the best. If the recolouring is invalid in some world, that
/// world is drawn around it; otherwise the sets of edges follow which show that nothing is better.
std::string picture_of(const Definition& definition, const Explanation& explanation,
                       const std::optional<Judgement>& judged) {
  const Side& after = definition.operation().after;
  const auto marked = [](const Obstacle& obstacle) {
    return Colors{obstacle.edges.inner, obstacle.edges.ports | obstacle.ports};
  };
  const Obstacle* const shown = judged && judged->obstacle ? &*judged->obstacle : nullptr;
  const World world = shown != nullptr ? definition.world(shown->world) : World{};
  std::vector<Panel> panels{{"before", &definition.operation().before, explanation.configuration, world, {}}};
  if (judged) {
    Panel yours{fmt::format("yours: {}", name_of(judged->standing)), &after, judged->colors, world, {}};
    if (shown != nullptr) yours.marked = marked(*shown);
    if (judged->standing == Standing::worse) {  // what differs from the best
      yours.title = "yours: " + judged->because;
      yours.marked = {judged->colors.inner ^ explanation.best->colors.inner,
                      judged->colors.ports ^ explanation.best->colors.ports};
    }
    panels.push_back(yours);
  }
  if (explanation.best) panels.push_back({"best", &after, explanation.best->colors, {}, {}});
  if (shown != nullptr) return picture_of(panels);
  for (const Obstacle& obstacle : explanation.obstacles)
    panels.push_back({obstacle.triangle ? "too many at " + name_of(after, *obstacle.triangle) : "a cycle", &after,
                      marked(obstacle), definition.world(obstacle.world), marked(obstacle), true});
  return picture_of(panels);
}

struct ExplainOptions {
  std::string family, operation, before, ports, after, ports_after, svg, json;
  unsigned k = 0;
  Numbers at;
};

int explain(const CLI::App& command, const ExplainOptions& given) {
  std::optional<files::Output> svg;
  if (!given.svg.empty()) svg.emplace(given.svg, files::OutputRules{{".svg"}, {given.operation}});
  const files::ReportOutput out(given.json, {given.operation});
  const Description description = named(descriptions_of(given.operation), given.family);
  Numbers numbers = given.at;
  if (command.count("--k") != 0) numbers.insert(numbers.begin(), given.k);
  const Operation operation = operation_at(description, numbers);
  const Colors configuration{mask_of("--before", given.before, operation.before.inner_edges()),
                             mask_of("--ports", given.ports, operation.ports())};
  const Definition definition(operation);
  if (!definition.valid(configuration))
    throw std::invalid_argument(
        fmt::format("not a valid configuration: {}",
                    invalid_because(operation.before, configuration, most_solid(operation.constraint))));
  std::optional<Judgement> judged;
  if (!given.after.empty()) {
    const Colors recoloring{mask_of("--after", given.after, operation.after.inner_edges()),
                            given.ports_after.empty() ? configuration.ports
                                                      : mask_of("--ports-after", given.ports_after, operation.ports())};
    judged = judgement_of(definition, configuration, recoloring);
  }
  const Explanation explanation = explanation_of(definition, configuration);
  if (svg) svg->write(picture_of(definition, explanation, judged));
  out.print(text_of(definition, explanation, judged), text_of(json_of(definition, explanation, judged)));
  return !judged || judged->standing >= Standing::equally_good ? all_claims_hold : some_claim_fails;
}

struct RulesOptions {
  std::string file, family, operation, json;
  std::size_t worst = 10;
  unsigned threads = 2;
};

}  // namespace

std::function<int()> add_explain(CLI::App& app) {
  CLI::App* const command = app.add_subcommand(
      "explain", "One configuration: the best recolouring, why nothing is better, or what is wrong with another");
  command->footer(
      "Masks are numbered as in docs/reference/notation.md and decimal, as `restrip-generate dump` prints them;\n"
      "0x begins a hexadecimal one, as in certificates.\n"
      "Verdicts:\n"
      "  not valid     a triangle has too many solid edges, the patch has a cycle, or a port changed that may not\n"
      "  unsound       not valid in the world named, in which the configuration is valid; no such world has\n"
      "                fewer connections\n"
      "  worse         sound, and costs more than the best\n"
      "  equally good  costs the same as the best, of which the one with the smallest mask is shown; the rule of a\n"
      "                table is any of them (docs/reference/tables.md, \"Tie-break\")\n"
      "  best          the one shown\n"
      "t0=A is a solid edge, t0-A a dashed one.\n\n"
      "Exit code: 0 if there is no recolouring to judge or it is as good as the best, 1 if it is not, 2 bad input.\n\n"
      "Example:\n"
      "  restrip-verify explain --family split --k 5 --at 2 --before 26 --ports 5 --after 255 --svg why.svg");
  const auto given = std::make_shared<ExplainOptions>();
  command->add_option("--family", given->family,
                      "A shipped family, such as split; or one of several in the operation file");
  command->add_option("--operation", given->operation, "A custom operation or family: its file");
  command->add_option("--k", given->k, "The first number of the position: triangles of the fan");
  command->add_option("--at", given->at, "Its other numbers: a of split, i,j of open-split")->delimiter(',');
  command->add_option("--before", given->before, "The inner edges before the operation")->required();
  command->add_option("--ports", given->ports, "The solid ports before the operation")->required();
  CLI::Option* const after =
      command->add_option("--after", given->after, "The inner edges of a recolouring, which is judged as well");
  command->add_option("--ports-after", given->ports_after, "The ports that it keeps, if it gives any up")->needs(after);
  command->add_option("--svg", given->svg, "Draw the patch before, the patch after and the worlds that show why");
  add_json_option(*command, given->json);
  return [command, given] { return explain(*command, *given); };
}

std::function<int()> add_rules(CLI::App& app) {
  CLI::App* const command =
      app.add_subcommand("rules", "A rule set of any source: how many rows are valid, sound and best");
  command->footer(
      "The file has the columns of `restrip-generate dump`, with or without strips,isolated; other operations have\n"
      "their numbers, then inner,ports,inner_after, then perhaps ports_after.\n"
      "Several files may follow each other, with their headers. Configurations without a row are counted and allowed.\n"
      "If several operations of a file have the same columns, --family says which one is meant.\n"
      "Exit code: 0 every row is best, 1 some row is not or is no valid configuration, 2 bad input.\n\n"
      "Example:\n"
      "  restrip-generate dump --family split --k 5 > rules.csv && restrip-verify rules rules.csv");
  const auto given = std::make_shared<RulesOptions>();
  command->add_option("file", given->file, "The rule set")->required();
  command->add_option("--family", given->family, "The shipped family, or the one of several in the operation file");
  command->add_option("--operation", given->operation, "The operation file that it is for; otherwise a shipped family");
  command->add_option("--worst", given->worst, "How many bad rows are named")->capture_default_str();
  command->add_option("--threads", given->threads, "How many threads; the result does not depend on it")
      ->capture_default_str()
      ->check(CLI::Range(1, 64));
  add_json_option(*command, given->json);
  return [given] {
    const files::ReportOutput out(given->json, {given->file, given->operation});
    const std::vector<Description> descriptions = descriptions_of(given->operation);
    if (!given->family.empty()) (void)named(descriptions, given->family);
    const RuleSetReport report =
        judge_rules(given->file, read_file(given->file), descriptions, given->family, given->worst, given->threads);
    std::string source = given->operation.empty() ? "" : "--operation " + given->operation;
    if (descriptions.size() > 1) source += (source.empty() ? "--family " : " --family ") + report.operation;
    out.print(text_of(report, source), text_of(json_of(report)));
    return report.best() ? all_claims_hold : some_claim_fails;
  };
}

}  // namespace restrip::verify
