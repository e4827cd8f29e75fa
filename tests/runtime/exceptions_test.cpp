// After an exception the colouring is valid: every allocation of an operation fails in turn, its first one, its second,
// its third, until it ends.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <new>
#include <random>
#include <vector>

#include "../support/failing_new.hpp"
#include "buffer_changes.hpp"
#include "check_buffer.hpp"
#include "locator_agrees.hpp"
#include "random_operation.hpp"
#include "restrip/live_mesh.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/operations/apply.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/tables/operations/refine_face.hpp"
#include "sample_meshes.hpp"
#include "whole_mesh.hpp"

namespace restrip {
namespace {

using Where = VertexSplit;

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
  EXPECT_GT(failed, 120U);
  EXPECT_GT(outgrown, 120U);
}

}  // namespace
}  // namespace restrip
