// Operation files: wrong ones are refused with the place of the fault, and symmetries respect the content of a file.
// tests/cross/own_operations_test.py has faults of triangles and of families, and what is said about them.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "../support/alterations.hpp"
#include "../support/refusal_of.hpp"
#include "describe/description.hpp"
#include "solve/section.hpp"

namespace restrip::generator {
namespace {

const std::string bisect = R"({
  "restrip_operation": 1,
  "name": "bisect-own",
  "constraint": "strips",
  "before": [["a", "b", "c"], ["b", "a", "d"]],
  "after": [["b", "c", "m"], ["c", "a", "m"], ["a", "d", "m"], ["m", "d", "b"]],
  "give_up": "none",
  "cost": [
    [{"count": "strips"}],
    [{"count": "isolated", "weight": 2}, {"count": "given_up"}]
  ]
})";

// The corpus has what the verifier says; the generator refuses the same files, at the same places.
TEST(OperationFiles, AreRefusedAtThePlacesOfTheCorpus) {
  for (const corpus::Alteration& alteration : corpus::alterations("descriptions.txt")) {
    const std::string text = alteration.in(corpus::text_to_alter(alteration.of));
    const std::string said = refusal_of<std::runtime_error>([&] { (void)parse_descriptions("f", text); });
    const std::string place = alteration.says.substr(0, alteration.says.find(": "));
    // What the triangles become on a mesh is judged later, and at other places: tests/cross/own_operations_test.py.
    if (alteration.says.ends_with(" is on it before") || alteration.says.ends_with("numbers from 0 to 16")) continue;
    EXPECT_EQ(said.empty(), alteration.says.empty()) << text << said;
    EXPECT_NE(said.find(place), std::string::npos) << text << "expected: " << alteration.says << "\nfound: " << said;
  }
}

const std::string wheel = R"family({"restrip_operation": 1, "operations": [{
  "name": "wheel", "numbers": ["k", "i"], "where": "1 <= k, i < k", "listed": "2 i <= k", "position": "k {k} i {i}",
  "before": [["v", "u[j]", "u[j+1]", "j[0,k)"]],
  "after": [["v", "u[j]", "u[j+1]", "j[0,i)"], ["v", "u[j]", "u[j+1]", "j[i,k)"]]}]})family";

TEST(FamiliesFile, ListsItsPositions) {
  const std::vector<Description> families = parse_descriptions("w.json", wheel);
  ASSERT_EQ(families.size(), 1U);
  const Description& family = families[0];
  EXPECT_EQ(smallest_valence(family), 1U);
  EXPECT_FALSE(serves_every_position(family));
  EXPECT_EQ(positions(family, 4), (std::vector<Position>{{&family, 4, 0, 0}, {&family, 4, 1, 0}, {&family, 4, 2, 0}}));
  const Patch patch = make_patch({&family, 2, 1, 0});
  EXPECT_EQ(patch.before.edges, (std::vector<Edge>{{0, 1}}));
  EXPECT_EQ(patch.after.owner, (std::vector<unsigned>{0, 0, 1, 1}));
}

TEST(OperationFiles, WithoutASoundRecolouringAreRefused) {
  // Three solid ports cannot stay on one triangle.
  const std::string text = R"({"restrip_operation": 1, "name": "join", "constraint": "strips",
    "before": [["m", "a", "b"], ["m", "b", "c"], ["m", "c", "a"]], "after": [["a", "b", "c"]]})";
  const std::vector<Description> file = parse_descriptions("join.json", text);
  const std::vector<Patches> patches = patches_of(file, 8);
  const std::string said = refusal_of<std::runtime_error>([&] { (void)solve(patches.at(0)); });
  EXPECT_EQ(said.substr(0, 70), "join.json:1:1: operation join: the configuration 0 3 (inner edges and ");
}

TEST(OperationSymmetries, KeepWhatTheFileAsksFor) {
  const auto how_many = [](const std::string& from, const std::string& to) {
    std::string text = bisect;
    text.replace(text.find(from), from.size(), to);
    const std::vector<Description> file = parse_descriptions("b.json", text);
    return symmetries(operation_at(positions(file[0], 0)[0], make_patch(positions(file[0], 0)[0]))).maps.size();
  };
  // The quadrilateral with its diagonal: before and after share the half turn and two mirrors.
  EXPECT_EQ(how_many("none", "none"), 4U);
  EXPECT_EQ(how_many("none", "all"), 4U);
  EXPECT_EQ(how_many("\"none\"", "[0]"), 1U);
  EXPECT_EQ(how_many("\"none\"", "[0, 2]"), 2U);
  EXPECT_EQ(how_many("{\"count\": \"given_up\"}", R"({"count": "ends", "triangles": [0, 1]})"), 2U);
  EXPECT_EQ(how_many("{\"count\": \"given_up\"}", R"({"count": "solid", "edges": [0]})"), 2U);
}

}  // namespace
}  // namespace restrip::generator
