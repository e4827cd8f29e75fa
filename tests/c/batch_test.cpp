// Batches of the C interface do what their operations do one by one on a StripMesh, in their order: the same triangles,
// colours, and changes reported, with any number of threads. A batch that cannot be done changes nothing and says where
// it failed. The count of strips and the live buffer of the mesh are right afterwards.
#include "restrip/operations/batch.hpp"

#include <optional>
#include <random>
#include <span>
#include <vector>

#include "handle.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/search/stripify.hpp"
#include "runtime/sample_meshes.hpp"

namespace restrip::c_test {
namespace {

using Halfedge = StripMesh::Halfedge;

/// Random collapses, or splits, that do not overlap.
template <class Request, class Draw>
std::vector<Request> apart(const StripMesh& mesh, Draw&& draw) {
  PatchClaims claims(mesh);
  std::vector<Request> chosen;
  for (std::size_t tries = 0; tries < mesh.triangle_count(); ++tries)
    if (const auto request = draw(); request && !claims.claim(*request, chosen.size())) chosen.push_back(*request);
  return chosen;
}

/// As it is after the same operations on `mine`.
void expect_same(restrip_mesh* mesh, const StripMesh& mine, std::span<const restrip_change> reported,
                 std::span<const Rewrite<Halfedge>> done) {
  ASSERT_EQ(corners_of(mesh), corners_of(mine));
  ASSERT_EQ(colors_of(mesh), colors_of(mine));
  EXPECT_EQ(strip_count(mesh), counted(mesh).strips);
  ASSERT_EQ(reported.size(), done.size());
  for (std::size_t i = 0; i < reported.size(); ++i) {
    EXPECT_EQ(reported[i].halfedge, done[i].halfedge.id);
    EXPECT_EQ(reported[i].valence, done[i].valence);
    EXPECT_EQ(reported[i].strips, done[i].strips);
    EXPECT_EQ(reported[i].isolated, done[i].isolated);
  }
  const auto ranges = updated(mesh);
  ASSERT_EQ(ranges.size(), 1U);  // the whole buffer
  const void* indices = nullptr;
  std::size_t size = 0;
  ASSERT_EQ(restrip_live_indices(mesh, &indices, &size), RESTRIP_OK);
  EXPECT_EQ(size, 3 * mine.triangle_count());
  EXPECT_EQ(ranges[0].count, size);
}

TEST(CBatch, IsItsOperationsOneByOne) {
  std::mt19937 random(5);
  std::size_t splits = 0;
  std::size_t collapses = 0;
  for (const std::int32_t policy : {RESTRIP_POLICY_BARE, RESTRIP_POLICY_LOCAL, RESTRIP_POLICY_QUICK})
    for (const std::uint32_t threads : {1U, 2U, 0U}) {
      StripMesh mine = sample::rectangle(40, 30);
      const Handle mesh = handle_of(mine);
      stripify(mine, Effort::fast, Cost::strips());
      ASSERT_EQ(restrip_mesh_stripify(mesh.get(), RESTRIP_EFFORT_FAST, &fewest_strips, 0, nullptr), RESTRIP_OK);
      ASSERT_EQ(restrip_mesh_keep(mesh.get(), policy, &fewest_strips), RESTRIP_OK);
      ASSERT_EQ(restrip_live_begin(mesh.get(), RESTRIP_LIST_U32), RESTRIP_OK);
      const auto any = [&] {
        return StripMesh::halfedge(static_cast<Triangle>(random() % mine.triangle_bound()),
                                   static_cast<unsigned>(random() % 3));
      };
      for (int round = 0; round < 4; ++round) {
        std::vector<Rewrite<Halfedge>> done;
        std::vector<restrip_change> reported;
        if (round % 2 == 0) {
          const auto chords = apart<Halfedge>(mine, [&]() -> std::optional<Halfedge> {
            const Halfedge h = any();
            return check_collapse(mine, h) == Refusal::granted ? std::optional(h) : std::nullopt;
          });
          std::vector<restrip_halfedge> given;
          for (const Halfedge h : chords) {
            given.push_back(h.id);
            done.push_back(collapse(mine, h));
          }
          reported.resize(given.size());
          ASSERT_EQ(
              restrip_mesh_collapse_batch(mesh.get(), given.data(), given.size(), threads, reported.data(), nullptr),
              RESTRIP_OK);
          collapses += given.size();
        } else {
          const auto requests = apart<SplitRequest>(mine, [&]() -> std::optional<SplitRequest> {
            const Halfedge g = any();
            if (!mine.alive(g)) return std::nullopt;
            const SplitRequest request{{mine.opposite(g), StripMesh::next(g)}, none};
            return check_split(mine, request.where) == Refusal::granted ? std::optional(request) : std::nullopt;
          });
          std::vector<restrip_split_request> given;
          for (const SplitRequest& request : requests) {
            given.push_back({request.where.left.id, request.where.right.id, RESTRIP_NONE});
            done.push_back(split(mine, request.where));
          }
          reported.resize(given.size());
          ASSERT_EQ(restrip_mesh_split_batch(mesh.get(), given.data(), given.size(), threads, reported.data(), nullptr),
                    RESTRIP_OK);
          splits += given.size();
        }
        expect_same(mesh.get(), mine, reported, done);
        if (HasFatalFailure()) return;
      }
      EXPECT_EQ(restrip_mesh_policy(mesh.get()), policy);
    }
  EXPECT_GT(splits, 500U);
  EXPECT_GT(collapses, 500U);
}

TEST(CBatch, OneThatCannotBeDoneChangesNothing) {
  const Handle mesh = handle_of(sample::rectangle(12, 9));
  restrip_mesh* const m = mesh.get();
  ASSERT_EQ(restrip_mesh_stripify(m, RESTRIP_EFFORT_FAST, &fewest_strips, 0, nullptr), RESTRIP_OK);
  const auto corners = corners_of(m);
  const auto colors = colors_of(m);
  const std::uint32_t row = 13;
  const std::uint32_t middle = 4 * row + 5;
  const restrip_halfedge inner = restrip_mesh_find(m, middle, middle + 1);
  const restrip_halfedge far = restrip_mesh_find(m, 2, 3);
  ASSERT_EQ(restrip_mesh_check_collapse(m, inner), RESTRIP_OK);
  ASSERT_EQ(restrip_mesh_check_collapse(m, far), RESTRIP_OK);
  std::size_t fault[2] = {77, 77};
  const auto expect_fault = [&](restrip_status status, restrip_status expected, std::size_t request,
                                std::size_t other) {
    EXPECT_EQ(status, expected);
    EXPECT_EQ(fault[0], request);
    EXPECT_EQ(fault[1], other);
    EXPECT_EQ(corners_of(m), corners);
    EXPECT_EQ(colors_of(m), colors);
  };
  const restrip_halfedge twice[] = {inner, far, restrip_mesh_opposite(m, inner)};
  expect_fault(restrip_mesh_collapse_batch(m, twice, 3, 1, nullptr, fault), RESTRIP_OVERLAP, 2, 0);
  const restrip_halfedge none_there[] = {inner, RESTRIP_NONE};
  expect_fault(restrip_mesh_collapse_batch(m, none_there, 2, 1, nullptr, fault), RESTRIP_NO_SUCH_EDGE, 1, 1);
  const restrip_halfedge other = restrip_mesh_find(m, middle, middle - 1);
  const restrip_halfedge corner = restrip_mesh_find(m, 2, 2 + row);
  const restrip_split_request named[] = {{inner, other, 400}, {restrip_mesh_find(m, 2, 3), corner, RESTRIP_NONE}};
  ASSERT_EQ(restrip_mesh_check_split(m, named[1].left, named[1].right, RESTRIP_NONE), RESTRIP_OK);
  expect_fault(restrip_mesh_split_batch(m, named, 2, 1, nullptr, fault), RESTRIP_MIXED_NAMES, 1, 0);
  const restrip_split_request in_use[] = {{inner, other, middle}};
  expect_fault(restrip_mesh_split_batch(m, in_use, 1, 1, nullptr, fault), RESTRIP_VERTEX_IN_USE, 0, 0);
  const restrip_split_request far_away[] = {{inner, other, RESTRIP_NONE - 1}};
  expect_fault(restrip_mesh_split_batch(m, far_away, 1, 1, nullptr, fault), RESTRIP_VERTEX_TOO_FAR, 0, 0);
  const restrip_split_request same[] = {{inner, inner, RESTRIP_NONE}};
  expect_fault(restrip_mesh_split_batch(m, same, 1, 1, nullptr, fault), RESTRIP_SAME_SPOKE, 0, 0);
  EXPECT_EQ(restrip_mesh_split_batch(m, same, 1, 1, nullptr, nullptr), RESTRIP_SAME_SPOKE);
  EXPECT_EQ(restrip_mesh_split_batch(m, nullptr, 0, 1, nullptr, fault), RESTRIP_OK);
  EXPECT_EQ(corners_of(m), corners);
}

}  // namespace
}  // namespace restrip::c_test
