#include "automaton/answers.hpp"

#include <fmt/format.h>

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

}  // namespace restrip::verify
