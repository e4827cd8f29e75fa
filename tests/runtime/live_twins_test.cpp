// Undo is exact: a LiveMesh that did and undid any work cannot be told from its twin, which never did it.
//
// Both get the same beginning. One then does random frames - operations, background work, recolourings, other policies,
// baked levels - and undoes them. From then on both do the same: results, handles, colours, counts and the bytes of the
// buffer are equal after every step.
#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <vector>

#include "measure/check_buffer.hpp"
#include "random_operation.hpp"
#include "restrip/formats/baked_file.hpp"
#include "restrip/live_mesh.hpp"
#include "restrip/output/live_buffer.hpp"
#include "restrip/search/policy.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"
#include "whole_mesh.hpp"

namespace restrip {
namespace {

struct Twins {
  LiveMesh one;
  LiveMesh other;

  template <class Work>
  void both(Work&& work) {
    work(one);
    work(other);
  }
  void expect_equal() {
    ASSERT_EQ(look_at(one.mesh()), look_at(other.mesh()));
    ASSERT_EQ(one.index_bytes(), other.index_bytes());
    ASSERT_TRUE(std::equal(one.bytes().begin(), one.bytes().end(), other.bytes().begin(), other.bytes().end()));
    ASSERT_EQ(one.strips(), other.strips());
    ASSERT_EQ(one.keeper().cost(), other.keeper().cost());
    ASSERT_EQ(one.level(), other.level());
    ASSERT_EQ(one.strips(), count_strips(one.mesh()));
  }
};

StripMesh::Halfedge random_halfedge_that_flips(const StripMesh& mesh) {
  std::mt19937 random(1);
  StripMesh::Halfedge h;
  do h = random_halfedge(mesh, random);
  while (check_flip(mesh, h) != Refusal::granted);
  return h;
}

Checked operate(LiveMesh& live, std::mt19937& random) {
  const StripMesh& mesh = live.mesh();
  return perform(live, draw(mesh, random, all_operations, trend_between(0, 300, mesh.triangle_count())));
}

/// What the results of some work were, so that two can be compared.
using Results = std::vector<std::uint64_t>;

Results work_on(LiveMesh& live, std::mt19937& random) {
  Results results;
  if (live.level() && random() % 4 != 0) {
    const std::size_t wanted = random() % (live.baked()->splits.size() + 1);
    results.push_back(live.move_to_level(wanted, random() % 40));
    return results;
  }
  for (auto n = random() % 12; n > 0; --n) {
    const Checked done = operate(live, random);
    for (const std::uint64_t number : {std::uint64_t(done.refusal), std::uint64_t{done.rewrite.halfedge.id},
                                       std::uint64_t{done.new_vertex()}, std::uint64_t(done.rewrite.strips)})
      results.push_back(number);
  }
  if (random() % 3 == 0) results.push_back(live.improve(random() % 2000));
  if (random() % 4 == 0) results.push_back(live.recolor(random() % 3 == 0 ? Effort::full : Effort::fast, default_cost));
  if (random() % 8 == 0) {
    const std::vector<std::uint8_t> dashed(live.mesh().triangle_bound(), 0);
    results.push_back(std::uint64_t{live.recolor(dashed)});
  }
  return results;
}

/// Does work in one or several frames, with other policies between if `keeps`, and undoes all of it.
void work_in_vain(LiveMesh& live, std::mt19937& random, bool keeps) {
  const Policy policy = live.keeper().policy();
  const Cost cost = live.keeper().weights();
  live.update();
  const std::size_t undoable = live.undoable();
  for (auto frames = 1 + random() % 3; frames > 0; --frames) {
    ASSERT_TRUE(live.flip(random_halfedge_that_flips(live.mesh())));  // without a change there is no frame
    work_on(live, random);
    if (keeps)
      live.keep(random() % 2 == 0 ? Policy::local : Policy::full, random() % 2 == 0 ? Cost::strips() : Cost{2, 1, 1});
    if (random() % 2 == 0) live.update();
  }
  if (keeps) live.keep(policy, cost);
  live.update();
  while (live.undoable() > undoable) ASSERT_TRUE(live.undo());
  if (random() % 2 == 0 && live.redo()) {
    ASSERT_TRUE(live.undo());
  }
}

void live_as_twins(Twins twins, const LiveOptions& options, unsigned seed, int rounds, bool keeps) {
  std::mt19937 random(seed);
  for (int round = 0; round < rounds && !testing::Test::HasFatalFailure(); ++round) {
    twins.other.update();
    work_in_vain(twins.one, random, keeps);
    twins.both([](LiveMesh& live) { live.update(); });
    twins.expect_equal();
    for (auto frames = random() % 3; frames > 0; --frames) {
      std::mt19937 same = random;
      const Results results = work_on(twins.one, random);
      ASSERT_EQ(results, work_on(twins.other, same));
      twins.both([](LiveMesh& live) { live.update(); });
      twins.expect_equal();
    }
    if (round % 7 == 6 && keeps) {
      const Policy policy = policies[1 + random() % (policies.size() - 2)].policy;
      twins.both([&](LiveMesh& live) { live.keep(policy, options.cost); });
    }
  }
}

TEST(LiveTwins, UndoneWorkLeavesNoTrace) {
  unsigned seed = 0;
  for (const PolicyRow& row : policies)
    for (const Cost& cost : {Cost::strips(), Cost::indices()})
      for (const StripForm form : {StripForm::restart, StripForm::stitched, StripForm::lengths}) {
        SCOPED_TRACE(testing::Message() << row.name << " cost " << cost.swap << " form " << int(form));
        const IndexWidth width = seed % 2 == 0 ? IndexWidth::automatic : IndexWidth::bits32;
        const LiveOptions options{.policy = row.policy, .cost = cost, .history = 100'000, .format = {form, width}};
        const StripMesh mesh = seed % 3 == 0 ? sample::torus(9, 10) : sample::rectangle(11, 9);
        live_as_twins({LiveMesh(mesh, options), LiveMesh(mesh, options)}, options, ++seed,
                      row.policy == Policy::best ? 3 : 10, false);
        if (HasFatalFailure()) return;
      }
}

TEST(LiveTwins, AlsoWithOtherPoliciesAndCostsInBetween) {
  unsigned seed = 100;
  for (const Policy policy : {Policy::rules, Policy::quick, Policy::full})
    for (const Cost& cost : {Cost::strips(), Cost::indices()}) {
      SCOPED_TRACE(testing::Message() << int(policy) << " cost " << cost.swap);
      const LiveOptions options{.policy = policy, .cost = cost, .history = 100'000};
      const StripMesh mesh = sample::torus(10, 9);
      live_as_twins({LiveMesh(mesh, options), LiveMesh(mesh, options)}, options, ++seed, 12, true);
      if (HasFatalFailure()) return;
    }
}

/// A torus that is coarsened at random. The flips clear one of the dual edges that each record makes solid.
std::shared_ptr<const BakedFile> baked_torus() {
  auto file = std::make_shared<BakedFile>();
  StripMesh mesh = sample::torus(12, 12);
  std::mt19937 random(5);
  while (mesh.triangle_count() > 60) {
    const StripMesh::Halfedge h = random_halfedge(mesh, random);
    if (check_collapse(mesh, h) != Refusal::granted) continue;
    file->splits.push_back(record_of_collapse(mesh, h));
    mesh.remove_vertex(h);
  }
  std::reverse(file->splits.begin(), file->splits.end());
  file->points.resize(144);
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.alive(t)) file->base.push_back(mesh.corners(t));
  file->mesh = StripMesh::build(file->base, 144);
  stripify(file->mesh, Effort::fast, Cost::strips());
  mesh = file->mesh;
  for (const SplitRecord& split : file->splits) {
    const StripMesh::Halfedge chord = split_baked(mesh, spokes_of(mesh, split), {}, split.v_t).halfedge;
    const StripMesh::Halfedge side = StripMesh::next(chord);
    if (mesh.solid(side)) {
      file->records.flips.push_back(side);
      mesh.set_solid(side, false);
    }
    file->records.first.push_back(static_cast<std::uint32_t>(file->records.flips.size()));
  }
  EXPECT_GT(file->records.flips.size(), 10U);
  EXPECT_TRUE(check_coloring(mesh).valid);
  return file;
}

TEST(LiveTwins, OfABakedMeshStayInStep) {
  const auto file = baked_torus();
  for (unsigned seed = 1; seed < 5; ++seed) {
    const LiveOptions options{.history = seed % 2 == 0 ? 100'000U : 50'000U};
    live_as_twins({LiveMesh(file, options), LiveMesh(file, options)}, options, seed, 12, false);
  }
}

TEST(LiveTwins, ABakedMeshPlaysItsLevelsAndBeginsAgain) {
  const auto file = baked_torus();
  LiveMesh live(file, {.history = 100'000});
  ASSERT_EQ(live.baked(), file.get());
  const auto base = look_at(live.mesh());
  EXPECT_EQ(live.level(), 0U);
  EXPECT_EQ(live.move_to_level(file->splits.size(), 10), 10U);
  live.update();
  EXPECT_EQ(live.move_to_level(file->splits.size()), file->splits.size() - 10);
  EXPECT_EQ(live.mesh().triangle_count(), 288U);
  // An operation leaves the levels, and undoing it returns to them.
  live.update();
  ASSERT_TRUE(live.flip(random_halfedge_that_flips(live.mesh())));
  EXPECT_EQ(live.level(), std::nullopt);
  EXPECT_EQ(live.move_to_level(0), 0U);
  ASSERT_TRUE(live.undo());
  EXPECT_EQ(live.level(), file->splits.size());
  ASSERT_TRUE(live.undo());
  EXPECT_EQ(live.level(), 10U);
  EXPECT_EQ(live.move_to_level(0), 10U);
  EXPECT_EQ(triangles_of(live.mesh()), triangles_of(file->mesh));
  live.keep(Policy::full, Cost::indices());
  EXPECT_EQ(live.level(), std::nullopt);
  ASSERT_TRUE(live.flip(random_halfedge_that_flips(live.mesh())));
  live.restart();
  EXPECT_EQ(live.level(), 0U);
  EXPECT_EQ(look_at(live.mesh()), base);
  EXPECT_EQ(live.undoable(), 0U);
  EXPECT_NE(live.update().size(), 0U);
  EXPECT_EQ(triangles_of_strips(live.indices()), triangles_of(live.mesh()));
  EXPECT_EQ(live.move_to_level(file->splits.size()), file->splits.size());
  // A saved mesh has its strips, but not its levels.
  const LiveMesh loaded = LiveMesh::load(live.save());
  EXPECT_EQ(look_at(loaded.mesh()), look_at(live.mesh()));
  EXPECT_EQ(loaded.baked(), nullptr);
  EXPECT_EQ(loaded.level(), std::nullopt);
}

TEST(LiveTwins, RecoloringsAreFramesAndRefuseWhatIsNotValid) {
  LiveMesh live(sample::torus(9, 9), {.history = 100'000});
  const auto before = look_at(live.mesh());
  const std::size_t strips = live.recolor(Effort::full, Cost::strips());
  EXPECT_EQ(strips, live.strips());
  EXPECT_EQ(strips, count_strips(live.mesh()));
  const Upload all = live.update();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].count, live.indices().size());
  EXPECT_EQ(live.undoable(), 1U);
  ASSERT_TRUE(live.undo());
  EXPECT_EQ(look_at(live.mesh()), before);

  std::vector<std::uint8_t> colors(162, 0);
  EXPECT_FALSE(live.recolor(std::span(colors).first(161)));
  colors[3] = 1;  // only one of the two triangles
  EXPECT_FALSE(live.recolor(colors));
  colors.assign(162, 8);
  EXPECT_FALSE(live.recolor(colors));
  colors.assign(162, 7);  // branches
  EXPECT_FALSE(live.recolor(colors));
  EXPECT_EQ(look_at(live.mesh()), before);
  colors.assign(162, 0);
  EXPECT_TRUE(live.recolor(colors));
  EXPECT_EQ(live.strips(), 162U);
}

TEST(LiveTwins, ADeferredBufferBeginsWithTheFirstUpdate) {
  LiveMesh live(sample::torus(9, 9), {.history = 1000, .deferred = true});
  ASSERT_TRUE(live.flip(live.mesh().spoke(3)));
  EXPECT_EQ(live.bytes().size(), 0U);
  EXPECT_EQ(live.changed().size(), 0U);
  const Upload all = live.update();
  EXPECT_TRUE(all.outgrown);
  EXPECT_EQ(triangles_of_strips(live.indices()), triangles_of(live.mesh()));
  EXPECT_EQ(live.undoable(), 0U);
  ASSERT_TRUE(live.flip(live.mesh().spoke(3)));
  EXPECT_NE(live.changed().size(), 0U);
  live.update();
  EXPECT_EQ(live.undoable(), 1U);
  live.begin_buffer({.form = StripForm::list, .width = IndexWidth::bits16}, {}, 1000);
  EXPECT_EQ(live.undoable(), 0U);
  EXPECT_EQ(live.bytes().size(), 0U);
  EXPECT_FALSE(live.undo());  // begins the frame
  EXPECT_EQ(live.indices16().size(), 3 * 162U);
  EXPECT_TRUE(live.update().outgrown);
}

TEST(LiveTwins, FramesHaveNumbersThatRemainWhenOldOnesAreDropped) {
  LiveMesh live(sample::torus(9, 9), {.history = 30});
  EXPECT_EQ(live.frame(), 0U);
  for (std::size_t n = 1; n <= 20; ++n) {
    ASSERT_TRUE(live.flip(random_halfedge_that_flips(live.mesh())));
    EXPECT_EQ(live.frame(), n - 1);
    live.update();
    live.update();  // without a change
    EXPECT_EQ(live.frame(), n);
  }
  const std::size_t undoable = live.undoable();
  ASSERT_GT(undoable, 1U);
  ASSERT_LT(undoable, 15U);
  ASSERT_TRUE(live.undo() && live.undo());
  EXPECT_EQ(live.frame(), 18U);
  ASSERT_TRUE(live.redo());
  EXPECT_EQ(live.frame(), 19U);
  ASSERT_TRUE(live.flip(random_halfedge_that_flips(live.mesh())));
  live.update();
  EXPECT_EQ(live.frame(), 20U);
  while (live.undo()) continue;
  EXPECT_EQ(live.frame() + live.redoable(), 20U);
  LiveMesh without(sample::torus(9, 9));
  ASSERT_TRUE(without.flip(random_halfedge_that_flips(without.mesh())));
  without.update();
  EXPECT_EQ(without.frame(), 0U);
}

}  // namespace
}  // namespace restrip
