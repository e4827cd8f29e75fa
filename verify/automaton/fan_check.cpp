#include "fan_check.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "fan_search.hpp"
#include "survey.hpp"

namespace restrip::verify {
namespace {

/// Every mask within another one.
template <class Visit>
void for_each_submask(Mask mask, Visit&& visit) {
  for (Mask part = mask;; part = (part - 1) & mask) {
    visit(part);
    if (part == 0) return;
  }
}

std::string key_text(const FanPlace& place, Mask ports, Mask joined) {
  return fmt::format("{}, ports {:x} joined {:x}", place.text(), ports, joined);
}

/// "k 8 gaps 2 5" as a place of its family.
FanPlace place_of(const Family& family, const Section& section) {
  for (const FanPlace& place : all_places(section.ports))
    if (place.family == family.name &&
        (place.text() == family.name + ' ' + section.position || section.serves_every_position))
      return place;
  throw std::logic_error("no place " + family.name + ' ' + section.position);
}

}  // namespace

FanCheck check_against_search(const AutomatonCertificate& certificate, unsigned k, unsigned every) {
  FanCheck check;
  const std::vector<FanPlace> places = all_places(k);
  for (std::size_t i = 0; i < places.size(); i += every) {
    const FanPlace& place = places[i];
    const FanSearch search(place);
    ++check.places;
    for (Mask ports = 0; ports < mask_count(k); ++ports) {
      const FanSearch::Keys keys = search.keys(ports);
      for_each_submask(search.joinable(ports), [&](Mask joined) {
        // Where each of two ports precedes the other, a key has both bits or none.
        if (place.closed() && solid_count(ports) == 2 && joined != 0 && joined != ports) return;
        ++check.keys;
        const AutomatonAnswer answer = answer_of(certificate, place, ports, joined);
        const auto worth = keys.worth_if_sound(answer.inner, joined);
        if (!worth)
          check.failures.add(fmt::format("{}: {:x} is not sound", key_text(place, ports, joined), answer.inner));
        else if (*worth != keys.best(joined))
          check.failures.add(fmt::format("{}: {:x} is not the best", key_text(place, ports, joined), answer.inner));
        else if (*worth != answer.worth)
          check.failures.add(fmt::format("{}: not worth what is stated", key_text(place, ports, joined)));
      });
    }
  }
  return check;
}

FanCheck check_against_rows(const AutomatonCertificate& certificate, const Family& family, const Certificate& rows) {
  FanCheck check;
  for (std::size_t s = 0; s < family.sections.size(); ++s) {
    const FanPlace place = place_of(family, family.sections[s]);
    const Patch after = patch_after(place);
    ++check.places;
    for (const Row& row : rows.sections[s].rows) {
      ++check.keys;
      const AutomatonAnswer answer = answer_of(certificate, place, row.key.ports, row.key.second);
      const Survey of_row = survey(after, row.after);
      check.same += answer.inner == row.after.inner ? 1U : 0U;
      if (answer.worth != Worth{of_row.solid, -of_row.isolated})
        check.failures.add(fmt::format("{}:{}: {} is worth another answer than this rule", rows.file, row.line,
                                       key_text(place, row.key.ports, row.key.second)));
    }
  }
  return check;
}

}  // namespace restrip::verify
