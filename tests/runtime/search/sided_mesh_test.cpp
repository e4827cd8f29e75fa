// A view by sides answers what the mesh answers, and a StripMesh seen through one is itself.
#include "restrip/search/sided_mesh.hpp"

#include <gtest/gtest.h>

#include <type_traits>

#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

static_assert(std::is_same_v<decltype(by_sides(std::declval<StripMesh&>())), StripMesh&>);
static_assert(SidedMesh<SideView<StripMesh>> && NumberedMesh<SideView<StripMesh>>);

TEST(SideView, AnswersWhatTheMeshAnswers) {
  for (StripMesh& mesh : sample::meshes()) {
    stripify(mesh, Effort::fast, Cost::strips());
    const SideView<const StripMesh> view(mesh);
    EXPECT_EQ(view.triangle_count(), mesh.triangle_count());
    for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
      ASSERT_EQ(view.alive(t), mesh.alive(t));
      ASSERT_EQ(view.solid_sides(t), mesh.solid_sides(t));
      ASSERT_EQ(view.solid_degree(t), mesh.solid_degree(t));
      for (unsigned s = 0; s < 4; ++s) {
        const StripMesh::Halfedge h = StripMesh::halfedge(t, s);
        const auto one = view.strip_step(h);
        const auto other = mesh.strip_step(h);
        ASSERT_EQ(one.continues, other.continues);
        if (one.continues) {
          ASSERT_EQ(one.in, other.in);
        }
        if (s == 3) continue;
        ASSERT_EQ(view.opposite(h), mesh.opposite(h));
        ASSERT_EQ(view.opposite(view.opposite(h)), h);
        ASSERT_EQ(view.solid(h), mesh.solid(h));
        ASSERT_EQ(view.solid(view.opposite(h)), mesh.solid(h));
        ASSERT_EQ(view.other_solid_sides(h), mesh.other_solid_sides(h));
        ASSERT_EQ(view.from(h), mesh.from(h));
        ASSERT_EQ(view.from(view.opposite(h)), mesh.to(h));
        ASSERT_EQ(view.named(view.own(h)), h);
      }
    }
  }
}

TEST(SideView, ColoursGoThrough) {
  StripMesh mesh = sample::torus(6, 5);
  stripify(mesh, Effort::fast, Cost::strips());
  const std::vector<std::uint8_t> colors = sample::colors_of(mesh);
  StripMesh other = sample::torus(6, 5);
  SideView view(other);
  view.set_colors(colors);
  EXPECT_EQ(sample::colors_of(other), colors);
  view.clear_colors();
  EXPECT_EQ(count_strips(other), other.triangle_count());
}

}  // namespace
}  // namespace restrip
