#include "automaton/row.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "judge/rule_judge.hpp"
#include "model/coloring.hpp"
#include "model/input.hpp"

namespace restrip::verify {
namespace {

/// The edge between two triangles, if there is one.
std::optional<unsigned> edge_joining(const Side& side, unsigned one, unsigned other) {
  for (unsigned e = 0; e < side.inner_edges(); ++e)
    if (side.edges[e] == std::array{one, other} || side.edges[e] == std::array{other, one}) return e;
  return {};
}

/// The side as a row whose ports begin with this one.
std::optional<TriangleRow> row_from(const Side& side, unsigned first, bool front, bool back) {
  TriangleRow row{{}, {}, front, back};
  for (unsigned i = 0; i < side.ports(); ++i) row.ports.push_back((first + i) % side.ports());
  std::vector<unsigned> owners;  // each once, unless it is met again later
  for (const unsigned port : row.ports)
    if (owners.empty() || owners.back() != side.owner_of_port[port]) owners.push_back(side.owner_of_port[port]);
  const auto owner = [&](std::size_t place) { return side.owner_of_port[row.ports[place]]; };
  const std::size_t behind = row.ports.size() - 1;
  if (owners.size() != side.triangles || side.ports() != side.triangles + (front ? 1U : 0U) + (back ? 1U : 0U) ||
      (front && owner(0) != owner(1)) || (back && owner(behind) != owner(behind - 1)) ||
      side.inner_edges() + 1 != side.triangles)
    return {};
  for (unsigned i = 0; i + 1 < owners.size(); ++i) {
    const auto edge = edge_joining(side, owners[i], owners[i + 1]);
    if (!edge) return {};
    row.edges.push_back(*edge);
  }
  return row;
}

/// A word for each solid port and each triangle, with what each is.
struct ReadRow {
  struct Letter {
    char text = 'd';
    std::optional<unsigned> port;  ///< a solid one
    bool triangle = false;
    unsigned owner = 0;  ///< the triangle, or that of the port, by its place in the row
  };
  std::vector<Letter> letters;
  std::vector<unsigned> solid;  ///< in the order of the row
  unsigned triangles = 0;

  ReadRow(const TriangleRow& row, Mask ports, Mask joined) {
    for (const unsigned port : row.ports)
      if (is_solid(ports, port)) solid.push_back(port);
    const bool two_joined = solid.size() == 2 && (is_solid(joined, solid[0]) || is_solid(joined, solid[1]));
    for (std::size_t i = 0; i < row.ports.size(); ++i) {
      const unsigned port = row.ports[i];
      const bool capital = two_joined || is_solid(joined, port);
      const bool at_end = (row.front && i == 0) || (row.back && i + 1 == row.ports.size());
      if (is_solid(ports, port))
        letters.push_back({at_end ? (capital ? 'P' : 'p') : (capital ? 'S' : 's'), port, !at_end, triangles});
      else if (!at_end)
        letters.push_back({'d', {}, true, triangles});
      if (!at_end) ++triangles;
    }
    if (!letters.empty() && !letters.back().triangle && row.back) letters.back().owner = triangles - 1;
  }
};

/// What is compared: strips, isolated triangles and ports given up, ports given up; less what all recolourings have.
std::tuple<int, int, int> value_of(const ReadRow& word, const RowAnswer& answer) {
  std::vector<unsigned> degree(word.triangles, 0);
  for (unsigned i = 0; i + 1 < word.triangles; ++i)
    if (is_solid(answer.links, i)) ++degree[i], ++degree[i + 1];
  for (const ReadRow::Letter& letter : word.letters)
    if (letter.port && is_solid(answer.kept, *letter.port)) ++degree[letter.owner];
  const auto isolated = static_cast<int>(std::count(degree.begin(), degree.end(), 0U));
  const auto given = static_cast<int>(word.solid.size() - solid_count(answer.kept));
  return {given - static_cast<int>(solid_count(answer.links)), isolated + given, given};
}

/// The first and the last solid port joined over all others; the triangles before and behind are one strip each.
RowAnswer across(const ReadRow& word) {
  RowAnswer answer{0, single(word.solid.front()) | single(word.solid.back())};
  std::vector<bool> outside;  // of the strand, by triangle
  std::size_t ports = 0;
  for (const ReadRow::Letter& letter : word.letters) {
    const bool before = ports == 0 && !letter.port;
    ports += letter.port ? 1U : 0U;
    const bool behind = ports == word.solid.size() && !letter.port;
    if (letter.triangle) outside.push_back(before || behind);
  }
  for (unsigned i = 0; i + 1 < outside.size(); ++i)
    if (outside[i] == outside[i + 1]) answer.links |= single(i);
  return answer;
}

}  // namespace

std::vector<RowOperation> row_operations_of(const Description& family, unsigned max_k) {
  const auto refuse = [&](const std::string& why) {
    throw InputError(family.file(), 0, fmt::format("{}: {}", family.name, why));
  };
  std::vector<Operation> operations;
  for (const Numbers& numbers : family.positions(max_k)) operations.push_back(family.at(numbers));
  if (family.numbers.empty() || operations.empty()) refuse(fmt::format("it has no positions up to {}", max_k));
  for (const Operation& operation : operations)
    if (operation.constraint != Constraint::strips || operation.cost != default_cost(Constraint::strips) ||
        operation.may_give_up != mask_count(operation.ports()) - 1 || !searched(operation))
      refuse(fmt::format("{} is not one of strips with the default cost, of at most {} ports that may all be given up",
                         operation.name(), most_searched_ports));
  // The largest tells where the row begins: behind a port of its last triangle comes one of its first.
  const auto largest = std::max_element(
      operations.begin(), operations.end(),
      [](const Operation& one, const Operation& other) { return one.after.triangles < other.after.triangles; });
  const unsigned ports = largest->ports();
  for (unsigned first = 0; first < ports; ++first)
    for (const bool from_end : {false, true})
      for (const bool front : {true, false})
        for (const bool back : {true, false}) {
          std::vector<RowOperation> found;
          for (const Operation& operation : operations) {
            const unsigned n = operation.ports();
            if (from_end ? ports - first > n : first >= n) break;
            const auto row = row_from(operation.after, from_end ? n - (ports - first) : first, front, back);
            if (!row) break;
            found.push_back({operation, *row});
          }
          if (found.size() == operations.size()) return found;
        }
  refuse("after the operation its triangles are no row, open at its ends, in the order of the ports");
  return {};
}

Mask inner_of(const TriangleRow& row, Mask links) {
  Mask inner = 0;
  for (unsigned i = 0; i < row.edges.size(); ++i)
    if (is_solid(links, i)) inner |= single(row.edges[i]);
  return inner;
}

RowAnswer row_answer(const AutomatonCertificate& certificate, const TriangleRow& row, Mask ports, Mask joined) {
  const ReadRow word(row, ports, joined);
  std::vector<std::size_t> classes{0};
  for (const ReadRow::Letter& letter : word.letters)
    classes.push_back(certificate.step(classes.back(), letter.text)->to);
  RowAnswer answer;
  std::size_t arc_case = both_dashed;
  for (std::size_t i = word.letters.size(); i-- > 0;) {
    const ReadRow::Letter& letter = word.letters[i];
    const AutomatonStep& step = *certificate.step(classes[i], letter.text);
    const bool given = is_solid(step.given_up, static_cast<unsigned>(arc_case));
    const bool right = case_at(arc_case).right != '-';
    arc_case = step.from[arc_case];
    if (letter.triangle && right && letter.owner < row.edges.size()) answer.links |= single(letter.owner);
    const bool link = right || case_at(arc_case).right != '-';
    if (letter.port && (letter.triangle ? !given : link)) answer.kept |= single(*letter.port);
  }
  if (word.solid.size() > 2 && is_solid(joined, word.solid.front())) {
    const RowAnswer other = across(word);
    if (value_of(word, other) < value_of(word, answer)) return other;
  }
  return answer;
}

RowCheck check_row(const AutomatonCertificate& certificate, const RowOperation& at) {
  const Operation& operation = at.operation;
  FitTable table(operation.constraint, operation.ports());
  RuleJudge judge(operation, table);
  RowCheck check;
  std::map<std::pair<Mask, Mask>, Colors> answers;
  for (Mask both = 0; both < judge.before().size(); ++both) {
    const Colors configuration = judge.before().coloring(both);
    if (!judge.before().valid(configuration)) continue;
    const PortPairs pairs = judge.joined_by(configuration);
    std::vector<unsigned> solid;
    for (const unsigned port : at.row.ports)
      if (is_solid(configuration.ports, port)) solid.push_back(port);
    Mask joined = 0;
    PortPairs told;
    for (std::size_t i = 0; solid.size() > 1 && i < solid.size(); ++i) {
      const unsigned before = solid[(i + solid.size() - 1) % solid.size()];
      if (!pairs.has(before, solid[i])) continue;
      joined |= single(solid[i]);
      told.add(before, solid[i]);
    }
    const auto wrong = [&](const std::string& what) {
      check.failures.add(fmt::format("{}, {}: {}", operation.name(), drawn(operation.before, configuration), what));
    };
    if (!(told == pairs)) wrong("ports are joined that do not follow each other");
    const auto [place, is_new] = answers.emplace(std::pair{configuration.ports, joined}, Colors{});
    if (is_new) {
      ++check.keys;
      const RowAnswer answer = row_answer(certificate, at.row, configuration.ports, joined);
      place->second = {inner_of(at.row, answer.links), answer.kept};
    }
    const Judged judged = judge.judged(configuration, place->second);
    if (judged.verdict != Verdict::right) wrong(judge.explained(configuration, place->second, judged));
  }
  return check;
}

}  // namespace restrip::verify
