// The header of an operation's table is the text that docs/operation-file.md says, but for its numbers: whatever else
// is put into it, at whatever place, is found.

#include "operation_header.hpp"

#include <gtest/gtest.h>

#include "input.hpp"

namespace restrip::verify::operations::test {
namespace {

const std::string tables = RESTRIP_TABLES_DIR;

struct Header {
  OperationFile operation;
  std::string text;

  explicit Header(const std::string& name, const std::string& header)
      : operation(parse_operation_file("f", read_file(tables + "/operations/" + name + ".json"))),
        text(read_file(tables + "/include/restrip/tables/operations/" + header + ".hpp")) {}
  std::string complaint(const std::string& altered) const {
    return check_operation_header("h", altered, operation).wrong.first;
  }
};

TEST(OperationHeader, ShippedOnesAreTables) {
  for (const std::string name : {"bisect", "merge", "merge-matching", "split-face"}) {
    std::string header = name;
    if (const std::size_t hyphen = header.find('-'); hyphen != std::string::npos) header[hyphen] = '_';
    const Header shipped(name, header);
    EXPECT_EQ(shipped.complaint(shipped.text), "") << name;
    EXPECT_GT(check_operation_header("h", shipped.text, shipped.operation).lines, 18U);
  }
}

TEST(OperationHeader, OfAnotherOperationIsNot) {
  const Header bisect("bisect", "bisect");
  EXPECT_EQ(bisect.complaint(Header("merge", "merge").text).substr(0, 30), "h:1: expected \"// A new vertex");
}

TEST(OperationHeader, AnyByteThatIsNoDigitOfATableIsMissed) {
  const Header bisect("bisect", "bisect");
  for (std::size_t at = 0; at < bisect.text.size(); ++at) {
    for (const char c : std::string_view("x\"\n\r\\(;#/ \0", 11)) {
      std::string altered = bisect.text;
      if (altered[at] != c) {
        altered[at] = c;
        EXPECT_NE(bisect.complaint(altered), "") << at << " becomes " << c;
      }
      altered = bisect.text;
      altered.insert(at, 1, c);
      EXPECT_NE(bisect.complaint(altered), "") << c << " at " << at;
    }
    if (const char c = bisect.text[at]; c < '0' || c > '9') {
      std::string altered = bisect.text;
      altered.erase(at, 1);
      EXPECT_NE(bisect.complaint(altered), "") << "without " << at;
    }
    EXPECT_NE(bisect.complaint(bisect.text.substr(0, at)), "") << "cut at " << at;
  }
}

TEST(OperationHeader, NumbersAreThoseOfTheTable) {
  const Header bisect("bisect", "bisect");
  const auto with = [&](const std::string& what, const std::string& other) {
    std::string altered = bisect.text;
    const std::size_t at = altered.find(what);
    EXPECT_NE(at, std::string::npos);
    return bisect.complaint(altered.replace(at, what.size(), other));
  };
  EXPECT_EQ(with(" 112,", " 113,"), "");
  const std::string expected = "h:16: expected numbers up to 65535, each with a comma, 32 in all, found \"    ";
  for (const std::string other : {" 0112,", " 65536,", " -1,", " 0x70,", " 112u,", " 1 + 1,", " (112),"})
    EXPECT_EQ(with(" 112,", other).substr(0, expected.size()), expected) << other;
  EXPECT_NE(with(" 112,", " 112, 1,"), "");
  EXPECT_NE(with(" 112,", ""), "");
}

}  // namespace
}  // namespace restrip::verify::operations::test
