// The lookup of a rule, for fans of eight triangles unless a name says otherwise: every family in the shipped layout;
// for splits against a direct table of all 4^k configurations, and against the automaton of all valences.
//
//   hot     the same 64 configurations again and again, tables in the first-level cache
//   random  4,096 valid configurations of all positions in random order
//   cold    the same, 64 at a time, each time after everything has been driven out of the caches
#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "restrip/rules/rules.hpp"
#include "settings.hpp"

namespace {

using restrip::Word;

struct Question {
  std::size_t i = 0;  ///< the position: a, or gap i, or gaps i and j
  std::size_t j = 0;
  Word before = 0;
  Word ports = 0;
};
constexpr std::size_t k = 8;

/// `bits`: of the colours before; `valid` says which questions there are.
template <class Valid>
std::vector<Question> questions(std::size_t count, std::size_t bits, Valid&& valid) {
  std::mt19937 random(1);
  std::vector<Question> list;
  while (list.size() < count) {
    Question q{random() % (k + 1), random() % (k + 1), random() % restrip::bit(bits), random() % restrip::bit(k)};
    if (valid(q)) list.push_back(q);
  }
  return list;
}

struct Split {
  static constexpr std::size_t bits = k;
  static bool valid(const Question& q) { return q.i >= 1 && q.i < k && restrip::valid_closed(k, q.before, q.ports); }
  auto operator()(const Question& q) const { return restrip::split_rule({k, q.i}, q.before, q.ports); }
};
struct Collapse {
  static constexpr std::size_t bits = k + 3;
  static bool valid(const Question& q) { return q.i >= 1 && q.i < k && restrip::valid_ring(k, q.i, q.before, q.ports); }
  auto operator()(const Question& q) const { return restrip::collapse_rule({k, q.i}, q.before, q.ports); }
};
struct OpenSplit {
  static constexpr std::size_t bits = k - 1;
  static bool valid(const Question& q) { return q.i < q.j && restrip::valid_open(k, q.before, q.ports); }
  auto operator()(const Question& q) const { return restrip::open_split_rule({k, q.i, q.j}, q.before, q.ports); }
};
struct OpenCollapse {
  static constexpr std::size_t bits = k + 2;
  static bool valid(const Question& q) {
    return q.i < q.j && restrip::valid_path_with_chord(k, q.i, q.j, q.before, q.ports);
  }
  auto operator()(const Question& q) const { return restrip::open_collapse_rule({k, q.i, q.j}, q.before, q.ports); }
};
struct BoundarySplit {
  static constexpr std::size_t bits = k - 1;
  static bool valid(const Question& q) { return restrip::valid_open(k, q.before, q.ports); }
  auto operator()(const Question& q) const { return restrip::boundary_split_rule({k, q.i}, q.before, q.ports); }
};
struct BoundaryCollapse {
  static constexpr std::size_t bits = k;
  static bool valid(const Question& q) { return restrip::valid_path(k, q.i, q.before, q.ports); }
  auto operator()(const Question& q) const { return restrip::boundary_collapse_rule({k, q.i}, q.before, q.ports); }
};
struct Flip {
  static constexpr std::size_t bits = 1;
  static bool valid(const Question& q) { return restrip::flip_rule(q.before != 0, q.ports & 15U).valid; }
  auto operator()(const Question& q) const {
    return restrip::flip_rule(q.before != 0, static_cast<unsigned>(q.ports) & 15U);
  }
};
/// Fans of four to eight triangles, as they come in a mesh; j is their length.
struct MixedSplit {
  static constexpr std::size_t bits = k;
  static bool valid(const Question& q) {
    return q.j >= 4 && q.j <= k && q.i >= 1 && q.i < q.j && (q.before | q.ports) < restrip::bit(q.j) &&
           restrip::valid_closed(q.j, q.before, q.ports);
  }
  auto operator()(const Question& q) const { return restrip::split_rule({q.j, q.i}, q.before, q.ports); }
};
/// Longer than the tables: read from the automaton.
struct LongSplit {
  static constexpr std::size_t length = 10;
  static constexpr std::size_t bits = length;
  static Word ports(const Question& q) { return q.ports | (Word{q.j} & 3U) << k; }
  static bool valid(const Question& q) { return q.i >= 1 && restrip::valid_closed(length, q.before, ports(q)); }
  auto operator()(const Question& q) const { return restrip::split_rule({length, q.i}, q.before, ports(q)); }
};
struct ExactSplit : Split {
  auto operator()(const Question& q) const {
    return restrip::exact::best_split(k, q.i, q.ports, restrip::joined_closed(k, q.before, q.ports)).colors;
  }
};
/// The layout we do not ship: one entry for each configuration of each position.
struct DirectSplit : Split {
  DirectSplit() : table((k - 1) * restrip::bit(2 * k)) {
    for (std::size_t a = 1; a < k; ++a)
      for (Word loop = 0; loop < restrip::bit(k); ++loop)
        for (Word ports = 0; ports < restrip::bit(k); ++ports)
          table[((a - 1) << k | loop) << k | ports] =
              static_cast<std::uint16_t>(restrip::split_rule({k, a}, loop, ports).colors);
  }
  auto operator()(const Question& q) const { return table[((q.i - 1) << k | q.before) << k | q.ports]; }
  std::vector<std::uint16_t> table;
};

constexpr std::size_t hot = 64;
constexpr std::size_t random_order = 4096;

template <class Family>
void lookup(benchmark::State& state) {
  const Family ask;
  const std::vector<Question> list = questions(static_cast<std::size_t>(state.range(0)), Family::bits, Family::valid);
  std::size_t i = 0;
  for ([[maybe_unused]] auto _ : state) {
    const Question& q = list[i];
    i = i + 1 == list.size() ? 0 : i + 1;
    benchmark::DoNotOptimize(ask(q));
  }
}

Word word_of(const restrip::Rule& rule) { return rule.colors; }
Word word_of(const restrip::FlipRule& rule) { return rule.ports; }
Word word_of(Word word) { return word; }

/// Each question waits for the answer to the one before, or memory would fetch many at a time.
template <class Family>
void cold_lookup(benchmark::State& state) {
  const Family ask;
  const std::vector<Question> list = questions(random_order, Family::bits, Family::valid);
  std::vector<std::uint64_t> larger_than_caches(std::size_t{12} << 20);
  std::size_t i = 0;
  for ([[maybe_unused]] auto _ : state) {
    for (std::uint64_t& word : larger_than_caches) word += i;
    const std::vector<Question> some(list.begin() + static_cast<std::ptrdiff_t>(i),
                                     list.begin() + static_cast<std::ptrdiff_t>(i + hot));
    i = i + hot == list.size() ? 0 : i + hot;
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t next = 0; next < hot; ++next) {
      Word answer = word_of(ask(some[next]));
      benchmark::DoNotOptimize(answer);
      next += answer >> 32;  // which is 0
    }
    state.SetIterationTime(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() /
                           static_cast<double>(hot));
  }
}

template <class Family>
void family(const char* name) {
  const std::string stem = std::string("lookup/") + name;
  benchmark::RegisterBenchmark((stem + "/hot").c_str(), lookup<Family>)->Arg(hot);
  benchmark::RegisterBenchmark((stem + "/random").c_str(), lookup<Family>)->Arg(random_order);
  const int sweeps = restrip::bench::settings().quick ? 2 : 32;  // of the cache, one a look-up
  benchmark::RegisterBenchmark((stem + "/cold").c_str(), cold_lookup<Family>)->UseManualTime()->Iterations(sweeps);
}

}  // namespace

namespace restrip::bench {

void register_benchmarks() {
  family<Split>("split");
  family<MixedSplit>("split, four to eight triangles");
  family<LongSplit>("split, ten triangles");
  family<DirectSplit>("split, direct table");
  family<ExactSplit>("split, automaton");
  family<Collapse>("collapse");
  family<OpenSplit>("open-split");
  family<OpenCollapse>("open-collapse");
  family<BoundarySplit>("boundary-split");
  family<BoundaryCollapse>("boundary-collapse");
  family<Flip>("flip");
}

}  // namespace restrip::bench
