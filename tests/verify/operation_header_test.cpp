// Except for its numbers, the header of an operation's table is the text that docs/reference/operation-file.md defines:
// any insertion, anywhere, is detected.

#include "judge/operation_header.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "corpus.hpp"
#include "model/description.hpp"
#include "model/input.hpp"

namespace restrip::verify::test {
namespace {

struct Header {
  Description description;
  std::string text;

  /// A shipped one, or one of tests/corpus/altered: a family.
  explicit Header(const std::string& name)
      : description(parse_descriptions("f", is_shipped(name) ? read_file(shipped("/operations/" + name + ".json"))
                                                             : text_to_alter(name + ".json"))
                        .front()),
        text(is_shipped(name) ? read_file(shipped(header_of(name))) : text_to_alter(name + ".header")) {}

  std::string complaint(const std::string& altered) const {
    return check_operation_header("h", altered, description, largest_fan).wrong.first;
  }

 private:
  static bool is_shipped(const std::string& name) { return name != "fan-stays"; }
  static std::string shipped(const std::string& path) { return RESTRIP_TABLES_DIR + path; }
  static std::string header_of(std::string name) {
    std::replace(name.begin(), name.end(), '-', '_');
    return "/include/restrip/tables/operations/" + name + ".hpp";
  }
};

TEST(OperationHeader, GoodOnesAreTables) {
  std::vector<std::string> names{"fan-stays"};
  for (const auto& file : std::filesystem::directory_iterator(RESTRIP_TABLES_DIR "/operations"))
    names.push_back(file.path().stem().string());
  for (const std::string& name : names) {
    const Header good(name);
    EXPECT_EQ(good.complaint(good.text), "") << name;
    EXPECT_GT(check_operation_header("h", good.text, good.description, largest_fan).lines, 18U);
  }
}

TEST(OperationHeader, OneAlterationIsNamed) {
  for (const Alteration& alteration : alterations("headers.txt")) {
    const Header header(alteration.of);
    const std::string found = header.complaint(alteration.in(header.text));
    EXPECT_EQ(found.empty(), alteration.says.empty()) << alteration.by.value_or("") << found;
    EXPECT_NE(found.find(alteration.says), std::string::npos)
        << "expected: " << alteration.says << "\nfound: " << found;
  }
}

TEST(OperationHeader, OfAnotherOperationIsNot) {
  EXPECT_EQ(Header("bisect").complaint(Header("merge").text).substr(0, 30), "h:1: expected \"// A new vertex");
}

TEST(OperationHeader, AnyByteThatIsNotADigitOfATableIsMissed) {
  for (const std::string name : {"bisect", "fan-stays"}) {
    const Header header(name);
    for (std::size_t at = 0; at < header.text.size(); ++at) {
      for (const char c : std::string_view("x\"\n\r\\(;#/ \0", 11)) {
        std::string altered = header.text;
        if (altered[at] != c) {
          altered[at] = c;
          EXPECT_NE(header.complaint(altered), "") << at << " becomes " << c;
        }
        altered = header.text;
        altered.insert(at, 1, c);
        EXPECT_NE(header.complaint(altered), "") << c << " at " << at;
      }
      if (const char c = header.text[at]; c < '0' || c > '9') {
        std::string altered = header.text;
        altered.erase(at, 1);
        EXPECT_NE(header.complaint(altered), "") << "without " << at;
      }
      EXPECT_NE(header.complaint(header.text.substr(0, at)), "") << "cut at " << at;
    }
  }
}

// Every shipped header matches its description, and no entry may be another number.
TEST(OperationHeader, EntriesAreJudged) {
  const Header merge("merge");
  const Family family = families_of({merge.description}, largest_fan).front();
  ExpectedDump expected;
  expected.tables.push_back({&family.sections.front().operations.front(), Against::own_patch, nullptr});
  HeaderCheck header = check_operation_header("h", merge.text, merge.description, largest_fan);
  ASSERT_EQ(header.entries.size(), 256U);
  const auto wrong = [&] { return compare_header(header, expected).of(Against::own_patch).wrong.count; };
  EXPECT_EQ(wrong(), 0U);
  std::size_t refused = 0;
  for (std::uint32_t& entry : header.entries) {
    const std::uint32_t right = std::exchange(entry, entry == 255 ? 0 : 255);
    refused += wrong();
    entry = right;
  }
  EXPECT_EQ(refused, header.entries.size());
}

}  // namespace
}  // namespace restrip::verify::test
