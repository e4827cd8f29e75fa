// A LiveMesh does random operations under every policy, cost and form with all oracles of tests/drive: the buffer draws
// the mesh, undo restores it, results are as counted, a bare list of triangles agrees, saved meshes load, and after a
// failed allocation all this is so again. Each oracle objects to a LiveMesh that breaks its promise.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "../support/large.hpp"
#include "baked_sequence.hpp"
#include "drive/driver.hpp"
#include "drive/live_subject.hpp"
#include "restrip/search/policy.hpp"
#include "sample_meshes.hpp"
#include "whole_mesh.hpp"

namespace restrip::drive {
namespace {

constexpr std::size_t endless = 1'000'000;  // a history that drops nothing

/// A LiveMesh that does only some calls.
class OnlySome : public LiveSubject {
 public:
  OnlySome(LiveMesh live, std::size_t history, bool (*some)(Call))
      : LiveSubject(std::move(live), history), some_(some) {}
  [[nodiscard]] bool can(Call call) const override { return LiveSubject::can(call) && some_(call); }

 private:
  bool (*some_)(Call);
};

TEST(LiveRandom, KeepsItsPromisesUnderEveryPolicyCostAndForm) {
  Tally sum;
  std::size_t judged = 0;
  std::size_t outgrown = 0;
  std::uint32_t seed = 0;
  for (const PolicyRow& row : policies)
    for (const Cost& cost : {Cost::strips(), Cost::indices(), Cost{5, 0, 2}})
      for (const StripForm form : {StripForm::restart, StripForm::stitched, StripForm::lengths, StripForm::list}) {
        SCOPED_TRACE(testing::Message() << row.name << " cost " << cost.swap << " form " << int(form));
        const IndexWidth width = seed % 2 == 0 ? IndexWidth::automatic : IndexWidth::bits32;
        // The usual layout, the largest numbers, and a buffer that may move nothing.
        constexpr std::array layouts{LayoutOptions{}, LayoutOptions{.cache = 64, .waste = 1'000'000, .work = 100},
                                     LayoutOptions{.cache = 8, .waste = 0, .work = 1}, LayoutOptions{1, 0, 0}};
        const LiveOptions options{.policy = row.policy,
                                  .cost = cost,
                                  .history = seed % 3 == 0 ? std::size_t{300} : endless,
                                  .format = {form, width},
                                  .layout = layouts[seed / 2 % layouts.size()]};
        const std::array starts{sample::torus(6, 5), sample::rectangle(6, 5), sample::tube(5, 6), sample::octahedron(),
                                sample::double_cone(9)};
        const std::string bytes = random_bytes(test::large(4000), ++seed);
        Input input(bytes);
        LiveSubject subject(LiveMesh(starts[seed % starts.size()], options), options.history);
        Oracles oracles(options.history);
        sum += drive(input, subject, oracles.all(), {.steps = 1000, .fewest = 12, .most = 120});
        judged += oracles.mirror.judged();
        outgrown += oracles.device.outgrown();
      }
  for (std::size_t call = 0; call < calls; ++call) {
    if (static_cast<Call>(call) != Call::move_to_level) {
      EXPECT_GT(sum.done[call], test::large(100)) << call;
    }
    if (is_operation(static_cast<Call>(call))) {
      EXPECT_GT(sum.refused[call], test::large(100)) << call;
    }
  }
  EXPECT_GT(judged, test::large(4000));
  EXPECT_GT(outgrown, test::large(100));
  EXPECT_GT(sum.failed, test::large(100));
}

/// Under the policy `local` no two ends of strips meet.
class NoEndsMeet : public Oracle {
 public:
  void begin(Subject& subject) override {
    promise(fault_of_ends(subject.live()->mesh()).empty(), "no two ends of strips meet, and strips are few");
  }
  void after(const Step& /*step*/, const Outcome& /*outcome*/, Subject& subject) override {
    if (++calls_ % 50 == 0) begin(subject);
  }

 private:
  std::size_t calls_ = 0;
};

// The bounds of the theory need many operations on larger meshes.
TEST(LiveRandom, OperationsAskTheirRulesAndAddLittle) {
  for (const Cost& cost : {Cost::strips(), Cost::indices()})
    for (const PolicyRow& row : policies) {
      if (row.policy == Policy::bare) continue;
      RuleCounts sum;
      for (StripMesh& start : std::array{sample::torus(16, 16), sample::rectangle(16, 16)}) {
        join_all(start);
        const std::string bytes = random_bytes(test::large(120'000), 41);
        Input input(bytes);
        OnlySome subject(LiveMesh(start, {.policy = row.policy, .cost = cost}), 0,
                         [](Call call) { return is_operation(call) || call == Call::update; });
        Bounds bounds;
        NoEndsMeet joined;
        std::vector<Oracle*> oracles{&bounds};
        if (row.policy == Policy::local && cost == Cost::strips()) oracles.push_back(&joined);
        drive(input, subject, oracles,
              {.steps = bytes.size(), .fewest = 300, .most = 900, .allocations_fail = false, .far_names = false});
        const RuleCounts& some = bounds.sum();
        sum = {sum.asked + some.asked, sum.taken + some.taken, sum.kept + some.kept, sum.improved + some.improved};
      }
      EXPECT_GT(sum.asked, test::large(12'000)) << row.name;
      EXPECT_EQ(sum.kept != 0, !(cost == Cost::strips()) && row.policy != Policy::rules) << row.name;
      EXPECT_EQ(sum.improved != 0, row.policy != Policy::rules) << row.name;
      EXPECT_LT(sum.improved, sum.asked) << row.name;
    }
}

// Every allocation of every call fails in turn: its first one, its second, until none is left.
TEST(LiveRandom, WorksAfterAnyAllocationHasFailed) {
  std::size_t failed = 0;
  for (const std::uint32_t seed : {1U, 2U, 3U}) {
    const std::string bytes = random_bytes(110, seed);
    const LiveOptions options{.policy = seed % 2 == 0 ? Policy::local : Policy::quick,
                              .cost = seed % 2 == 0 ? Cost::indices() : Cost::strips(),
                              .history = endless,
                              .format = {.form = static_cast<StripForm>(seed), .width = IndexWidth::automatic}};
    for (std::size_t step = 0; step < 30; step += 4 / test::large(4))  // each or every fourth
      for (std::uint32_t failing = 2;; ++failing) {
        Input input(bytes);
        LiveSubject subject(LiveMesh(sample::torus(5, 5), options), options.history);
        Oracles oracles(options.history, 0);
        const Limits limits{.steps = 40, .failing = failing, .failing_step = step};
        const Tally tally = drive(input, subject, oracles.all(), limits);
        failed += tally.failed;
        if (tally.shortages == 0) break;
      }
  }
  EXPECT_GT(failed, test::large(300));
}

TEST(LiveRandom, UndoesLevelsOfABakedMesh) {
  const auto file = baked_torus();
  Tally sum;
  for (std::uint32_t seed = 1; seed < 9; ++seed) {
    const std::string bytes = random_bytes(1000, seed);
    Input input(bytes);
    // Other calls may leave the levels without a frame that leads back.
    OnlySome subject(LiveMesh(file, {.history = endless}), endless, [](Call call) {
      return call == Call::flip || call == Call::move_to_level || call >= Call::update;
    });
    Oracles oracles(endless, 0);
    sum += drive(input, subject, oracles.all(), {.most = 300});
  }
  EXPECT_GT(sum.done[static_cast<std::size_t>(Call::move_to_level)], 100U);
}

// ---- each oracle objects

/// A LiveMesh whose results, or what they leave, are spoiled.
class Spoiled : public LiveSubject {
 public:
  using Spoil = std::function<void(const Step&, Outcome&, LiveMesh&)>;
  Spoiled(LiveMesh live, Spoil spoil) : LiveSubject(std::move(live), endless), spoil_(std::move(spoil)) {}
  Outcome perform(const Step& step) override {
    Outcome outcome = LiveSubject::perform(step);
    if (outcome.done()) spoil_(step, outcome, live_);
    return outcome;
  }

 private:
  Spoil spoil_;
};

struct Fault {
  const char* objection;
  Spoiled::Spoil spoil;
};

bool flip_one(LiveMesh& live) {
  for (Triangle t = 0; t < live.mesh().triangle_bound(); ++t)
    if (live.flip(StripMesh::halfedge(t, 1))) return true;
  return false;
}

TEST(LiveRandom, EachOracleObjects) {
  const std::vector<Fault> faults{
      {"ranges of an update are all",
       [](const Step& step, Outcome& outcome, LiveMesh&) {
         if (step.call == Call::update && !outcome.upload.empty())
           static_cast<std::span<const IndexRange>&>(outcome.upload) = outcome.upload.first(outcome.upload.size() - 1);
       }},
      {"what is drawn are the triangles",
       [](const Step& step, Outcome&, LiveMesh& live) {
         if (step.call == Call::update) flip_one(live);
       }},
      {"no alarm is false",
       [](const Step& step, Outcome& outcome, LiveMesh&) { outcome.upload.outgrown |= step.call == Call::update; }},
      {"an outgrown buffer is reported",
       [](const Step&, Outcome& outcome, LiveMesh&) { outcome.upload.outgrown = false; }},
      {"restored exactly",
       [](const Step& step, Outcome& outcome, LiveMesh& live) {
         if (step.call == Call::undo && outcome.moved) flip_one(live);
       }},
      {"a change is one frame",
       [](const Step& step, Outcome&, LiveMesh& live) {
         if (step.call == Call::update && flip_one(live)) live.update();
       }},
      {"operations report strips", [](const Step& step, Outcome& outcome,
                                      LiveMesh&) { outcome.rewrite.strips += is_operation(step.call) ? 1 : 0; }},
      {"operations report isolated", [](const Step&, Outcome& outcome, LiveMesh&) { --outcome.rewrite.isolated; }},
      {"the cost saved", [](const Step&, Outcome& outcome, LiveMesh&) { ++outcome.number; }},
      {"asks one rule",
       [](const Step& step, Outcome&, LiveMesh& live) {
         if (step.call == Call::flip) flip_one(live);
       }},
      {"granted exactly",
       [](const Step& step, Outcome& outcome, LiveMesh&) {
         if (step.call == Call::bisect) outcome.end = Outcome::End::refused;
       }},
      {"does what it does to any mesh",
       [](const Step& step, Outcome&, LiveMesh& live) {
         if (step.call == Call::collapse) flip_one(live);
       }},
      {"packed triangles stay in order",
       [](const Step& step, Outcome& outcome, LiveMesh&) {
         if (step.call == Call::pack) std::reverse(outcome.numbers.triangles.begin(), outcome.numbers.triangles.end());
       }},
      {"its policy, cost", [](const Step& step, Outcome&, LiveMesh& live) {
         if (step.call == Call::reload) live.keep(Policy::rules, Cost{7, 3, 2});
       }}};
  for (const Fault& fault : faults) {
    std::string objections;
    for (std::uint32_t seed = 1; seed < 30 && objections.find(fault.objection) == std::string::npos; ++seed) {
      const std::string bytes = random_bytes(800, seed);
      Input input(bytes);
      Spoiled subject(LiveMesh(sample::torus(6, 5), {.history = endless}), fault.spoil);
      Oracles oracles(endless);
      std::vector<Oracle*> order;
      for (Oracle* oracle : oracles.all()) order.push_back(oracle);
      std::rotate(order.begin(), order.begin() + seed % 7, order.end());
      try {
        drive(input, subject, order);
      } catch (const std::logic_error& error) {
        objections += std::string(error.what()) + "; ";
      }
    }
    EXPECT_NE(objections.find(fault.objection), std::string::npos) << fault.objection << " among " << objections;
  }
  // A twin under another policy.
  const std::string bytes = random_bytes(800, 1);
  Input input(bytes);
  LiveSubject subject(LiveMesh(sample::torus(6, 5), {.policy = Policy::quick}), 0);
  LiveSubject other(LiveMesh(sample::torus(6, 5), {.policy = Policy::bare}), 0);
  Twin twin(other);
  EXPECT_THROW(drive(input, subject, std::array<Oracle*, 1>{&twin}), std::logic_error);
}

}  // namespace
}  // namespace restrip::drive
