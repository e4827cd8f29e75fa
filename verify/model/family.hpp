// The operations of a list of descriptions, each at one position, and the sections of certificates that serve them.
#pragma once

#include <string>
#include <vector>

#include "model/description.hpp"

namespace restrip::verify {

/// One section of a certificate and the operations that its rows serve, which share the patch after.
struct Section {
  std::string position;  ///< as the certificate writes it: "k 8"
  unsigned ports = 0;
  bool serves_every_position = false;  ///< it omits some number of the position: one rule for all values of it
  std::vector<Operation> operations;
};

/// The content of one certificate.
struct Family {
  std::string name;  ///< of the certificate
  std::vector<Section> sections;
  std::vector<Operation> unlisted;  ///< in positions that are images of positions in the sections
  bool has_table = true;            ///< of a shipped family: the shipped tables have its rules, not the automaton
};

/// The largest fan that the shipped tables cover.
inline constexpr unsigned largest_fan = 8;
/// The largest fan that can be judged.
inline constexpr unsigned largest_judged_fan = 10;

/// One for each certificate named in the descriptions, at the index of the last of its descriptions; positions whose
/// first number is at most `max_k`. Throws files::FileError if a description has no such position.
std::vector<Family> families_of(const std::vector<Description>& descriptions, unsigned max_k);
/// The families of the shipped descriptions, 3 <= max_k <= 10; and only those that have a table.
std::vector<Family> all_families(unsigned max_k = largest_fan);
std::vector<Family> tabled_families(unsigned max_k = largest_fan);

/// The patch after an operation of this shipped certificate; only the numbers on which it depends are needed.
Side patch_after(const std::string& certificate, const Numbers& numbers);

}  // namespace restrip::verify
