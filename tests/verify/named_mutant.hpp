// The deliberate faults of a program by their names, which mutants.cmake reads from the header that lists them.
#pragma once

#include <optional>
#include <string_view>

#include "mutant_names.hpp"

namespace restrip::verify::test {

// Without a default case: the compiler warns about a fault that is not among the names.
template <class Mutant>
constexpr std::string_view name_of(Mutant mutant) {
  switch (mutant) {
#define RESTRIP_CASE(name) \
  case Mutant::name:       \
    return #name;
    RESTRIP_EACH_MUTANT(RESTRIP_CASE)
#undef RESTRIP_CASE
  }
  return {};
}

template <class Mutant>
std::optional<Mutant> mutant_named(std::string_view name) {
#define RESTRIP_ITEM(name) Mutant::name,
  for (const Mutant mutant : {RESTRIP_EACH_MUTANT(RESTRIP_ITEM)})
    if (name_of(mutant) == name) return mutant;
#undef RESTRIP_ITEM
  return std::nullopt;
}

}  // namespace restrip::verify::test
