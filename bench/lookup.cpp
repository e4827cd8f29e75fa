// The lookup of a rule: the shipped layout against a direct index over all 4^k configurations, and against the exact
// solver.
//
//   hot     the same 64 configurations again and again, tables in the first-level cache
//   random  4,096 valid configurations of all positions of k = 8 in random order
#include <benchmark/benchmark.h>

#include <cstdint>
#include <random>
#include <vector>

#include "restrip/rules.hpp"

namespace {

using restrip::Word;

struct Question {
  std::size_t a = 0;
  Word before = 0;
  Word ports = 0;
};
constexpr std::size_t k = 8;

std::vector<Question> valid_splits(std::size_t count) {
  std::mt19937 random(1);
  std::vector<Question> list;
  while (list.size() < count) {
    const Question q{1 + random() % (k / 2), random() % restrip::bit(k), random() % restrip::bit(k)};
    if (restrip::valid_closed(k, q.before, q.ports)) list.push_back(q);
  }
  return list;
}

std::vector<Question> valid_collapses(std::size_t count) {
  std::mt19937 random(2);
  std::vector<Question> list;
  while (list.size() < count) {
    const Question q{1 + random() % (k / 2), random() % restrip::bit(k + 3), random() % restrip::bit(k)};
    if (restrip::valid_ring(k, q.a, q.before, q.ports)) list.push_back(q);
  }
  return list;
}

/// The layout we do not ship: one entry for each configuration of each position.
std::vector<std::uint16_t> direct_index() {
  std::vector<std::uint16_t> table(k / 2 * restrip::bit(2 * k));
  for (std::size_t a = 1; a <= k / 2; ++a)
    for (Word loop = 0; loop < restrip::bit(k); ++loop)
      for (Word ports = 0; ports < restrip::bit(k); ++ports)
        table[((a - 1) << k | loop) << k | ports] =
            static_cast<std::uint16_t>(restrip::split_rule({k, a}, loop, ports).colors);
  return table;
}

template <class Ask>
void ask_all(benchmark::State& state, const std::vector<Question>& questions, Ask&& ask) {
  std::size_t i = 0;
  for (auto _ : state) {
    const Question& q = questions[i];
    i = i + 1 == questions.size() ? 0 : i + 1;
    benchmark::DoNotOptimize(ask(q));
  }
}

void split(benchmark::State& state) {
  ask_all(state, valid_splits(static_cast<std::size_t>(state.range(0))), [](const Question& q) {
    return restrip::split_rule({k, q.a}, q.before, q.ports);
  });
}
void split_direct_index(benchmark::State& state) {
  const auto table = direct_index();
  ask_all(state, valid_splits(static_cast<std::size_t>(state.range(0))),
          [&table](const Question& q) { return table[((q.a - 1) << k | q.before) << k | q.ports]; });
}
void split_exact_solver(benchmark::State& state) {
  ask_all(state, valid_splits(static_cast<std::size_t>(state.range(0))), [](const Question& q) {
    return restrip::exact::best_split(k, q.a, q.ports, restrip::joined_closed(k, q.before, q.ports)).colors;
  });
}
void collapse(benchmark::State& state) {
  ask_all(state, valid_collapses(static_cast<std::size_t>(state.range(0))), [](const Question& q) {
    return restrip::collapse_rule({k, q.a}, q.before, q.ports);
  });
}
void flip(benchmark::State& state) {
  unsigned i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(restrip::flip_rule((i & 16U) != 0, i & 15U));
    i = (i + 1) % 32;
  }
}

constexpr std::int64_t hot = 64;
constexpr std::int64_t random_order = 4096;
BENCHMARK(split)->Arg(hot)->Arg(random_order);
BENCHMARK(split_direct_index)->Arg(hot)->Arg(random_order);
BENCHMARK(split_exact_solver)->Arg(hot)->Arg(random_order);
BENCHMARK(collapse)->Arg(hot)->Arg(random_order);
BENCHMARK(flip);

}  // namespace
