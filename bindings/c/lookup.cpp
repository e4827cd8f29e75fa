// The rules by themselves: the last part of the C interface.
#include <cstdint>

#include "restrip.h"
#include "restrip/rules/rules.hpp"

namespace {

using namespace restrip;

/// The answer of rule_of() in a position that is `there`. `ports` remain.
template <class RuleOf>
restrip_status answered(bool there, std::uint64_t ports, restrip_answer* answer, RuleOf&& rule_of) noexcept {
  if (answer == nullptr) return RESTRIP_NULL_ARGUMENT;
  if (!there) return RESTRIP_BAD_ARGUMENT;
  const Rule rule = rule_of();
  if (!rule.valid) return RESTRIP_BAD_COLORING;
  *answer = {rule.colors, ports, rule.strips};
  return RESTRIP_OK;
}
constexpr bool closed_place(std::uint32_t k, std::uint32_t a) noexcept {
  return 3 <= k && k <= RESTRIP_LARGEST_FAN && 1 <= a && a < k;
}
constexpr bool open_place(std::uint32_t k, std::uint32_t i, std::uint32_t j) noexcept {
  return 1 <= k && k <= RESTRIP_LARGEST_FAN && i <= j && j <= k;
}
static_assert(RESTRIP_LARGEST_FAN == max_word_valence);

}  // namespace

restrip_status restrip_lookup_split(std::uint32_t k, std::uint32_t a, std::uint64_t loop, std::uint64_t ports,
                                    restrip_answer* answer) {
  return answered(closed_place(k, a), ports, answer, [=] { return split_rule({k, a}, loop, ports); });
}
restrip_status restrip_lookup_collapse(std::uint32_t k, std::uint32_t a, std::uint64_t inner, std::uint64_t ports,
                                       restrip_answer* answer) {
  return answered(closed_place(k, a), ports, answer, [=] { return collapse_rule({k, a}, inner, ports); });
}
restrip_status restrip_lookup_open_split(std::uint32_t k, std::uint32_t i, std::uint32_t j, std::uint64_t loop,
                                         std::uint64_t ports, restrip_answer* answer) {
  return answered(open_place(k, i, j) && i != j, ports, answer, [=] {
    return open_split_rule({k, i, j}, loop, ports);
  });
}
restrip_status restrip_lookup_open_collapse(std::uint32_t k, std::uint32_t i, std::uint32_t j, std::uint64_t inner,
                                            std::uint64_t ports, restrip_answer* answer) {
  return answered(open_place(k, i, j) && i != j, ports, answer, [=] {
    return open_collapse_rule({k, i, j}, inner, ports);
  });
}
restrip_status restrip_lookup_boundary_split(std::uint32_t k, std::uint32_t i, std::uint64_t loop, std::uint64_t ports,
                                             restrip_answer* answer) {
  return answered(open_place(k, i, i), ports, answer, [=] { return boundary_split_rule({k, i}, loop, ports); });
}
restrip_status restrip_lookup_boundary_collapse(std::uint32_t k, std::uint32_t i, std::uint64_t inner,
                                                std::uint64_t ports, restrip_answer* answer) {
  return answered(open_place(k, i, i), ports, answer, [=] { return boundary_collapse_rule({k, i}, inner, ports); });
}
restrip_status restrip_lookup_flip(std::uint64_t inner, std::uint64_t ports, restrip_answer* answer) {
  if (answer == nullptr) return RESTRIP_NULL_ARGUMENT;
  if (inner > 1 || ports > 15) return RESTRIP_BAD_COLORING;
  const FlipRule rule = flip_rule(inner != 0, static_cast<unsigned>(ports));
  if (!rule.valid) return RESTRIP_BAD_COLORING;
  *answer = {rule.inner ? Word{1} : Word{0}, rule.ports, rule.strips};
  return RESTRIP_OK;
}
