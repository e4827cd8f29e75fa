#include "answers.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <vector>

namespace restrip::verify {
namespace {

/// An arc with the class behind each of its letters.
class Walk {
 public:
  Walk(const AutomatonCertificate& certificate, const std::string& word)
      : certificate_(certificate), word_(word), classes_{0} {
    for (const char letter : word) {
      const AutomatonStep& step = certificate.classes[classes_.back()].steps[letters.find(letter)].value();
      worth_ = worth_ + step.gain;
      classes_.push_back(step.to);
    }
  }

  std::size_t arc_class() const { return classes_.back(); }
  Worth worth() const { return worth_; }

  /// The links of the arc in this case, left to right.
  std::vector<bool> links(std::size_t arc_case) const {
    std::vector<bool> solid(word_.size() + 1);
    for (std::size_t at = word_.size();; --at) {
      solid[at] = all_cases[arc_case].right != '-';
      if (at == 0) return solid;
      arc_case = certificate_.classes[classes_[at - 1]].steps[letters.find(word_[at - 1])]->from[arc_case];
    }
  }

 private:
  const AutomatonCertificate& certificate_;
  std::string word_;
  std::vector<std::size_t> classes_;
  Worth worth_;
};

std::string word_of(Mask ports, Mask joined, unsigned from, unsigned to) {
  std::string word;
  for (unsigned i = from; i < to; ++i) word += !is_solid(ports, i) ? 'd' : is_solid(joined, i) ? 'j' : 's';
  return word;
}

Mask mask_of(const std::vector<bool>& solid) {
  Mask mask = 0;
  for (unsigned i = 0; i < solid.size(); ++i)
    if (solid[i]) mask |= single(i);
  return mask;
}

using Colors = std::vector<bool>;

void append(Colors& colors, const Colors& more, std::size_t from, std::size_t to) {
  for (std::size_t i = from; i < to; ++i) colors.push_back(more[i]);
}

AutomatonAnswer two_arcs(const AutomatonCertificate& certificate, const FanPlace& place, Mask ports, Mask joined) {
  const bool ring = place.family == "split";
  const unsigned first_from = ring ? 0 : place.a;
  const unsigned first_to = ring ? place.a : place.b;
  const Walk x(certificate, word_of(ports, joined, first_from, first_to));
  std::string around = word_of(ports, joined, first_to, place.k);
  if (!ring) {
    around += 'b';
    around += word_of(ports, joined, 0, first_from);
  }
  const Walk y(certificate, around);
  const AutomatonMeeting& meeting = certificate.meetings[x.arc_class()][y.arc_class()].value();
  const Colors inside = x.links(meeting.first);
  const Colors outside = y.links(meeting.second);
  const std::size_t above = place.k - first_to;  // triangles behind D
  Colors colors;
  if (ring) {
    append(colors, inside, 0, inside.size());
    append(colors, outside, 0, outside.size());
  } else {
    if (place.a > 0) append(colors, outside, above + 2, outside.size());
    append(colors, inside, 0, inside.size());
    append(colors, outside, 0, above);
  }
  colors.push_back(meeting.chord);
  return {mask_of(colors), x.worth() + y.worth() + meeting.value};
}

}  // namespace

std::string FanPlace::text() const {
  if (family == "split") return fmt::format("split k {} a {}", k, a);
  if (family == "open-split") return fmt::format("open-split k {} gaps {} {}", k, a, b);
  if (family == "boundary-split") return fmt::format("boundary-split k {} gap {}", k, a);
  return fmt::format("{} k {}", family, k);
}

Patch patch_after(const FanPlace& place) { return patch_after(place.family, {place.k, place.a, place.b}); }

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

AutomatonAnswer answer_of(const AutomatonCertificate& certificate, const FanPlace& place, Mask ports, Mask joined) {
  if (place.family == "split" || place.family == "open-split") return two_arcs(certificate, place, ports, joined);
  std::string word = word_of(ports, joined, 0, place.k);
  if (place.family == "boundary-split") word.insert(word.begin() + place.a, 'd');
  const Walk whole(certificate, word);
  Colors colors;
  if (place.family == "collapse") {
    const AutomatonClosing& closing = certificate.closings[whole.arc_class()].value();
    append(colors, whole.links(closing.arc), 1, word.size() + 1);
    return {mask_of(colors), whole.worth() + closing.value};
  }
  append(colors, whole.links(both_dashed), 1, word.size());
  return {mask_of(colors), whole.worth() + certificate.classes[whole.arc_class()].values[both_dashed].value()};
}

}  // namespace restrip::verify
