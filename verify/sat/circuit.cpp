#include "sat/circuit.hpp"

#include <algorithm>

namespace restrip::verify::sat {

Circuit::Circuit() {
  cnf_.variables = yes;
  cnf_.clauses.push_back({yes});
}

Literal Circuit::all_of(Clause terms) {
  std::sort(terms.begin(), terms.end());
  terms.erase(std::unique(terms.begin(), terms.end()), terms.end());
  std::erase(terms, yes);
  const auto contradicted = [&](Literal term) {
    return term == no || std::binary_search(terms.begin(), terms.end(), -term);
  };
  if (std::any_of(terms.begin(), terms.end(), contradicted)) return no;
  if (terms.empty()) return yes;
  if (terms.size() == 1) return terms.front();
  const Literal gate = input();
  Clause closing{gate};
  for (const Literal term : terms) {
    cnf_.clauses.push_back({-gate, term});
    closing.push_back(-term);
  }
  cnf_.clauses.push_back(std::move(closing));
  return gate;
}

Literal Circuit::any_of(Clause terms) {
  for (Literal& term : terms) term = -term;
  return -all_of(std::move(terms));
}

std::vector<Literal> Circuit::at_least(const std::vector<Literal>& terms) {
  // One term after the other: m of them are true when m were before, or m - 1 were and this one is.
  std::vector<Literal> count(terms.size() + 2, no);
  count[0] = yes;
  for (const Literal term : terms)
    for (std::size_t m = terms.size(); m >= 1; --m) count[m] = any_of({count[m], all_of({term, count[m - 1]})});
  return count;
}

void Circuit::require(Clause clause) {
  if (std::find(clause.begin(), clause.end(), yes) != clause.end()) return;
  std::erase(clause, no);
  cnf_.clauses.push_back(std::move(clause));
}

}  // namespace restrip::verify::sat
