// Operation files: wrong ones are refused with the place of the fault, and symmetries respect the content of a file.
// tests/cross/own_operations_test.py has faults of triangles.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "../support/refusal_of.hpp"
#include "describe/description.hpp"
#include "solved.hpp"

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

std::string many(const std::string& text, unsigned times) {
  std::string all;
  for (unsigned i = 0; i < times; ++i) all += text;
  return all;
}

struct Fault {
  std::string from;
  std::string to;
  std::string said;
};

/// The good text is accepted, and refused with any fault inserted.
template <class Read>
void expect_refused(const std::string& good, const std::vector<Fault>& faults, const Read& read) {
  ASSERT_NO_THROW(read(good));
  for (const Fault& fault : faults) {
    std::string text = good;
    const std::size_t at = text.find(fault.from);
    ASSERT_NE(at, std::string::npos) << fault.from;
    text.replace(at, fault.from.size(), fault.to);
    const std::string said = refusal_of<std::runtime_error>([&] { read(text); });
    EXPECT_NE(said.find(fault.said), std::string::npos) << fault.to << ": " << said;
  }
}

TEST(OperationFiles, AreRefusedWithTheirPlace) {
  std::vector<Fault> faults{
      {"{\n  \"restrip", "\xef\xbb\xbf{\n  \"restrip",
       "b.json:1:1: expected no byte order mark before the file; save it as UTF-8"},
      {"\"restrip_operation\": 1", "\"restrip_operation\": 2",
       "b.json:2:24: restrip_operation: expected 1, the version of the format, found 2"},
      {"\"bisect-own\"", "\"Bisect\"", "b.json:3:11: name: expected lower-case"},
      {"\"bisect-own\"", "\"bi--sect\"", "b.json:3:11: name: expected lower-case"},
      {"\"bisect-own\",", "\"bisect\"", "b.json:4:14: not JSON"},
      {"\"strips\",", "\"strip\",", "b.json:4:17: constraint: expected \"matching\" or \"strips\", found \"strip\""},
      {"\"constraint\"", "\"constraints\"", "b.json:4:3: constraints: unknown member"},
      {"[[\"a\", \"b\", \"c\"], [\"b\", \"a\", \"d\"]]", "{\"triangles\": 2}",
       "b.json:5:13: before: expected a list of 1 to 16 triangles, found an object"},
      {"\"give_up\": \"none\"", "\"take\": \"all\"", "b.json:7:11: take: a dashed port stays dashed: whether it may"},
      {"\"give_up\": \"none\"", "\"name\": \"b\"",
       "b.json:7:3: expected each member once, \"name\" is in line 3 already"},
      {"\"none\"", "\"some\"", "b.json:7:14: give_up: expected \"none\""},
      {"\"none\"", "[0, 4]", "b.json:7:18: give_up[1]: expected one of the ports 0 to 3, found 4"},
      {"\"none\"", "[1, 1]", "b.json:7:18: give_up[1]: expected each port once, 1 is listed above"},
      {"[{\"count\": \"strips\"}]", "[]", "b.json:9:5: cost[0]: expected a list of 1 to 64 terms, found a list of 0"},
      {"\"strips\"}", "\"strips\", \"edges\": [0]}",
       "b.json:9:35: cost[0][0].edges: \"strips\" does not choose among edges"},
      {"\"isolated\"", "\"lonely\"", "b.json:10:16: cost[1][0].count: expected \"strips\", \"isolated\", "},
      {"\"weight\": 2", "\"weight\": 2000001", "b.json:10:38: cost[1][0].weight: expected a weight from -1000000"},
      {"\"weight\": 2", "\"weight\": 0.5", "b.json:10:38: cost[1][0].weight: expected a weight"},
      {"\"none\"", std::string(50000, '[') + std::string(50000, ']'),
       "b.json:7:21: expected lists and objects at most 8 deep"},
      {"\"give_up\"", "\"" + std::string(100000, 'g') + "\"",
       "b.json:7:3: expected names of members of at most 60 bytes"},
      {"\"none\"", "[0" + many(", 0", 64) + "]",
       "b.json:7:14: give_up: expected a list of at most 4 ports, found a list of 65"},
      {"\"bisect-own\"", "\"bisect\"",
       "b.json:3:11: name: \"bisect\" is an operation of restrip, tables/operations/bisect.json"},
      {"\"give_up\"", "\"at_most\": [{}" + many(", {}", 64) + "], \"give_up\"",
       "b.json:7:14: at_most: expected a list of at most 64 bounds, found a list of 65"},
      {"\"give_up\"", "\"at_most\": [{\"strips\": 17}], \"give_up\"",
       "b.json:7:26: at_most[0].strips: expected a number from -16 to 16"}};
  for (const unsigned code :
       {0x0aU, 0x0dU, 0U, 0x1bU, 0x7fU, 0x85U, 0xadU, 0x200bU, 0x2028U, 0x2029U, 0x202eU, 0x2066U, 0xfeffU, 0xfffeU})
    faults.push_back(
        {"\"constraint\"", fmt::format("\"about\": \"One.\\u{:04x}int two;\", \"constraint\"", code),
         fmt::format(
             "b.json:4:12: about: expected one line that can stand in a comment of any language, found U+{:04X};",
             code)});
  for (const std::string mark : {"\\\\", "*/", "/*", "?\?/"})
    faults.push_back({"\"constraint\"", fmt::format("\"about\": \"One. {}\", \"constraint\"", mark),
                      "b.json:4:12: about: expected one line that can stand in a comment of any language, found '"});
  expect_refused(bisect, faults, [](const std::string& text) { (void)parse_descriptions("b.json", text); });
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

TEST(FamiliesFile, IsRefusedIfItDiffers) {
  const std::vector<Fault> faults{
      {"{\"restrip", "\xef\xbb\xbf{\"restrip", "w.json:1:1: expected no byte order mark before the file"},
      {"\"position\": \"", "\"position\": \"\\n", "position: expected words of printable ASCII"},
      {"\"restrip_operation\": 1", "\"restrip_operation\": 2",
       "w.json:1:23: restrip_operation: expected 1, the version of the format, found 2"},
      {"\"name\"", "\"nome\"", "w.json:2:3: operations[0].nome: unknown member"},
      {"i < k", "j < k", "w.json:2:52: operations[0].where: \"1 <= k, j < k\": expected a number of the family"},
      {"i < k", "i", "expected a comparison"},
      {"i < k", "i > k", "expected a comparison"},
      {"2 i <= k", "2 i <= k k", "expected the end"},
      {"j[i,k)", "j[i k)", "operations[0].after[1][3]: \"j[i k)\": expected \",\""},
      {"j[i,k)", "j[i,k]", "expected \")\" and the end"},
      {"j[i,k)", "[i,k)", "expected a name"},
      {"\"listed\"", "\"cost\": [[{\"count\": \"solid\", \"edges\": [0]}]], \"listed\"",
       "cost[0][0].edges: a family has different ones at each position"},
      {"\"listed\"", "\"give_up\": [0], \"listed\"", "give_up: expected \"none\" or \"all\""},
      {"i < k", "i < k" + many(" + 9999 k", 100000), "expected at most 16 terms of a sum before this"},
      {"i < k", "i < k" + many(", i < k", 100000), "expected at most 16 comparisons before this"},
      {"j[i,k)", "j[i," + many("9999k+", 2000) + "k)", "after[1][3]: \"j[i,9999k+9999k"},
      {"[\"k\", \"i\"]", "[\"k\", \"" + std::string(21, 'i') + "\"]",
       "numbers[1]: expected 1 to 20 lower-case letters"},
      {"k {k} i {i}", "k {k} i {i} {i}", "position: expected braces only around k, i, each at most once"},
      {"\"listed\"", "\"section\": \"k {k} {i\", \"listed\"", "section: expected braces only around k, i"},
      {"\"listed\"", "\"at_most\": [{\"where\": \"m = 1\"}], \"listed\"",
       "at_most[0].where: \"m = 1\": expected a number"}};
  expect_refused(wheel, faults, [](const std::string& text) { (void)parse_descriptions("w.json", text); });
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
