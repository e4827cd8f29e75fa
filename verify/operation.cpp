#include "operation.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "family_file.hpp"

namespace restrip::verify {
namespace {

/// The smaller one, where there are two.
std::optional<int> lower(std::optional<int> one, std::optional<int> other) {
  return one && other ? std::min(one, other) : (one ? one : other);
}

Operation operation_at(const FamilyDescription& description, const Numbers& numbers) {
  Operation operation{description.name,
                      description.filled(description.position, numbers),
                      numbers,
                      description.before.patch(numbers),
                      description.after.patch(numbers),
                      description.gives_ports_up,
                      description.keyed_by_inner,
                      {},
                      {}};
  if (operation.before.ports() != operation.after.ports())
    throw std::logic_error(operation.name() + " has other ports after than before");
  for (const FamilyBound& bound : description.at_most) {
    if (!bound.where.hold(numbers)) continue;
    operation.most_strips = lower(operation.most_strips, bound.strips);
    operation.most_isolated = lower(operation.most_isolated, bound.isolated);
  }
  return operation;
}

Section& section_at(Family& family, const std::string& position, const FamilyDescription& description,
                    const Operation& operation) {
  const auto found = std::find_if(family.sections.begin(), family.sections.end(),
                                  [&](const Section& section) { return section.position == position; });
  if (found != family.sections.end()) return *found;
  const unsigned ports = operation.before.ports();
  family.sections.push_back({position,
                             ports,
                             operation.keyed_by_inner ? operation.before.inner_edges() : ports,
                             operation.after.inner_edges(),
                             description.serves_every_position(),
                             {}});
  return family.sections.back();
}

/// All families of operations that one certificate serves.
Family family_of(const std::string& certificate, unsigned max_k) {
  Family family{certificate, {}, {}};
  for (const FamilyDescription& description : family_descriptions()) {
    if (description.certificate != certificate) continue;
    for (const Numbers& numbers : description.positions(max_k)) {
      const Operation operation = operation_at(description, numbers);
      if (!description.listed.hold(numbers)) {
        family.unlisted.push_back(operation);
        continue;
      }
      const std::string position = description.filled(description.section, numbers);
      section_at(family, position, description, operation).operations.push_back(operation);
    }
  }
  if (family.sections.empty()) throw std::logic_error("the family " + certificate + " has no position");
  return family;
}

}  // namespace

std::vector<Family> all_families(unsigned max_k) {
  // A certificate stands where the last of its families does.
  std::vector<std::string> certificates;
  for (const FamilyDescription& description : family_descriptions()) {
    std::erase(certificates, description.certificate);
    certificates.push_back(description.certificate);
  }
  std::vector<Family> families;
  families.reserve(certificates.size());
  for (const std::string& certificate : certificates) families.push_back(family_of(certificate, max_k));
  return families;
}

std::vector<LinkedFamily> linked_families(unsigned max_k) {
  std::vector<LinkedFamily> families;
  for (const FamilyDescription& description : family_descriptions())
    if (description.linked)
      families.push_back({"linked-" + description.certificate, family_of(description.certificate, max_k)});
  return families;
}

Patch patch_after(const std::string& certificate, const Numbers& numbers) {
  for (const FamilyDescription& description : family_descriptions())
    if (description.certificate == certificate) return description.after.patch(numbers);
  throw std::logic_error("no family " + certificate);
}

}  // namespace restrip::verify
