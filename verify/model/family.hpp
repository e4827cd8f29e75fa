#pragma once
// The operations of a list of descriptions, each at one position, and the sections of certificates that serve them.

#include <string>
#include <vector>

#include "model/description.hpp"

namespace restrip::verify {

/// One section of a certificate and the operations that its rows serve. They have one patch after.
struct Section {
  std::string position;  ///< as the certificate writes it: "k 8"
  unsigned ports = 0;
  bool serves_every_position = false;  ///< it leaves some number of the position out: one rule for all values of it
  std::vector<Operation> operations;
};

/// What one certificate proves.
struct Family {
  std::string name;  ///< of the certificate
  std::vector<Section> sections;
  std::vector<Operation> unlisted;  ///< in the positions that are images of those of the sections
};

/// The largest fan that the shipped tables cover.
inline constexpr unsigned largest_fan = 8;
/// The largest fan that can be judged.
inline constexpr unsigned largest_judged_fan = 10;

/// One for each certificate that the descriptions name, where the last of its descriptions stands; positions whose
/// first number is at most `max_k`. InputError when a description has none of them.
std::vector<Family> families_of(const std::vector<Description>& descriptions, unsigned max_k);
/// Those of the shipped descriptions, 3 <= max_k <= 10.
std::vector<Family> all_families(unsigned max_k = largest_fan);

/// Linked rules: the sections, patches and positions of another family, with lists instead of rules.
struct LinkedFamily {
  std::string name;
  Family local;
};

/// Those of the shipped descriptions that have linked rules.
std::vector<LinkedFamily> linked_families(unsigned max_k = largest_fan);

/// The patch after an operation of this shipped certificate, of which only numbers need to be given that it depends on.
Side patch_after(const std::string& certificate, const Numbers& numbers);

}  // namespace restrip::verify
