#include "turn_answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <vector>

#include "arcs_around.hpp"

namespace restrip::verify {
namespace {

std::string turn_word(const TurnKey& key, unsigned from, unsigned to) {
  std::string word;
  for (unsigned i = from; i < to; ++i) {
    const std::size_t turn = is_solid(key.left, i) ? 1 : is_solid(key.right, i) ? 2 : 0;
    if (!is_solid(key.ports, i))
      word += 'd';
    else
      word += is_solid(key.joined, i) ? "SLR"[turn] : "slr"[turn];
  }
  return word;
}

/// The same arc in the letters that do not tell turns.
std::string plain_word(const std::string& word) {
  std::string plain;
  for (const char letter : word) plain += !turn_port(letter) ? 'd' : turn_joined(letter) ? 'j' : 's';
  return plain;
}

constexpr ArcEnd end_number(unsigned n) { return {n >= 2, n % 2 == 1}; }

/// The pairs of ends whose ports the key joins.
Mask allowed_pairs(const std::string& first, const std::string& second) {
  Mask allowed = 0;
  for (unsigned one = 0; one < 4; ++one)
    for (unsigned other = one + 1; other < 4; ++other)
      if (joined_before(first, second, end_number(one), end_number(other))) allowed |= pair_of_ends(one, other);
  return allowed;
}

using LinkColors = std::vector<bool>;

Mask turn_mask(const LinkColors& solid) {
  Mask mask = 0;
  for (unsigned i = 0; i < solid.size(); ++i)
    if (solid[i]) mask |= single(i);
  return mask;
}

void append_links(LinkColors& colors, const LinkColors& more, std::size_t from, std::size_t to) {
  for (std::size_t i = from; i < to; ++i) colors.push_back(more[i]);
}

}  // namespace

std::string TurnKey::text() const {
  return fmt::format("ports {:x} joined {:x} left {:x} right {:x}", ports, joined, left, right);
}

/// An arc with the class behind each of its letters.
class TurnReader::Walk {
 public:
  Walk(const TurnCertificate& certificate, std::string word)
      : certificate_(certificate), word_(std::move(word)), classes_{0} {
    for (const char letter : word_) {
      const TurnStep& step = certificate.classes[classes_.back()].steps[turn_letters.find(letter)];
      cost_ += step.cost;
      classes_.push_back(step.to);
    }
  }

  const std::string& word() const { return word_; }
  std::optional<int> cost(std::size_t arc_case) const {
    const auto& claimed = certificate_.classes[classes_.back()].costs[arc_case];
    return claimed ? std::optional(cost_ + *claimed) : std::nullopt;
  }

  /// The links of the arc in this case, left to right.
  LinkColors links(std::size_t arc_case) const {
    LinkColors solid(word_.size() + 1);
    for (std::size_t at = word_.size();; --at) {
      solid[at] = turn_case(arc_case).right != '-';
      if (at == 0) return solid;
      arc_case = certificate_.classes[classes_[at - 1]].steps[turn_letters.find(word_[at - 1])].from[arc_case];
    }
  }

 private:
  const TurnCertificate& certificate_;
  std::string word_;
  std::vector<std::size_t> classes_;
  int cost_ = 0;
};

/// The best so far.
struct TurnReader::Part {
  std::optional<int> cost;
  std::size_t first = 0;
  std::size_t second = 0;
  std::size_t third = 0;
  bool chord = false;

  void offer(const Part& other) {
    if (!cost || *other.cost < *cost) *this = other;
  }
};

TurnAnswer TurnReader::split(const FanPlace& place, const TurnKey& key) const {
  const Walk x(certificate_, turn_word(key, 0, place.a));
  const Walk y(certificate_, turn_word(key, place.a, place.k));
  const Mask allowed = allowed_pairs(plain_word(x.word()), plain_word(y.word()));
  Part best;
  for (std::size_t one = 0; one < turn_cases; ++one)
    for (std::size_t other = 0; x.cost(one) && other < turn_cases; ++other)
      for (const bool chord : {false, true}) {
        const TurnWay& way = ways_.around(one, other, chord);
        if (y.cost(other) && way.legal && is_subset(way.joined, allowed))
          best.offer({*x.cost(one) + *y.cost(other) + way.cost, one, other, 0, chord});
      }
  LinkColors colors = x.links(best.first);
  append_links(colors, y.links(best.second), 0, y.word().size() + 1);
  colors.push_back(best.chord);
  return {turn_mask(colors), best.cost.value()};
}

TurnAnswer TurnReader::open_split(const FanPlace& place, const TurnKey& key) const {
  const Walk below(certificate_, turn_word(key, 0, place.a));
  const Walk x(certificate_, turn_word(key, place.a, place.b));
  const Walk above(certificate_, turn_word(key, place.b, place.k));
  const Mask allowed = allowed_pairs(plain_word(x.word()), plain_word(above.word()) + 'b' + plain_word(below.word()));
  Part best;
  for (std::size_t low = 0; low < turn_cases; ++low)
    for (std::size_t high = 0; high < turn_cases; ++high) {
      if (!below.cost(low) || turn_case(low).left != '-') continue;
      if (!above.cost(high) || turn_case(high).right != '-') continue;
      const std::size_t second = turn_number({turn_case(high).left, turn_case(low).right}).value();
      for (std::size_t one = 0; one < turn_cases; ++one)
        for (const bool chord : {false, true}) {
          const TurnWay& way = ways_.around(one, second, chord);
          if (x.cost(one) && way.legal && is_subset(way.joined, allowed))
            best.offer({*x.cost(one) + *below.cost(low) + *above.cost(high) + way.cost, one, low, high, chord});
        }
    }
  LinkColors colors;
  const LinkColors up_to_a = below.links(best.second);
  const LinkColors from_d = above.links(best.third);
  append_links(colors, up_to_a, 1, up_to_a.size());
  append_links(colors, x.links(best.first), 0, x.word().size() + 1);
  append_links(colors, from_d, 0, from_d.size() - 1);
  colors.push_back(best.chord);
  return {turn_mask(colors), best.cost.value()};
}

TurnAnswer TurnReader::boundary_split(const FanPlace& place, const TurnKey& key) const {
  const Walk x(certificate_, turn_word(key, 0, place.a));
  const Walk y(certificate_, turn_word(key, place.a, place.k));
  // The last solid port of the one and the first of the other, as in a ring with A and the boundary between the two.
  const bool may_join = joined_before(plain_word(x.word()), plain_word(y.word()) + 'b', {false, true}, {true, false});
  Part best;
  for (std::size_t one = 0; one < turn_cases; ++one)
    for (std::size_t other = 0; x.cost(one) && other < turn_cases; ++other) {
      const TurnWay& way = ways_.one_between(one, other);
      if (y.cost(other) && way.legal && (way.joined == 0 || may_join))
        best.offer({*x.cost(one) + *y.cost(other) + way.cost, one, other, 0, false});
    }
  LinkColors colors;
  const LinkColors up_to_a = x.links(best.first);
  const LinkColors from_a = y.links(best.second);
  append_links(colors, up_to_a, 1, up_to_a.size());
  append_links(colors, from_a, 0, from_a.size() - 1);
  return {turn_mask(colors), best.cost.value()};
}

TurnAnswer TurnReader::collapse(const FanPlace& place, const TurnKey& key) const {
  const Walk whole(certificate_, turn_word(key, 0, place.k));
  const bool may_join = joined_before(plain_word(whole.word()), "", {false, false}, {false, true});
  Part best;
  for (std::size_t c = 0; c < turn_cases; ++c) {
    const TurnWay& way = ways_.closed(c);
    if (whole.cost(c) && way.legal && (way.joined == 0 || may_join))
      best.offer({*whole.cost(c) + way.cost, c, 0, 0, false});
  }
  LinkColors colors;
  append_links(colors, whole.links(best.first), 1, whole.word().size() + 1);
  return {turn_mask(colors), best.cost.value()};
}

TurnAnswer TurnReader::fan_collapse(const FanPlace& place, const TurnKey& key) const {
  const Walk whole(certificate_, turn_word(key, 0, place.k));
  LinkColors colors;
  append_links(colors, whole.links(both_dashed), 1, whole.word().size());
  return {turn_mask(colors), whole.cost(both_dashed).value()};
}

TurnAnswer TurnReader::answer(const FanPlace& place, const TurnKey& key) const {
  if (place.family == "split") return split(place, key);
  if (place.family == "open-split") return open_split(place, key);
  if (place.family == "boundary-split") return boundary_split(place, key);
  if (place.family == "collapse") return collapse(place, key);
  if (place.family == "fan-collapse") return fan_collapse(place, key);
  throw std::logic_error("no family " + place.family);
}

}  // namespace restrip::verify
