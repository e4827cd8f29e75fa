// Claims: in the automaton of fewest strips, fewer strips come first in fans of any valence; and a dump of the
// automaton is accepted if and only if every number that a look-up can use, and every answer, agrees with the
// certificate. The dump is made here from the numbers of the shipped header.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "automaton/automaton_certificate.hpp"
#include "model/input.hpp"

namespace restrip::verify {
namespace {

constexpr unsigned max_k = 3;

/// The shipped program's dump of the shipped header.
std::string shipped_dump() {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(popen(RESTRIP_DUMP " --automaton --max-k 3", "r"),
                                                               pclose);
  std::string text;
  for (int c = std::fgetc(stream.get()); c != EOF; c = std::fgetc(stream.get())) text += static_cast<char>(c);
  return text;
}

struct Shipped {
  std::string dump = shipped_dump();
  AutomatonCertificate certificate;

  Shipped() {
    const std::string file = std::string(RESTRIP_TABLES_DIR) + "/certificates/automaton.cert";
    certificate = parse_automaton(file, read_file(file));
  }
  AutomatonDumpCheck check(std::string text) const {
    std::FILE* const stream = fmemopen(text.data(), text.size(), "r");
    AutomatonDumpCheck found = check_automaton_dump(stream, certificate, max_k);
    std::fclose(stream);
    return found;
  }
};

bool holds(const AutomatonDumpCheck& found) {
  return found.fault.empty() && found.wrong_numbers.count + found.wrong_answers.count == 0;
}

TEST(AutomatonDump, ShippedNumbersAreTheCertificates) {
  const Shipped shipped;
  const AutomatonDumpCheck found = shipped.check(shipped.dump);
  EXPECT_TRUE(holds(found)) << found.fault << found.wrong_numbers.first << found.wrong_answers.first;
  EXPECT_GT(found.numbers, 10000U);
  EXPECT_EQ(found.keys, 4U * 3 + 9U * 7 + 27U * 14);
}

// Alters every fifth number, and all other lines. Unused numbers may be anything; the format has 0 there, and 255 for a
// letter that is not allowed.
TEST(AutomatonDump, EveryOtherNumberIsNoticed) {
  const Shipped shipped;
  std::vector<std::string> lines;
  std::istringstream text(shipped.dump);
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  std::string above;
  std::size_t altered = 0;
  std::size_t spared = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& line = lines[i];
    if (i % 5 == 0 || line.find(' ') != std::string::npos) {
      std::string other = line;
      other.back() = other.back() == '1' ? '2' : '1';
      std::string all = above + other + '\n';
      for (std::size_t j = i + 1; j < lines.size(); ++j) all += lines[j] + '\n';
      ++altered;
      if (holds(shipped.check(all))) {
        ++spared;
        EXPECT_TRUE(line.back() == '0' || line == "ff") << "line " << i + 1;
      }
    }
    above += line + '\n';
  }
  EXPECT_GT(altered, 1500U);
  EXPECT_LT(spared, altered / 5);
}

TEST(AutomatonDump, FormIsChecked) {
  const Shipped shipped;
  for (const std::size_t length : {std::size_t{0}, shipped.dump.size() / 2, shipped.dump.size() - 1})
    EXPECT_NE(shipped.check(shipped.dump.substr(0, length) + ' ').fault, "") << length;
  EXPECT_NE(shipped.check(shipped.dump + "more\n").fault, "");
  EXPECT_NE(check_automaton_dump_of("false", shipped.certificate, max_k).fault, "");
  EXPECT_NE(check_automaton_dump_of("true", shipped.certificate, max_k).fault, "");
}

// A cost is strips and isolated triangles in one number. They can be separated, in the certificate and in sums of a few
// of its numbers: every cost differs from whole strips by a few isolated triangles only.
TEST(AutomatonCosts, IsolatedTrianglesNeverOutweighAStrip) {
  const std::string file = std::string(RESTRIP_TABLES_DIR) + "/certificates/automaton.cert";
  const AutomatonCertificate certificate = parse_automaton(file, read_file(file));
  std::size_t compared = 0;
  const auto expect_few = [&](int cost) {
    ++compared;
    const int rest = std::abs(cost) % strip_cost;
    EXPECT_LE(std::min(rest, strip_cost - rest), 3) << cost;
  };
  for (const AutomatonClass& c : certificate.classes) {
    for (const auto& cost : c.costs)
      if (cost) expect_few(*cost);
    for (const auto& step : c.steps)
      if (step) expect_few(step->cost);
  }
  EXPECT_GT(compared, 1000U);
}

}  // namespace
}  // namespace restrip::verify
