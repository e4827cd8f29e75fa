// A certificate with one altered byte is rejected, and the message names the line. The sums in its last line detect the
// byte however plausible it looks. With updated sums, grammar, reasons or search detect it, unless the certificate is
// still correct.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <random>

#include "../support/refusal_of.hpp"
#include "certificate/certificate.hpp"
#include "corpus.hpp"
#include "model/input.hpp"
#include "verdict.hpp"

namespace restrip::verify::test {
namespace {

constexpr unsigned seed = 7;

struct Sample {
  Family family;
  std::string text;
};

std::vector<Sample> certificates(const std::string& folder, unsigned max_k) {
  const auto text_of = [&](const std::string& name) { return read_file(folder + "/certificates/" + name + ".cert"); };
  std::vector<Sample> samples;
  for (const Family& family : tabled_families(max_k)) samples.push_back({family, text_of(family.name)});
  return samples;
}

std::ptrdiff_t line_of_byte(const std::string& text, std::size_t place) {
  return std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\n') + 1;
}

std::string altered(std::string text, std::size_t place, unsigned byte) {
  text[place] = static_cast<char>(byte);
  return text;
}

unsigned byte_at(const std::string& text, std::size_t place) { return static_cast<unsigned char>(text[place]); }

/// The parser's reason to reject the text; empty if it accepts it.
std::string rejection(const Sample& sample, const std::string& text) {
  return refusal_of<InputError>([&] { parse_certificate("file", text, sample.family); });
}

class AlteredBytes : public testing::Test {
 protected:
  void expect_named(const Sample& sample, std::size_t place, unsigned byte) {
    if (byte == byte_at(sample.text, place)) return;
    ++tried_;
    const std::string said = rejection(sample, altered(sample.text, place, byte));
    const std::string named = fmt::format("file:{}: ", line_of_byte(sample.text, place));
    if (!said.starts_with(named) && ++failed_ < 5)
      ADD_FAILURE() << sample.family.name << ", byte " << place << " made " << byte << ": expected " << named
                    << ", found " << said;
  }
  void TearDown() override {
    std::cout << tried_ << " alterations\n";
    EXPECT_GT(tried_, 0);
    EXPECT_EQ(failed_, 0);
  }

  int tried_ = 0;
  int failed_ = 0;
  std::mt19937 random_{seed};
};

TEST_F(AlteredBytes, EveryOneOfTheSmallTables) {
  for (const Sample& sample : certificates(small_tables().string(), corpus_max_k))
    for (std::size_t place = 0; place < sample.text.size(); ++place)
      for (const unsigned byte :
           {unsigned{'\n'}, unsigned{' '}, byte_at(sample.text, place) ^ 1U, static_cast<unsigned>(random_() % 256)})
        expect_named(sample, place, byte);
}

/// Whether, by the naive search, every recolouring that differs is as good as the best one.
bool equally_right(const std::string& original, const std::string& text, const Sample& sample) {
  const Certificate before = parse_certificate("original", original, sample.family);
  const Certificate after = parse_certificate("altered", text, sample.family);
  const std::vector<NaiveFamily> families = naive_families(corpus_max_k);
  const auto family = std::find_if(families.begin(), families.end(),
                                   [&](const NaiveFamily& naive) { return naive.name == sample.family.name; });
  for (std::size_t s = 0; s < before.sections.size(); ++s) {
    std::map<NaiveKey, NaiveColors> changed;
    for (std::size_t r = 0; r < before.sections[s].rows.size(); ++r) {
      const Row& row = after.sections[s].rows.at(r);
      if (row.key != before.sections[s].rows[r].key) return false;
      if (row.after != before.sections[s].rows[r].after)
        changed[{static_cast<int>(row.key.ports), static_cast<int>(row.key.joined.bits)}] = {
            static_cast<int>(row.after.inner), static_cast<int>(row.after.ports)};
    }
    bool right = true;
    for_each_valid(family->sections[s], [&](const NaiveOperation& operation, NaiveColors colors) {
      const auto row = changed.find(operation.key(colors));
      if (row == changed.end()) return;
      const std::vector<NaiveCandidate> sound = operation.sound(colors);
      const auto best = std::min_element(sound.begin(), sound.end(),
                                         [](const auto& one, const auto& other) { return one.cost < other.cost; });
      right = right && std::any_of(sound.begin(), sound.end(), [&](const NaiveCandidate& candidate) {
                return candidate.after == row->second && candidate.cost == best->cost;
              });
    });
    if (!right) return false;
  }
  return true;
}

// The last line may state any numbers: 2^63 divided by -1 once stopped the program.
TEST(StatedSums, MayBeAsFarApartAsNumbersGo) {
  const Sample sample = certificates(small_tables().string(), corpus_max_k).front();
  const std::size_t end = sample.text.rfind("end ");
  const std::string body = sample.text.substr(0, end);
  const ByteSums sums = sums_of(body);
  const std::string rows = sample.text.substr(end + 4, sample.text.find(' ', end + 4) - end - 4);
  for (const std::uint64_t plain : {sums.plain - 1, sums.plain + 1})
    EXPECT_NE(rejection(sample,
                        fmt::format("{}end {} {} {}\n", body, rows, plain, sums.weighted + (std::uint64_t{1} << 63U))),
              "");
}

TEST(AlteredBytesWithNewSums, AreWrongOrAsRight) {
  std::mt19937 random(seed);
  const std::string likely = "0123456789abcdef \n-";
  int rejected = 0;
  int as_right = 0;
  for (const Sample& sample : certificates(small_tables().string(), corpus_max_k)) {
    const std::size_t end = sample.text.rfind("end ");
    for (int i = 0; i < 2000; ++i) {
      const std::size_t place = random() % end;
      const auto byte = static_cast<unsigned char>(likely[random() % likely.size()]);
      if (byte == byte_at(sample.text, place)) continue;
      const std::string text = with_sums(altered(sample.text, place, byte));
      const Verdict verdict = verdict_of(text, sample.family);
      const std::ptrdiff_t line = line_of_byte(sample.text, place);
      if (verdict.exit_code == 0) {
        ++as_right;
        EXPECT_TRUE(equally_right(sample.text, text, sample)) << sample.family.name << ", line " << line;
        continue;
      }
      ++rejected;
      // A line that was cut in two, or whose key moved, may show only at the next one.
      EXPECT_TRUE(verdict.says(fmt::format(":{}: ", line)) || verdict.says(fmt::format(":{}: ", line + 1)) ||
                  verdict.says(fmt::format("in line {}\n", line)))
          << sample.family.name << ", line " << line << ": " << verdict.text;
    }
  }
  std::cout << rejected << " rejected, " << as_right << " as right as before\n";
  EXPECT_GT(rejected, as_right);
}

}  // namespace
}  // namespace restrip::verify::test
