#include "model/operation.hpp"

#include <algorithm>

namespace restrip::verify {

unsigned most_solid(Constraint constraint) { return constraint == Constraint::strips ? 2 : 1; }

bool may_have_reasons(const Operation& operation) {
  const std::vector<Criterion> first = default_cost(Constraint::strips);
  return operation.constraint != Constraint::matching && operation.cost.size() >= first.size() &&
         std::equal(first.begin(), first.end(), operation.cost.begin());
}

std::vector<Criterion> default_cost(Constraint constraint) {
  std::vector<Criterion> cost = {{{Count::strips}}, {{Count::isolated}, {Count::given_up}}, {{Count::given_up}}};
  if (constraint == Constraint::matching) cost.erase(cost.begin());
  return cost;
}

}  // namespace restrip::verify
