// A LiveMesh next to another mesh, by vertex numbers, under every policy: each operation is granted exactly if the
// other mesh, a bare list of triangles, can do it; then both have the same triangles, and so has a device that is given
// only the ranges of each update. Undo takes back what the list had before.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <random>
#include <set>
#include <vector>

#include "check_buffer.hpp"
#include "restrip/live_mesh.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/keeper.hpp"
#include "sample_meshes.hpp"
#include "triangle_list.hpp"

namespace restrip {
namespace {

/// What a replaced list is, if all its vertices are manifold and no closed fan has two triangles.
std::optional<bare::List> replaced(const bare::List& list, const std::vector<bare::Corners>& out,
                                   const bare::List& in) {
  bare::List after;
  std::vector<bare::Corners> gone;
  for (const bare::Corners& c : out) gone.push_back(bare::sorted({c})[0]);
  for (const bare::Corners& c : list)
    if (std::find(gone.begin(), gone.end(), bare::sorted({c})[0]) == gone.end()) after.push_back(c);
  after.insert(after.end(), in.begin(), in.end());
  const bare::Shape shape = bare::shape_of(after);
  if (shape.degenerate || !shape.non_manifold.empty()) return {};
  for (const Vertex v : shape.vertices)
    if (const auto link = bare::link_of(after, v); !link || (link->closed && link->triangles() < 3)) return {};
  return after;
}

class Mirror {
 public:
  Mirror(const StripMesh& start, Policy policy, const Cost& cost, unsigned seed)
      : list_(sample::triangles_of(start)),
        live_(start, {.policy = policy, .cost = cost, .history = 100'000}),
        random_(seed) {
    device_.assign(live_.indices().begin(), live_.indices().end());
  }

  void frame() {
    lists_.resize(undone_from_);
    const bare::List before = list_;
    for (auto n = 1 + random_() % 6; n > 0; --n) operate();
    upload();
    if (bare::sorted(before) != bare::sorted(list_)) lists_.push_back(before), ++undone_from_;
    compare();
  }
  /// Some frames are undone and done again.
  void back_and_forth() {
    const bare::List now = list_;
    std::size_t steps = 0;
    while (steps < 3 && undone_from_ > steps && live_.undo()) {
      ++steps;
      upload();
      ASSERT_EQ(bare::sorted(sample::triangles_of(live_.mesh())), bare::sorted(lists_[undone_from_ - steps]));
    }
    for (; steps > 0; --steps) ASSERT_TRUE(live_.redo());
    upload();
    ASSERT_EQ(bare::sorted(sample::triangles_of(live_.mesh())), bare::sorted(now));
  }
  std::array<std::size_t, 8> granted{};  ///< by kind: collapse, flip, split, replace; then refused ones

 private:
  void operate() {
    const bare::Shape shape = bare::shape_of(list_);
    const bare::Corners c = list_[random_() % list_.size()];
    const auto [v, w, x] = c;
    const auto kind = list_.size() < 30 ? 2U : list_.size() > 120 ? 0U : random_() % 4;
    std::optional<bare::List> wanted;
    Checked done;
    if (kind == 0) {
      wanted = bare::collapse(list_, shape, v, w);
      done = live_.collapse(v, w);
    } else if (kind == 1) {
      wanted = bare::flip(list_, shape, v, w);
      done = live_.flip(v, w);
    } else if (kind == 2) {
      const auto link = bare::link_of(list_, v);
      const Vertex other = link ? link->around[random_() % link->around.size()] : x;
      const Vertex name = fresh();
      const auto spokes = random_() % 6;
      if (spokes == 0) {
        wanted = bare::split(list_, shape, v, w, {}, name);
        done = live_.split(v, w, none, name);
      } else if (spokes == 1) {
        wanted = bare::split(list_, shape, v, {}, w, name);
        done = live_.split(v, none, w, name);
      } else {
        wanted = bare::split(list_, shape, v, w, other, name);
        done = live_.split(v, w, other, name);
      }
    } else {
      const auto [out, in] = random_change(c);
      wanted = replaced(list_, out, in);
      std::vector<Triangle> handles;
      for (const bare::Corners& t : out) handles.push_back(StripMesh::triangle(live_.edge(t[0], t[1])));
      done = live_.replace(handles, in);
    }
    ASSERT_EQ(done.granted(), wanted.has_value()) << describe(done.refusal) << ", kind " << kind;
    ++granted[kind + (done ? 0 : 4)];
    if (wanted) list_ = *wanted;
  }
  /// A hole, a fill, a patch around a vertex with other triangles, a triangle at the rim, or what cannot be.
  std::pair<std::vector<bare::Corners>, bare::List> random_change(const bare::Corners& c) {
    const auto [v, w, x] = c;
    switch (random_() % 5) {
      case 0:
        return {{c}, {}};
      case 1: {  // a triangle beyond the boundary, or across an edge that has two
        return {{}, {{w, v, fresh()}}};
      }
      case 2: {  // all around v, then one vertex for v
        std::vector<bare::Corners> out;
        bare::List in;
        const Vertex name = fresh();
        for (const bare::Corners& t : list_)
          if (std::count(t.begin(), t.end(), v) != 0) {
            out.push_back(t);
            in.push_back(t);
            std::replace(in.back().begin(), in.back().end(), v, name);
          }
        return {out, in};
      }
      case 3:  // a hole of three sides, if there is one
        return {{}, {{w, v, x}}};
      default:
        return {{c}, {{v, w, fresh()}, {w, x, names_}, {x, v, names_}}};
    }
  }
  Vertex fresh() {
    names_ = 0;
    const bare::Shape shape = bare::shape_of(list_);
    while (shape.vertices.contains(names_)) ++names_;
    return names_ += static_cast<Vertex>(random_() % 3 == 0 && !shape.vertices.contains(names_ + 1));
  }
  void upload() {
    const Upload ranges = live_.update();
    if (ranges.outgrown) device_.assign(live_.room(), 0xFFFF'FFFF);
    device_.resize(std::max<std::size_t>(device_.size(), live_.room()), 0xFFFF'FFFF);
    for (const auto& [first, count] : ranges)
      std::copy_n(live_.indices().begin() + static_cast<std::ptrdiff_t>(first), count,
                  device_.begin() + static_cast<std::ptrdiff_t>(first));
    const auto drawn = std::span<const std::uint32_t>(device_).first(live_.indices().size());
    ASSERT_EQ(triangles_of_strips(drawn), triangles_of(live_.mesh()));
  }
  void compare() {
    ASSERT_EQ(bare::sorted(sample::triangles_of(live_.mesh())), bare::sorted(list_));
    const ColoringReport report = check_coloring(live_.mesh());
    ASSERT_TRUE(report.valid);
    ASSERT_EQ(live_.strips(), report.strips);
    ASSERT_EQ(live_.keeper().isolated(), report.isolated);
    ASSERT_EQ(live_.keeper().swaps(), count_swaps(live_.mesh()));
  }

  bare::List list_;
  LiveMesh live_;
  std::mt19937 random_;
  std::vector<std::uint32_t> device_;
  std::vector<bare::List> lists_;  // before each frame that can be undone
  std::size_t undone_from_ = 0;
  Vertex names_ = 0;
};

TEST(LiveMirror, DoesWhatTheOtherMeshDoes) {
  std::array<std::size_t, 8> granted{};
  unsigned seed = 0;
  for (const PolicyRow& row : policies)
    for (const Cost& cost : {Cost::strips(), Cost::indices()})
      for (const StripMesh& start : {sample::torus(6, 5), sample::rectangle(6, 5), sample::tube(5, 6)}) {
        Mirror mirror(start, row.policy, cost, ++seed);
        for (int n = 0; n < 40 && !testing::Test::HasFatalFailure(); ++n) {
          mirror.frame();
          if (n % 5 == 4) mirror.back_and_forth();
        }
        ASSERT_FALSE(testing::Test::HasFailure()) << row.name << ", seed " << seed;
        for (std::size_t i = 0; i < granted.size(); ++i) granted[i] += mirror.granted[i];
      }
  for (const std::size_t times : granted) EXPECT_GT(times, 50U);
}

}  // namespace
}  // namespace restrip
