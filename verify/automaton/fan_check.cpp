#include "automaton/fan_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <vector>

#include "automaton/fan_search.hpp"
#include "model/coloring.hpp"

namespace restrip::verify {
namespace {

/// Visits every submask of a mask.
template <class Visit>
void for_each_submask(Mask mask, Visit&& visit) {
  for (Mask part = mask;; part = (part - 1) & mask) {
    visit(part);
    if (part == 0) return;
  }
}

/// "k 8 gaps 2 5" as a place of its family.
FanPlace place_of(const Family& family, const Section& section) {
  for (const FanPlace& place : all_places(section.ports))
    if (place.family == family.name &&
        (place.text() == family.name + ' ' + section.position || section.serves_every_position))
      return place;
  throw std::logic_error("no place " + family.name + ' ' + section.position);
}

/// All keys of one place with certain ports.
class PortsCheck {
 public:
  PortsCheck(const AutomatonReader& reader, const FanSearch& search, const FanPlace& place, Mask ports, FanCheck& check)
      : reader_(reader),
        search_(search),
        place_(place),
        ports_(ports),
        check_(check),
        colorings_(search.colorings(ports)),
        place_of_inner_(search.end_of_inner(), nowhere) {
    for (std::size_t i = 0; i < colorings_.size(); ++i) place_of_inner_[colorings_[i].inner] = i;
  }

  void check_keys() {
    FanKey key{ports_, 0};
    std::vector<int> least(mask_count(place_.k), std::numeric_limits<int>::max());
    for (const FanSearch::Sound& coloring : colorings_)
      least[coloring.joins] = std::min(least[coloring.joins], coloring.cost);
    // A recolouring sound for a key is sound for a key that joins more.
    for (unsigned port = 0; port < place_.k; ++port)
      for (Mask joined = 0; joined < mask_count(place_.k); ++joined)
        if (is_solid(joined, port)) least[joined] = std::min(least[joined], least[joined & ~single(port)]);
    for_each_submask(search_.joinable(ports_), [&](Mask joined) {
      if (search_.two_in_ring(ports_) && joined != 0 && joined != ports_) return;
      ++check_.keys;
      key.joined = joined;
      const AutomatonAnswer answer = reader_.answer(place_, key);
      const std::size_t found = answer.inner < place_of_inner_.size() ? place_of_inner_[answer.inner] : nowhere;
      const auto wrong = [&](const char* what) {
        check_.failures.add(fmt::format("{}, {}: {:x} {}", place_.text(), key.text(), answer.inner, what));
      };
      if (found == nowhere || !is_subset(colorings_[found].joins, joined))
        wrong("is not sound");
      else if (colorings_[found].cost != answer.cost)
        wrong("does not have the stated cost");
      else if (answer.cost != least[joined])
        wrong("is not the best");
    });
  }

 private:
  static constexpr auto nowhere = std::numeric_limits<std::size_t>::max();

  const AutomatonReader& reader_;
  const FanSearch& search_;
  const FanPlace& place_;
  Mask ports_;
  FanCheck& check_;
  std::vector<FanSearch::Sound> colorings_;
  std::vector<std::size_t> place_of_inner_;  ///< in colorings_
};

}  // namespace

FanCheck check_against_search(const AutomatonCertificate& certificate, unsigned k, unsigned every) {
  FanCheck check;
  const AutomatonReader reader(certificate);
  const std::vector<FanPlace> places = all_places(k);
  for (std::size_t i = 0; i < places.size(); i += every) {
    const FanSearch search(places[i]);
    ++check.places;
    for (Mask ports = 0; ports < mask_count(k); ++ports)
      PortsCheck(reader, search, places[i], ports, check).check_keys();
  }
  return check;
}

FanCheck check_against_rows(const AutomatonCertificate& certificate, const Family& family, const Certificate& rows) {
  FanCheck check;
  const AutomatonReader reader(certificate);
  for (std::size_t s = 0; s < family.sections.size(); ++s) {
    const FanPlace place = place_of(family, family.sections[s]);
    const Side after = patch_after(place);
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
