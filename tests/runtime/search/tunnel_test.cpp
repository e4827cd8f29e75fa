// Tunnelling joins strips and never harms a colouring.
#include "restrip/search/impl/tunnel.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "locator_agrees.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

TEST(Tunnel, EachJoinTakesOneStripAway) {
  for (StripMesh& mesh : sample::meshes()) {
    StripLocator locator(mesh);  // all isolated
    Tunnel tunnel;
    for (const auto& [states, on_failure] : {std::pair{20U, Tunnel::OnFailure::stay}, {50U, Tunnel::OnFailure::wander}})
      for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
        const std::size_t before = locator.strips();
        const bool joined = tunnel.join(mesh, locator, t, states, on_failure);
        ASSERT_EQ(locator.strips(), before - (joined ? 1 : 0));
        ASSERT_TRUE(check_coloring(mesh).valid);
        ASSERT_TRUE(agrees(locator, mesh));
      }
  }
}

TEST(Tunnel, LooksAtNoMoreStatesThanAllowed) {
  StripMesh mesh = sample::torus(30, 30);
  stripify(mesh, Effort::fast, Cost::strips());
  StripLocator locator(mesh);
  for (const std::uint32_t states : {0U, 1U, 2U, 7U, 100U}) {
    Tunnel tunnel;
    for (Triangle t = 0; t < mesh.triangle_bound(); ++t) tunnel.join(mesh, locator, t, states);
    EXPECT_LE(tunnel.counts().states, tunnel.counts().searches * states);
  }
}

}  // namespace
}  // namespace restrip
