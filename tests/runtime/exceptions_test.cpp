// After an exception the colouring is valid: if any call of a mesh throws, in every operation, over closed, open and
// long fans; and if any allocation fails under a keeper.
//
// Every operation is begun again and again from the same mesh, and fails at its first call, its second, its third,
// until it ends. The expected mesh is computed here only from the triangles.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <new>
#include <random>
#include <span>
#include <stdexcept>
#include <vector>

#include "../support/failing_new.hpp"
#include "buffer_changes.hpp"
#include "locator_agrees.hpp"
#include "measure/check_buffer.hpp"
#include "random_operation.hpp"
#include "restrip/live_mesh.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/operations/apply.hpp"
#include "restrip/operations/baked.hpp"
#include "restrip/operations/join.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/tables/operations/merge.hpp"
#include "restrip/tables/operations/refine_face.hpp"
#include "restrip/tables/operations/split_face.hpp"
#include "sample_meshes.hpp"
#include "whole_mesh.hpp"

namespace restrip {
namespace {

constexpr std::size_t never = std::numeric_limits<std::size_t>::max();
using Where = VertexSplit<StripMesh::Halfedge>;

struct Injected : std::runtime_error {
  Injected() : std::runtime_error("injected") {}
};

/// A mesh of a user's: the five functions and no more, each of which may throw.
class Throwing {
 public:
  using Halfedge = StripMesh::Halfedge;
  /// Throws in call number `at`, counted from 0. `late`: a set_solid that throws has done its work.
  Throwing(StripMesh& mesh, std::size_t at, bool late) : mesh_(mesh), left_(at), late_(late) {}

  Halfedge next(Halfedge h) const { return count(), StripMesh::next(h); }
  Halfedge opposite(Halfedge h) const { return count(), mesh_.opposite(h); }
  bool on_boundary(Halfedge h) const { return count(), StripMesh::on_boundary(h); }
  bool solid(Halfedge h) const { return count(), mesh_.solid(h); }
  void set_solid(Halfedge h, bool solid) {
    if (!late_) count();
    EXPECT_FALSE(StripMesh::on_boundary(h) || StripMesh::on_boundary(mesh_.opposite(h)));
    mesh_.set_solid(h, solid);
    if (late_) count();
  }
  Halfedge insert_vertex(const Where& where) { return count(), mesh_.insert_vertex(where); }
  Halfedge remove_vertex(Halfedge chord) { return count(), mesh_.remove_vertex(chord); }
  Halfedge turn_edge(Halfedge h) { return count(), mesh_.turn_edge(h); }

 private:
  void count() const {
    if (left_-- == 0) throw Injected();
  }
  StripMesh& mesh_;
  mutable std::size_t left_;
  bool late_;
};

using Operation = std::function<void(Throwing&)>;

/// Begins the operation with every call failing in turn; returns how many failed.
std::size_t fail_everywhere(const StripMesh& start, const Operation& operation, bool late) {
  StripMesh after = start;
  {
    Throwing mesh(after, never, false);
    operation(mesh);
  }
  for (std::size_t call = 0;; ++call) {
    StripMesh now = start;
    Throwing mesh(now, call, late);
    try {
      operation(mesh);
    } catch (const Injected&) {
      EXPECT_TRUE(check_coloring(now).valid) << "call " << call;
      const auto triangles = sample::triangles_of(now);
      EXPECT_TRUE(triangles == sample::triangles_of(start) || triangles == sample::triangles_of(after))
          << "call " << call;
      if (!testing::Test::HasFailure()) continue;
    }
    return call;
  }
}

/// The edge a -> m that tables::merge_rules collapses.
StripMesh::Halfedge merged(const StripMesh& mesh, StripMesh::Halfedge b_c) {
  return detail::read_sides(mesh, tables::merge_rules.triangles_before, b_c).between(3, 2);
}

/// Everything that may be done at a halfedge.
std::vector<Operation> operations_at(const StripMesh& mesh, StripMesh::Halfedge h, std::mt19937& random) {
  std::vector<Operation> all;
  const auto add = [&](auto&& bare, auto&& joining) {
    all.emplace_back(bare);
    all.emplace_back(joining);
  };
  if (check_collapse(mesh, h) == Refusal::granted)
    add([h](Throwing& m) { collapse(m, h); }, [h](Throwing& m) { collapse_and_join(m, h); });
  if (check_flip(mesh, h) == Refusal::granted)
    add([h](Throwing& m) { flip(m, h); }, [h](Throwing& m) { flip_and_join(m, h); });
  if (check_split_face(mesh, h) == Refusal::granted)
    all.emplace_back([h](Throwing& m) {
      apply(m, tables::split_face_rules, h, [&](const auto& patch) {
        const auto a_b = patch.between(0, 1);
        return m.next(m.opposite(m.insert_vertex({m.opposite(m.next(m.next(a_b))), a_b})));
      });
    });
  if (check_apply(mesh, tables::merge_rules, h) == Refusal::granted &&
      check_collapse(mesh, merged(mesh, h)) == Refusal::granted)
    all.emplace_back([h](Throwing& m) {
      apply(m, tables::merge_rules, h,
            [&](const auto& patch) { return m.next(m.opposite(m.remove_vertex(patch.between(3, 2)))); });
    });
  const std::vector<StripMesh::Halfedge> spokes = sample::spokes_around(mesh, mesh.from(h));
  const Where::Spokes kinds[] = {Where::Spokes::both, Where::Spokes::left_only, Where::Spokes::right_only};
  for (const Where::Spokes kind : kinds) {
    const Where where{h, spokes[random() % spokes.size()], kind};
    if (check_split(mesh, where) != Refusal::granted) continue;
    add([where](Throwing& m) { split(m, where); }, [where](Throwing& m) { split_and_join(m, where); });
  }
  return all;
}

TEST(Exceptions, OfEveryCallLeaveAValidColoring) {
  std::mt19937 random(1);
  std::size_t failed = 0;
  for (const StripMesh& start : sample::meshes()) {
    StripMesh mesh = start;
    for (int round = 0; round < 12; ++round) {
      sample::color_at_random(mesh, 0.4 + 0.2 * (round % 4), random);
      const auto t = static_cast<Triangle>(random() % mesh.triangle_bound());
      auto h = StripMesh::halfedge(t, static_cast<unsigned>(random() % 3));
      if (random() % 4 == 0) h = mesh.opposite(h);
      for (const Operation& operation : operations_at(mesh, h, random))
        failed += fail_everywhere(mesh, operation, round % 2 == 0);
      ASSERT_FALSE(HasFailure());
    }
  }
  EXPECT_GT(failed, 10'000U);
}

// Fans that use the general code, and fans of more than max_word_valence triangles, which use bit strings.
TEST(Exceptions, InLongFansLeaveAValidColoring) {
  std::mt19937 random(2);
  for (const StripMesh& start : {sample::double_cone(20), sample::open_double_cone(20), sample::double_cone(70),
                                 sample::open_double_cone(70), sample::open_double_cone(3)}) {
    StripMesh mesh = start;
    for (const double share : {0.6, 0.95}) {
      sample::color_at_random(mesh, share, random);
      const std::vector<StripMesh::Halfedge> spokes = sample::spokes_around(mesh, 0);
      const auto h = spokes[spokes.size() / 3];
      const auto all = operations_at(mesh, h, random);
      ASSERT_GE(all.size(), 3U);
      for (std::size_t i = 0; i < all.size(); i += 3) fail_everywhere(mesh, all[i], true);
      ASSERT_FALSE(HasFailure());
    }
  }
}

TEST(Exceptions, WhilePlayingBakedFlipsLeaveAValidColoring) {
  std::mt19937 random(3);
  for (const StripMesh& start : sample::meshes()) {
    for (int round = 0; round < 6; ++round) {
      StripMesh mesh = start;
      sample::color_at_random(mesh, 0.8, random);
      const auto h = StripMesh::halfedge(static_cast<Triangle>(random() % mesh.triangle_bound()), 0);
      const Where where{h, turn_ccw(mesh, h), Where::Spokes::both};
      if (check_split(mesh, where) != Refusal::granted) continue;
      StripMesh plain = mesh;
      const auto chord = split_baked(plain, where, {}).halfedge;
      StripMesh wanted = plain;
      sample::color_at_random(wanted, 0.9, random);
      const std::vector<StripMesh::Halfedge> flips = sample::recolored_edges(plain, wanted);
      fail_everywhere(
          mesh, [&](Throwing& m) { split_baked(m, where, flips); }, round % 2 == 0);
      fail_everywhere(
          wanted, [&](Throwing& m) { collapse_baked(m, chord, flips); }, round % 2 == 0);
      ASSERT_FALSE(HasFailure());
    }
  }
}

// A record of more flips than fit without allocation.
TEST(Exceptions, WhilePlayingManyFlipsLeaveAValidColoring) {
  std::mt19937 random(4);
  StripMesh mesh = sample::torus(20, 20);
  sample::color_at_random(mesh, 0.8, random);
  const Where where{StripMesh::halfedge(0, 0), turn_ccw(mesh, turn_ccw(mesh, StripMesh::halfedge(0, 0))),
                    Where::Spokes::both};
  StripMesh plain = mesh;
  split_baked(plain, where, {});
  StripMesh wanted = plain;
  sample::color_at_random(wanted, 0.9, random);
  const std::vector<StripMesh::Halfedge> flips = sample::recolored_edges(plain, wanted);
  ASSERT_GT(flips.size(), detail::flips_without_allocation);
  Throwing played(mesh, never, false);
  split_baked(played, where, flips);
  EXPECT_EQ(sample::colors_of(mesh), sample::colors_of(wanted));
}

// Every allocation of a keeper, its mesh and the list of changes fails in turn. The list names what has changed all the
// same.
TEST(Exceptions, OfAllocationsLeaveAKeeperThatWorks) {
  std::mt19937 random(5);
  std::size_t failed = 0;
  std::array<std::size_t, 4> begun{};
  std::vector<StripMesh> starts = sample::meshes();
  starts.push_back(sample::double_cone(70));
  for (const StripMesh& start : starts) {
    for (const Policy policy : {Policy::local, Policy::quick}) {
      for (int round = 0; round < 8; ++round) {
        StripMesh colored = start;
        sample::color_at_random(colored, 0.7, random);
        const auto h = StripMesh::halfedge(static_cast<Triangle>(random() % colored.triangle_bound()), 1);
        const Where where{h, turn_ccw(colored, h), Where::Spokes::both};
        const std::array<Refusal, 4> refusals{check_split(colored, where), check_collapse(colored, h),
                                              check_flip(colored, h),
                                              check_apply(colored, tables::refine_face_rules, h)};
        const auto kind = static_cast<std::size_t>(round % 4);
        if (refusals[kind] != Refusal::granted) continue;
        ++begun[kind];
        for (std::size_t allocation = 0;; ++allocation) {
          StripMesh mesh = colored;
          Keeper keeper(mesh, policy, Cost::strips());
          const auto operate = [&] {
            if (kind == 0) keeper.split(where);
            if (kind == 1) keeper.collapse(h);
            if (kind == 2) keeper.flip(h);
            if (kind == 3) keeper.apply(tables::refine_face_rules, h);
          };
          std::vector<Triangle> changed;
          if (round >= 4) mesh.watch(&changed);
          testing_support::fail_allocation(allocation + 1, testing_support::Shortage::for_good);
          bool threw = false;
          try {
            operate();
          } catch (const std::bad_alloc&) {
            threw = true;
          }
          testing_support::end_shortage();
          mesh.watch(nullptr);
          ASSERT_TRUE(round < 4 || names_all_changes(changed, colored, mesh)) << "allocation " << allocation;
          const ColoringReport report = check_coloring(mesh);
          ASSERT_TRUE(report.valid) << "allocation " << allocation;
          ASSERT_EQ(keeper.up_to_date(), !threw);
          if (threw) {
            ++failed;
            ASSERT_EQ(keeper.locator(), nullptr);
            // The mesh may be as it was or changed; the next operation is one that is possible there.
            if (sample::triangles_of(mesh) == sample::triangles_of(colored) && allocation % 2 == 0)
              operate();
            else
              keeper.rebuild();
          }
          ASSERT_TRUE(keeper.up_to_date());
          ASSERT_TRUE(check_coloring(mesh).valid);
          ASSERT_EQ(keeper.strips(), check_coloring(mesh).strips);
          if (keeper.locator() != nullptr) {
            ASSERT_TRUE(agrees(*keeper.locator(), mesh));
          }
          if (!threw) break;
        }
      }
    }
  }
  EXPECT_GT(failed, 200U);
  for (const std::size_t times : begun) EXPECT_GT(times, 5U);
}

// The buffer is right again after the next update, which returns everything that was not returned, to a device that is
// made again only when the update says so. Frames that can no longer be undone are not undone.
TEST(Exceptions, OfAllocationsLeaveALiveMeshThatIsDrawnRight) {
  enum class Call { update, undo, redo };
  std::size_t failed = 0;
  std::size_t outgrown = 0;
  for (const Call call : {Call::update, Call::undo, Call::redo})
    for (const bool grows : {false, true})
      for (const auto shortage : {testing_support::Shortage::once, testing_support::Shortage::for_good})
        for (std::size_t allocation = 0;; ++allocation) {
          std::mt19937 random(6);
          LiveMesh live(sample::torus(16, 16), {.history = 10'000, .format = {.width = IndexWidth::automatic}});
          std::vector<std::byte> drawn;
          const auto make_device = [&] { drawn.resize(live.room() * live.index_bytes()); };
          const auto upload = [&](const Upload& ranges) {
            if (ranges.outgrown) make_device();
            for (const auto& [first, count] : ranges) {
              const std::size_t width = live.index_bytes();
              ASSERT_LE((first + count) * width, drawn.size());
              std::copy_n(live.bytes().data() + first * width, count * width, drawn.data() + first * width);
            }
            outgrown += ranges.outgrown ? 1U : 0U;
          };
          const auto change = [&] {
            live.keeper().rebuild();  // so that its counts are right after an exception, too
            for (int n = 0; n < 10; ++n) random_operation(live.keeper(), random, n % 2 == 0);
          };
          const auto expect_drawn = [&](const char* when) {
            const auto triangles =
                live.index_bytes() == 4 ? triangles_of_strips(live.indices()) : triangles_of_strips(live.indices16());
            ASSERT_EQ(triangles, triangles_of(live.mesh())) << when << ", " << allocation;
            ASSERT_EQ(fault_of(live.mesh()), "") << when << ", " << allocation;
            ASSERT_TRUE(std::equal(live.bytes().begin(), live.bytes().end(), drawn.begin()))
                << when << ", " << allocation;
          };
          make_device();
          std::copy(live.bytes().begin(), live.bytes().end(), drawn.begin());
          for (int frame = 0; frame < 2; ++frame) {
            change();
            upload(live.update());
          }
          change();
          if (grows) {
            for (int n = 0; n < 300; ++n) live.split_face(random_halfedge(live.mesh(), random));
            const auto h = live.mesh().spoke(9);
            live.split({h, turn_ccw(live.mesh(), h)}, Vertex{70'000});
          }
          if (call != Call::update && random() % 2 == 0) upload(live.update());
          if (call == Call::redo) live.undo();
          const std::size_t undoable = live.undoable();
          bool threw = false;
          Upload ranges;
          testing_support::fail_allocation(allocation + 1, shortage);
          try {
            if (call == Call::update)
              ranges = live.update();
            else
              call == Call::undo ? live.undo() : live.redo();
          } catch (const std::bad_alloc&) {
            threw = true;
          }
          testing_support::end_shortage();
          if (!threw) upload(ranges);
          upload(live.update());
          expect_drawn("after the next update");
          ASSERT_LE(live.undoable(), undoable + 1);
          const auto shown = triangles_of(live.mesh());
          change();
          upload(live.update());
          expect_drawn("after more operations");
          ASSERT_TRUE(live.undo()) << "frames after the exception can be undone";
          upload(live.update());
          expect_drawn("after an undo");
          ASSERT_EQ(triangles_of(live.mesh()), shown);
          if (!threw) break;
          ++failed;
        }
  EXPECT_GT(failed, 200U);
  EXPECT_GT(outgrown, 200U);
}

}  // namespace
}  // namespace restrip
