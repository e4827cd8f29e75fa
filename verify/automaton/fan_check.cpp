#include "automaton/fan_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "model/coloring.hpp"

namespace restrip::verify {
namespace {

using LinkColors = std::vector<bool>;

Mask mask_of(const LinkColors& solid) {
  Mask mask = 0;
  for (unsigned i = 0; i < solid.size(); ++i)
    if (solid[i]) mask |= single(i);
  return mask;
}

void append(LinkColors& colors, const LinkColors& more, std::size_t from, std::size_t to) {
  for (std::size_t i = from; i < to; ++i) colors.push_back(more[i]);
}

std::string word_of(const FanKey& key, unsigned from, unsigned to) {
  std::string word;
  for (unsigned i = from; i < to; ++i) word += !is_solid(key.ports, i) ? 'd' : is_solid(key.joined, i) ? 'S' : 's';
  return word;
}

/// An arc with the class after each of its letters.
class Walk {
 public:
  Walk(const AutomatonCertificate& certificate, const std::string& word)
      : certificate_(certificate), word_(word), classes_{0} {
    for (const char letter : word) {
      const AutomatonStep& step = *certificate.step(classes_.back(), letter);
      cost_ += step.cost;
      classes_.push_back(step.to);
    }
  }

  std::size_t arc_class() const { return classes_.back(); }
  int cost(std::size_t arc_case) const { return cost_ + certificate_.classes[arc_class()].costs[arc_case].value(); }

  /// The links of the arc in this case, left to right.
  LinkColors links(std::size_t arc_case) const {
    LinkColors solid(word_.size() + 1);
    for (std::size_t at = word_.size();; --at) {
      solid[at] = case_at(arc_case).right != '-';
      if (at == 0) return solid;
      arc_case = certificate_.step(classes_[at - 1], word_[at - 1])->from[arc_case];
    }
  }

 private:
  const AutomatonCertificate& certificate_;
  std::string word_;
  std::vector<std::size_t> classes_;
  int cost_ = 0;
};

}  // namespace

std::string FanPlace::text() const {
  if (family == "split") return fmt::format("split k {} a {}", k, a);
  if (family == "open-split") return fmt::format("open-split k {} gaps {} {}", k, a, b);
  if (family == "boundary-split") return fmt::format("boundary-split k {} gap {}", k, a);
  return fmt::format("{} k {}", family, k);
}

FanKey written_key(unsigned k, std::uint64_t n) {
  FanKey key;
  for (unsigned port = k; port-- > 0; n /= 3) {
    const std::uint64_t letter = n % 3;
    if (letter == 0) continue;
    key.ports |= single(port);
    if (letter == 2) key.joined |= single(port);
  }
  return key;
}

FanKey seen_key(FanKey key, const FanPlace& place) {
  key.joined &= place.closed() ? key.ports : key.ports & ~lowest(key.ports);
  if (place.closed() && solid_count(key.ports) == 2 && key.joined != 0) key.joined = key.ports;
  return key;
}

std::vector<FanPlace> all_places(unsigned k) {
  std::vector<FanPlace> places;
  if (k >= 3) {
    for (unsigned a = 1; a < k; ++a) places.push_back({"split", k, a, 0});
    places.push_back({"collapse", k, 0, 0});
  }
  for (unsigned i = 0; i < k; ++i)
    for (unsigned j = i + 1; j <= k; ++j) places.push_back({"open-split", k, i, j});
  for (unsigned i = 0; i <= k; ++i) places.push_back({"boundary-split", k, i, 0});
  places.push_back({"fan-collapse", k, 0, 0});
  return places;
}

std::string FanKey::text() const { return fmt::format("ports {:x} joined {:x}", ports, joined); }

AutomatonAnswer AutomatonReader::answer(const FanPlace& place, const FanKey& key) const {
  LinkColors colors;
  const bool ring = place.family == "split";
  if (ring || place.family == "open-split") {
    const unsigned first_from = ring ? 0 : place.a;
    const unsigned first_to = ring ? place.a : place.b;
    const Walk x(certificate_, word_of(key, first_from, first_to));
    const std::string boundary = ring ? "" : 'b' + word_of(key, 0, first_from);
    const Walk y(certificate_, word_of(key, first_to, place.k) + boundary);
    const AutomatonMeeting& meeting = certificate_.meeting(x.arc_class(), y.arc_class());
    const LinkColors inside = x.links(meeting.first);
    const LinkColors outside = y.links(meeting.second);
    const std::size_t above = place.k - first_to;  // triangles after D
    if (!ring && place.a > 0) append(colors, outside, above + 2, outside.size());
    append(colors, inside, 0, inside.size());
    append(colors, outside, 0, ring ? outside.size() : above);
    colors.push_back(meeting.chord);
    return {mask_of(colors), x.cost(meeting.first) + y.cost(meeting.second) +
                                 ways_.around(meeting.first, meeting.second, meeting.chord).cost};
  }
  std::string word = word_of(key, 0, place.k);
  if (place.family == "boundary-split") word.insert(word.begin() + place.a, 'd');
  const Walk whole(certificate_, word);
  if (place.family == "collapse") {
    const std::size_t closing = certificate_.closings[whole.arc_class()].value().arc;
    append(colors, whole.links(closing), 1, word.size() + 1);
    return {mask_of(colors), whole.cost(closing) + ways_.closed(closing).cost};
  }
  append(colors, whole.links(both_dashed), 1, word.size());
  return {mask_of(colors), whole.cost(both_dashed)};
}

namespace {

/// "k 8 gaps 2 5" as a place of its family.
FanPlace place_of(const Family& family, const Section& section) {
  for (const FanPlace& place : all_places(section.ports))
    if (place.family == family.name &&
        (place.text() == family.name + ' ' + section.position || section.serves_every_position))
      return place;
  throw std::logic_error("no place " + family.name + ' ' + section.position);
}

/// The key of a row of a table of fans: bit i of `joined` is set if port i is joined to the solid port before it.
FanKey fan_key(const Key& key, const FanPlace& place) {
  Mask joined = 0;
  for (unsigned port = 0; port < place.k; ++port) {
    if (!is_solid(key.ports, port)) continue;
    for (unsigned step = 1; step < place.k && (place.closed() || step <= port); ++step) {
      const unsigned before = (port + place.k - step) % place.k;
      if (!is_solid(key.ports, before)) continue;
      if (key.joined.has(before, port)) joined |= single(port);
      break;
    }
  }
  return {key.ports, joined};
}

/// The patch after the operation, by docs/reference/notation.md.
Side patch_by_notation(const FanPlace& place) {
  const bool has_d = place.family == "split" || place.family == "open-split";
  const bool has_a = has_d || place.family == "boundary-split";
  const unsigned gap_a = place.family == "split" ? 0 : place.a;
  const unsigned gap_d = place.family == "split" ? place.a : place.b;
  Side side;
  unsigned a = 0;
  unsigned d = 0;
  for (unsigned i = 0; i <= place.k; ++i) {
    if (has_a && i == gap_a) a = side.triangles++;
    if (has_d && i == gap_d) d = side.triangles++;
    if (i < place.k) side.owner_of_port.push_back(side.triangles++);
  }
  for (unsigned t = 0; t + 1 < side.triangles; ++t) side.edges.push_back({t, t + 1});
  if (place.closed()) side.edges.push_back({side.triangles - 1, 0});
  if (has_d) side.edges.push_back({a, d});
  return side;
}

/// A colouring of the inner edges of a patch without ports: degrees at most two and no cycle.
struct InnerColoring {
  Mask inner = 0;
  Mask full = 0;                                      ///< ports of triangles with two solid inner edges
  Mask lonely = 0;                                    ///< ports of triangles with none
  int isolated = 0;                                   ///< triangles without a port and without a solid edge
  std::vector<std::pair<unsigned, unsigned>> joined;  ///< ports that a strip joins if they are solid
};

std::vector<InnerColoring> inner_colorings(const Side& side) {
  std::vector<InnerColoring> all;
  for (Mask inner = 0; inner < mask_count(side.inner_edges()); ++inner) {
    const std::optional<SolidGraph> graph = valid_graph(side, {inner, 0}, most_solid(Constraint::strips));
    if (!graph) continue;
    InnerColoring& coloring = all.emplace_back();
    coloring.inner = inner;
    const Degrees degree = degrees(side, {inner, 0});
    for (unsigned port = 0; port < side.ports(); ++port) {
      if (degree[side.owner_of_port[port]] == 2) coloring.full |= single(port);
      if (degree[side.owner_of_port[port]] == 0) coloring.lonely |= single(port);
    }
    coloring.isolated = static_cast<int>(isolated_of(side, {inner, 0}) - solid_count(coloring.lonely));
    for (unsigned j = 1; j < side.ports(); ++j)
      for (unsigned i = 0; i < j; ++i)
        if (!is_solid(coloring.full, i) && !is_solid(coloring.full, j) &&
            graph->connected(side.owner_of_port[i], side.owner_of_port[j]))
          coloring.joined.emplace_back(i, j);
  }
  return all;
}

/// All keys of one place: every colouring is tried.
void check_place(const AutomatonReader& reader, const FanPlace& place, FanCheck& check) {
  struct Sound {
    Mask joins = 0;  ///< the key's bits for its joins
    int cost = 0;    ///< minus the restarts of all triangles
  };
  const Side side = patch_by_notation(place);
  const std::vector<InnerColoring> colorings = inner_colorings(side);
  for (Mask ports = 0; ports < mask_count(place.k); ++ports) {
    std::vector<std::optional<unsigned>> port_before(place.k);
    Mask joinable = 0;  // the possible bits of `joined`: solid ports with a predecessor
    for (unsigned port = 0; port < place.k; ++port) {
      for (unsigned step = 1; step < place.k && (place.closed() || step <= port) && !port_before[port]; ++step)
        if (const unsigned candidate = (port + place.k - step) % place.k; is_solid(ports, candidate))
          port_before[port] = candidate;
      if (is_solid(ports, port) && port_before[port]) joinable |= single(port);
    }
    // If each of two ports precedes the other, a key has both bits or none.
    const bool two_in_ring = place.closed() && solid_count(ports) == 2;

    // The recolourings that are sound for some key with these ports, and the least cost for each key.
    std::vector<std::optional<Sound>> sound(mask_count(side.inner_edges()));
    std::vector<int> least(mask_count(place.k), std::numeric_limits<int>::max());
    for (const InnerColoring& coloring : colorings) {
      bool is_sound = (coloring.full & ports) == 0;
      Mask joins = 0;
      for (const auto& [one, other] : coloring.joined) {
        if (!is_solid(ports, one) || !is_solid(ports, other)) continue;
        if (two_in_ring)
          joins = ports;
        else if (port_before[one] == other)
          joins |= single(one);
        else if (port_before[other] == one)
          joins |= single(other);
        else
          is_sound = false;
      }
      if (!is_sound) continue;
      const int isolated = coloring.isolated + static_cast<int>(solid_count(coloring.lonely & ~ports));
      const int cost = isolated_cost * isolated - strip_cost * static_cast<int>(solid_count(coloring.inner));
      sound[coloring.inner] = Sound{joins, cost};
      least[joins] = std::min(least[joins], cost);
    }
    // A recolouring sound for a key is sound for a key that joins more.
    for (unsigned port = 0; port < place.k; ++port)
      for (Mask joined = 0; joined < mask_count(place.k); ++joined)
        if (is_solid(joined, port)) least[joined] = std::min(least[joined], least[joined & ~single(port)]);

    for (Mask joined = 0; joined < mask_count(place.k); ++joined) {
      if (!is_subset(joined, joinable) || (two_in_ring && joined != 0 && joined != ports)) continue;
      ++check.keys;
      const FanKey key{ports, joined};
      const AutomatonAnswer answer = reader.answer(place, key);
      const std::optional<Sound> found = answer.inner < sound.size() ? sound[answer.inner] : std::nullopt;
      const auto wrong = [&](const char* what) {
        check.failures.add(fmt::format("{}, {}: {:x} {}", place.text(), key.text(), answer.inner, what));
      };
      if (!found || !is_subset(found->joins, joined))
        wrong("is not sound");
      else if (found->cost != answer.cost)
        wrong("does not have the stated cost");
      else if (answer.cost != least[joined])
        wrong("is not the best");
    }
  }
}

}  // namespace

FanCheck check_against_search(const AutomatonCertificate& certificate, unsigned k, unsigned every) {
  FanCheck check;
  const AutomatonReader reader(certificate);
  const std::vector<FanPlace> places = all_places(k);
  for (std::size_t i = 0; i < places.size(); i += every) {
    ++check.places;
    check_place(reader, places[i], check);
  }
  return check;
}

FanCheck check_against_rows(const AutomatonCertificate& certificate, const Family& family, const Certificate& rows) {
  FanCheck check;
  const AutomatonReader reader(certificate);
  for (std::size_t s = 0; s < family.sections.size(); ++s) {
    const FanPlace place = place_of(family, family.sections[s]);
    const Side after = patch_after(place.family, {place.k, place.a, place.b});
    ++check.places;
    for (const Row& row : rows.sections[s].rows) {
      ++check.keys;
      const FanKey key = fan_key(row.key, place);
      const AutomatonAnswer answer = reader.answer(place, key);
      const Survey of_row = survey(after, row.after);
      check.same += answer.inner == row.after.inner ? 1U : 0U;
      if (answer.cost != isolated_cost * static_cast<int>(of_row.isolated) -
                             strip_cost * static_cast<int>(solid_count(row.after.inner)))
        check.failures.add(fmt::format("{}:{}: {}, the answer {} differs in value from this rule", rows.file, row.line,
                                       place.text(), key.text()));
    }
  }
  return check;
}

}  // namespace restrip::verify
