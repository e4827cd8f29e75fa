#pragma once
// The operations of tables/families.json, each at one position, as a patch before and a patch after; and the sections
// and families of certificates that serve them.

#include <optional>
#include <string>
#include <vector>

#include "formula.hpp"
#include "patch.hpp"

namespace restrip::verify {

/// One operation at one position.
struct Operation {
  std::string family;    ///< "open-collapse"
  std::string position;  ///< "k 8 gaps 2 5"; empty for the flip
  Numbers numbers;       ///< 8, 2, 5
  Patch before;
  Patch after;
  bool gives_ports_up = false;
  bool keyed_by_inner = false;       ///< a key's second mask is the inner edges, not `joined`
  std::optional<int> most_strips;    ///< as its family claims: no rule costs more
  std::optional<int> most_isolated;  ///< the same of isolated triangles

  std::string name() const { return position.empty() ? family : family + ' ' + position; }
};

/// One section of a certificate and the operations that its rows serve.
struct Section {
  std::string position;  ///< as the certificate writes it: "k 8"
  unsigned ports = 0;
  unsigned key_bits = 0;               ///< width of the second mask of a key: `joined`, or the inner edges before
  unsigned recoloring_bits = 0;        ///< inner edges after the operation
  bool serves_every_position = false;  ///< one rule for all positions of this k
  std::vector<Operation> operations;
};

struct Family {
  std::string name;  ///< of the certificate
  std::vector<Section> sections;
  std::vector<Operation> unlisted;  ///< in the positions that are mirror images or half turns of those of the sections
};

/// The largest fan that the shipped tables cover; up to here all recolourings are searched.
inline constexpr unsigned largest_fan = 8;
/// The largest fan that can be judged. Beyond those that are searched, rules are proved by their reasons and linked
/// rules by what is checked of their lists.
inline constexpr unsigned largest_judged_fan = 10;

inline bool searched(const Operation& operation) { return operation.before.ports() <= largest_fan; }

/// All families of certificates in the order of tables/families.json, fans up to `max_k` triangles, 3 <= max_k <= 10.
std::vector<Family> all_families(unsigned max_k = largest_fan);

/// Linked rules: the sections, patches and positions of another family, with lists instead of rules.
struct LinkedFamily {
  std::string name;
  Family local;
};

/// The families that have linked rules.
std::vector<LinkedFamily> linked_families(unsigned max_k = largest_fan);

/// The patch after an operation of this certificate, of which only numbers need to be given that it depends on.
Patch patch_after(const std::string& certificate, const Numbers& numbers);

}  // namespace restrip::verify
