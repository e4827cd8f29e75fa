// A reader can follow the mesh and its colours from a trace, operation after operation: an independent reader here
// keeps sets of triangles and edges, without a mesh.
#include "restrip/output/trace.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "random_operation.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

using Numbers = std::vector<std::uint32_t>;

/// What a reader of traces knows: triangles, the smallest corner first; edges, the smaller vertex first.
struct Known {
  std::set<Numbers> triangles;
  std::set<Numbers> solid;
  friend bool operator==(const Known&, const Known&) = default;
};

Known known(const StripMesh& mesh) {
  Known all;
  for (const sample::Corners& c : sample::triangles_of(mesh)) all.triangles.emplace(c.begin(), c.end());
  for (const auto h : sample::dual_edges(mesh))
    if (mesh.solid(h)) all.solid.insert({std::min(mesh.from(h), mesh.to(h)), std::max(mesh.from(h), mesh.to(h))});
  return all;
}

void read_mesh(std::istream& trace, Known& reader) {
  std::string line;
  while (trace.peek() == 't' || trace.peek() == 's') {
    std::getline(trace, line);
    std::istringstream words(line);
    char sign = 0;
    words >> sign;
    Numbers numbers;
    for (std::uint32_t number = 0; words >> number;) numbers.push_back(number);
    EXPECT_TRUE((sign == 't' ? reader.triangles : reader.solid).insert(numbers).second) << line;
  }
}

/// Everything in the lists must change something.
void read_operation(const std::string& line, Known& reader) {
  std::istringstream words(line);
  std::string word;
  for (int skipped = 0; skipped < 5; ++skipped) words >> word;
  std::string sign;
  Numbers numbers;
  while (words >> word) {
    if (word == "-" || word == "+" || word == "d" || word == "s") {
      sign = word;
      continue;
    }
    numbers.push_back(static_cast<std::uint32_t>(std::stoul(word)));
    const bool edge = sign == "d" || sign == "s";
    if (numbers.size() < (edge ? 2U : 3U)) continue;
    auto& all = edge ? reader.solid : reader.triangles;
    if (sign == "-" || sign == "d") {
      EXPECT_EQ(all.erase(numbers), 1U) << line;
    } else {
      EXPECT_TRUE(all.insert(numbers).second) << line;
    }
    numbers.clear();
  }
  EXPECT_TRUE(numbers.empty()) << line;
}

TEST(Trace, LetsAReaderFollowTheMesh) {
  for (const Policy policy : {Policy::rules, Policy::local, Policy::quick}) {
    for (StripMesh mesh : {sample::torus(6, 7), sample::rectangle(6, 6)}) {
      std::vector<Triangle> changed;
      mesh.watch(&changed);
      Keeper keeper(mesh, policy, Cost::strips());
      Trace trace(mesh, Trace::Claim::valid);
      std::istringstream head(trace.text());
      std::string line;
      std::getline(head, line);
      EXPECT_EQ(line, "restrip-trace 1");
      std::getline(head, line);
      EXPECT_EQ(line, "claim valid");
      Known reader;
      read_mesh(head, reader);
      ASSERT_EQ(reader, known(mesh));
      std::mt19937 random(7);
      std::size_t done = 0;
      while (done < 150) {
        if (!random_operation(keeper, random, done % 60 < 30)) continue;
        ++done;
        trace.text().clear();
        trace.add(mesh, changed, {});
        changed.clear();
        ASSERT_EQ(trace.text().substr(0, 14), "other 0 0 0 0 ");
        ASSERT_EQ(trace.text().find('\n'), trace.text().size() - 1);
        read_operation(trace.text(), reader);
        ASSERT_EQ(reader, known(mesh));
      }
      trace.text().clear();
      trace.end();
      EXPECT_EQ(trace.text(), "end 150\n");
    }
  }
}

// docs/reference/file-formats.md shows this one.
TEST(Trace, IsWhatTheDocumentShows) {
  StripMesh mesh = StripMesh::build(std::vector<std::array<Vertex, 3>>{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}}, 5);
  std::vector<Triangle> changed;
  mesh.watch(&changed);
  mesh.set_solid(mesh.spoke(1, 2), true);
  Trace trace(mesh, Trace::Claim::best);
  changed.clear();
  mesh.set_solid(mesh.spoke(2, 3), true);
  trace.add(mesh, changed, {Traced::Kind::other, 0, 0, -1, -1});
  changed.clear();
  mesh.set_solid(mesh.spoke(2, 3), false);
  mesh.turn_edge(mesh.spoke(2, 3));
  mesh.set_solid(mesh.spoke(1, 4), true);
  trace.add(mesh, changed, {Traced::Kind::flip, 2, 3, 0, 0});
  trace.end();
  EXPECT_EQ(trace.text(),
            "restrip-trace 1\n"
            "claim best\n"
            "t 0 1 2\n"
            "t 1 3 2\n"
            "t 2 3 4\n"
            "s 1 2\n"
            "other 0 0 -1 -1 s 2 3\n"
            "flip 2 3 0 0 - 1 3 2 2 3 4 + 1 3 4 1 4 2 d 2 3 s 1 4\n"
            "end 2\n");
}

}  // namespace
}  // namespace restrip
