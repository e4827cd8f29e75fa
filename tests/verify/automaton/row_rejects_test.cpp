// Claim: of the automaton of rows, too, the verifier notices what is wrong. Every single row of the certificate is
// altered in each of its words, the sums brought up to date; each alteration must fail a claim about classes, or be
// refused as not well formed. And what is no family of rows is refused with a sentence.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "altered.hpp"
#include "automaton/automaton_certificate.hpp"
#include "automaton/row.hpp"
#include "model/input.hpp"

namespace restrip::verify::test {
namespace {

const std::string& row_certificate() {
  static const std::string text = read_file(RESTRIP_ROW_TABLES_DIR "/certificates/row-automaton.cert");
  return text;
}

std::string verdict_of_rows(const std::string& text) { return verdict_of(text, AutomatonOf::rows); }

TEST(RowRejects, NothingInAGoodCertificate) {
  EXPECT_EQ(verdict_of_rows(row_certificate()), "");
  EXPECT_EQ(sealed_again(parts_of(row_certificate(), '\n')), row_certificate());
}

TEST(RowRejects, EveryAlteredWord) {
  const std::vector<std::string> good = parts_of(row_certificate(), '\n');
  std::size_t altered = 0;
  std::size_t equally_good = 0;
  for (std::size_t i = 3; i + 2 < good.size(); ++i) {
    const std::vector<std::string> words = words_of(good[i]);
    if (words[0] == "section" || words[0] == "claim") continue;
    for (std::size_t w = 1; w < words.size(); ++w) {
      std::vector<std::string> other = words;
      const bool number = words[w].find_first_not_of("-0123456789") == std::string::npos &&
                          words[w].find_first_of("0123456789") != std::string::npos;
      other[w] = number               ? std::to_string(std::stoi(words[w]) + 1)
                 : words[w] == "--"   ? "-e"
                 : words[w][0] == '-' ? "--"
                 : words[w] == "s"    ? "S"
                                      : words[w] + "d";
      std::vector<std::string> lines = good;
      lines[i] = joined(other);
      ++altered;
      const std::string verdict = verdict_of_rows(sealed_again(lines));
      if (verdict.empty()) {
        // A recolouring that costs the same.
        EXPECT_EQ(words[0], "from") << lines[i];
        ++equally_good;
      }
    }
    if (words[0] == "from" && (words[2] == "s" || words[2] == "S")) {
      std::vector<std::string> lines = good;
      lines[i] =
          words.size() == 6 ? fmt::format("{}", fmt::join(words.begin(), words.end() - 1, " ")) : good[i] + " given";
      ++altered;
      EXPECT_NE(verdict_of_rows(sealed_again(lines)), "") << lines[i];
    }
  }
  EXPECT_GT(altered, 500U);
  EXPECT_LT(equally_good, altered / 20) << altered;
}

TEST(RowRejects, OtherFilesAndSections) {
  EXPECT_THROW(parse_automaton("rows.cert", row_certificate()), InputError);
  const std::string fans = read_file(RESTRIP_TABLES_DIR "/certificates/automaton.cert");
  EXPECT_THROW(parse_automaton("fans.cert", fans, AutomatonOf::rows), InputError);
}

std::string refusal_of(const std::string& from, const std::string& to) {
  std::string text = read_file(RESTRIP_ROW_FAMILY);
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  try {
    row_operations_of(parse_descriptions("family.json", text).at(0), 6);
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(RowRejects, FamiliesOfOtherKinds) {
  EXPECT_EQ(refusal_of("remove-vertex", "other-name"), "");
  EXPECT_NE(refusal_of("\"all\"", "\"none\"").find("that may all be given up"), std::string::npos);
  EXPECT_NE(refusal_of("\"give_up\"", "\"constraint\": \"forest\", \"give_up\"").find("is not one of strips"),
            std::string::npos);
  EXPECT_NE(refusal_of("\"give_up\"", "\"cost\": [[{\"count\": \"strips\"}]], \"give_up\"").find("the default cost"),
            std::string::npos);
  EXPECT_NE(refusal_of("[\"u[0]\", \"u[i]\", \"u[i+1]\", \"i[1,k-1)\"]",
                       "[\"v\", \"u[i]\", \"u[i+1]\", \"i[0,k-1)\"], [\"v\", \"u[k-1]\", \"u[0]\"]")
                .find("its triangles are no row"),
            std::string::npos);
}

}  // namespace
}  // namespace restrip::verify::test
