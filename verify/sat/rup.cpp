#include "sat/rup.hpp"

#include <algorithm>

namespace restrip::verify::sat {
namespace {

/// The same for any order of the literals.
std::uint64_t hash_of(const Clause& clause) {
  std::uint64_t sum = 0;
  for (const Literal literal : clause) {
    std::uint64_t x = static_cast<std::uint64_t>(static_cast<std::int64_t>(literal)) * 0x9e3779b97f4a7c15U;
    x ^= x >> 29;
    sum += x * 0xbf58476d1ce4e5b9U;
  }
  return sum;
}

void drop_repeated(Clause& clause) {
  std::sort(clause.begin(), clause.end());
  clause.erase(std::unique(clause.begin(), clause.end()), clause.end());
}

}  // namespace

RupClauses::RupClauses(int variables)
    : watchers_(2 * static_cast<std::size_t>(variables) + 2),
      value_(watchers_.size(), Value::open),
      reason_(static_cast<std::size_t>(variables) + 1, none),
      seen_(reason_.size(), false) {}

RupClauses::Id RupClauses::add(Clause clause) {
  drop_repeated(clause);
  const Id id = static_cast<Id>(clauses_.size());
  by_hash_.emplace(hash_of(clause), id);
  if (clause.size() < 2) {
    short_.push_back(id);
  } else {
    watchers_[index(clause[0])].push_back(id);
    watchers_[index(clause[1])].push_back(id);
  }
  clauses_.push_back(std::move(clause));
  return id;
}

bool RupClauses::remove(Clause clause) {
  drop_repeated(clause);
  const auto [first, last] = by_hash_.equal_range(hash_of(clause));
  for (auto entry = first; entry != last; ++entry) {
    const Id id = entry->second;
    if (!std::is_permutation(clause.begin(), clause.end(), clauses_[id].begin(), clauses_[id].end())) continue;
    if (clause.size() < 2) {
      std::erase(short_, id);
    } else {
      std::erase(watchers_[index(clauses_[id][0])], id);
      std::erase(watchers_[index(clauses_[id][1])], id);
    }
    clauses_[id].clear();
    by_hash_.erase(entry);
    return true;
  }
  return false;
}

bool RupClauses::assign(Literal literal, Id reason) {
  if (value_[index(literal)] != Value::open) return value_[index(literal)] == Value::yes;
  value_[index(literal)] = Value::yes;
  value_[index(-literal)] = Value::no;
  reason_[variable(literal)] = reason;
  trail_.push_back(literal);
  return true;
}

RupClauses::Id RupClauses::assign_units() {
  for (const Id id : short_)
    if (clauses_[id].empty() || !assign(clauses_[id].front(), id)) return id;
  return none;
}

RupClauses::Id RupClauses::propagate_one(Literal false_literal) {
  std::vector<Id>& watchers = watchers_[index(false_literal)];
  std::size_t kept = 0;
  Id conflict = none;
  for (std::size_t i = 0; i < watchers.size(); ++i) {
    const Id id = watchers[i];
    Clause& clause = clauses_[id];
    if (conflict != none) {
      watchers[kept++] = id;
      continue;
    }
    if (clause[0] == false_literal) std::swap(clause[0], clause[1]);
    if (value_[index(clause[0])] != Value::yes) {
      const auto other = std::find_if(clause.begin() + 2, clause.end(),
                                      [&](Literal literal) { return value_[index(literal)] != Value::no; });
      if (other != clause.end()) {
        std::swap(clause[1], *other);
        watchers_[index(clause[1])].push_back(id);
        continue;
      }
      if (!assign(clause[0], id)) conflict = id;
    }
    watchers[kept++] = id;
  }
  watchers.resize(kept);
  return conflict;
}

RupClauses::Id RupClauses::propagate() {
  Id conflict = none;
  while (conflict == none && propagated_ < trail_.size()) conflict = propagate_one(-trail_[propagated_++]);
  return conflict;
}

std::vector<RupClauses::Id> RupClauses::used_for(Id conflict) {
  std::vector<Id> used{conflict};
  const auto mark = [&](Id id) {
    for (const Literal literal : clauses_[id]) seen_[variable(literal)] = true;
  };
  mark(conflict);
  for (auto literal = trail_.rbegin(); literal != trail_.rend(); ++literal) {
    const Id reason = reason_[variable(*literal)];
    if (!seen_[variable(*literal)] || reason == none) continue;
    used.push_back(reason);
    mark(reason);
  }
  std::fill(seen_.begin(), seen_.end(), false);
  return used;
}

void RupClauses::forget_assignment() {
  for (const Literal literal : trail_) value_[index(literal)] = value_[index(-literal)] = Value::open;
  trail_.clear();
  propagated_ = 0;
}

std::optional<std::vector<RupClauses::Id>> RupClauses::used_to_derive(const Clause& clause) {
  std::optional<std::vector<Id>> used;
  // Starting afresh each time keeps deletions simple: no clause is ever the reason for something that stays.
  if (!std::all_of(clause.begin(), clause.end(), [&](Literal literal) { return assign(-literal, none); })) {
    used.emplace();  // it contains a literal and its negation
  } else {
    Id conflict = assign_units();
    if (conflict == none) conflict = propagate();
    if (conflict != none) used = used_for(conflict);
  }
  forget_assignment();
  return used;
}

}  // namespace restrip::verify::sat
