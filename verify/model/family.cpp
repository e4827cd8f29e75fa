#include "model/family.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "model/input.hpp"

namespace restrip::verify {
namespace {

Section& section_at(Family& family, const Description& description, const Operation& operation) {
  const std::string position =
      description.section.empty() ? description.name : description.filled(description.section, operation.numbers);
  const auto found = std::find_if(family.sections.begin(), family.sections.end(),
                                  [&](const Section& section) { return section.position == position; });
  if (found != family.sections.end()) {
    const Operation& first = found->operations.front();
    if (first.after != operation.after || first.may_give_up != operation.may_give_up || first.cost != operation.cost ||
        first.constraint != operation.constraint)
      throw InputError(description.file(), 0,
                       fmt::format("section {} cannot serve both {} and {}: they differ after the operation", position,
                                   first.name(), operation.name()));
    return *found;
  }
  family.sections.push_back({position, operation.ports(), description.serves_every_position(), {}});
  return family.sections.back();
}

/// All operations that one certificate serves.
Family family_of(const std::vector<Description>& descriptions, const std::string& certificate, unsigned max_k) {
  Family family{certificate, {}, {}, true};
  for (const Description& description : descriptions) {
    if (description.certificate != certificate) continue;
    family.has_table = description.has_table;
    const std::vector<Numbers> positions = description.positions(max_k);
    if (positions.empty())
      throw InputError(description.file(), 0, fmt::format("{} has no position up to {}", description.name, max_k));
    for (const Numbers& numbers : positions) {
      const Operation operation = description.at(numbers);
      if (description.listed.hold(numbers))
        section_at(family, description, operation).operations.push_back(operation);
      else
        family.unlisted.push_back(operation);
    }
  }
  return family;
}

}  // namespace

std::vector<Family> families_of(const std::vector<Description>& descriptions, unsigned max_k) {
  std::vector<std::string> certificates;
  for (const Description& description : descriptions) {
    std::erase(certificates, description.certificate);
    certificates.push_back(description.certificate);
  }
  std::vector<Family> families;
  families.reserve(certificates.size());
  for (const std::string& certificate : certificates) families.push_back(family_of(descriptions, certificate, max_k));
  return families;
}

std::vector<Family> all_families(unsigned max_k) { return families_of(shipped_descriptions(), max_k); }

std::vector<Family> tabled_families(unsigned max_k) {
  std::vector<Family> families = all_families(max_k);
  std::erase_if(families, [](const Family& family) { return !family.has_table; });
  return families;
}

Side patch_after(const std::string& certificate, const Numbers& numbers) {
  for (const Description& description : shipped_descriptions())
    if (description.certificate == certificate) return description.side_after(numbers);
  throw std::logic_error("no family " + certificate);
}

}  // namespace restrip::verify
