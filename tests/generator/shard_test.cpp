// Shards: they share the work, read back as they were solved, and wrong ones are refused.
#include "tables/shard.hpp"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "../support/refusal_of.hpp"
#include "../tools/scratch_folder.hpp"
#include "common/digest.hpp"
#include "tables/certificate_text.hpp"

namespace restrip::generator {
namespace {

const std::string id = "1.2.3 abc";

/// A folder with both shards of the tables up to k = 3.
class Shards : public tools::ScratchFolder {
 protected:
  void SetUp() override {
    ScratchFolder::SetUp();
    const std::vector<Patches> patches = patches_of(tabled_families(), 3);
    all_ = solve_all(patches, 1, Watched::no);
    all_texts_ = section_texts(all_, 1);
    for (const unsigned index : {1U, 2U}) {
      std::vector<Section> share;
      std::vector<std::string> texts;
      for (const std::size_t i : share_of(patches, index, 2)) {
        share.push_back(all_[i]);
        texts.push_back(all_texts_[i]);
      }
      texts_.push_back(shard_text({index, 2}, 3, id, share, texts));
      put(file_name({index, 2}), texts_.back());
    }
  }

  void put_first(const std::string& text) const { put(file_name({1, 2}), text); }

  /// The message about the folder; empty if all is well.
  [[nodiscard]] std::string complaint(const std::string& own_id = id) const {
    return refusal_of<std::runtime_error>([&] { (void)read_shards(folder_, own_id); });
  }

  /// The message if the first shard has one piece of text replaced and is sealed again.
  [[nodiscard]] std::string complaint_after(const std::string& piece, const std::string& by) const {
    std::string text = texts_[0].substr(0, texts_[0].rfind("end "));
    const std::size_t at = text.find(piece);
    EXPECT_NE(at, std::string::npos) << piece;
    if (at == std::string::npos) return "";
    text.replace(at, piece.size(), by);
    put_first(text + "end " + sha256(text) + "\n");
    return complaint();
  }

  std::vector<Section> all_;
  std::vector<std::string> all_texts_;
  std::vector<std::string> texts_;  ///< of both shards
};

TEST(Shares, EverySectionIsInExactlyOne) {
  const std::vector<Patches> all = patches_of(tabled_families(), 8);
  for (const unsigned count : {1U, 3U, 16U, 1000U}) {
    std::multiset<std::size_t> seen;
    for (unsigned index = 1; index <= count; ++index)
      for (const std::size_t i : share_of(all, index, count)) seen.insert(i);
    ASSERT_EQ(seen.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(seen.count(i), 1U);
  }
}

TEST(Shares, LongSectionsAreSpread) {
  // Of the eleven longest splits, k = 12 and 13, no share of four may have many more than a quarter.
  const std::vector<Patches> all = patches_of(tabled_families(), 13);
  for (unsigned index = 1; index <= 4; ++index) {
    std::size_t long_ones = 0;
    for (const std::size_t i : share_of(all, index, 4))
      long_ones += all[i].certificate == "split" && all[i].position.k >= 12 ? 1U : 0U;
    EXPECT_LE(long_ones, 4U);
  }
}

TEST_F(Shards, AreReadBack) {
  const Merged merged = read_shards(folder_, id);
  EXPECT_EQ(merged.max_k, 3U);
  ASSERT_EQ(merged.sections.size(), all_.size());
  for (std::size_t i = 0; i < all_.size(); ++i) {
    const Section& then = all_[i];
    const Section& now = merged.sections[i];
    EXPECT_EQ(now.certificate, then.certificate);
    EXPECT_EQ(merged.texts[i], all_texts_[i]);
    ASSERT_EQ(now.rows.size(), then.rows.size());
    for (std::size_t r = 0; r < then.rows.size(); ++r) {
      EXPECT_EQ(now.rows[r].key, then.rows[r].key);
      EXPECT_EQ(now.rows[r].recoloring, then.rows[r].recoloring);
      EXPECT_EQ(now.rows[r].kept, then.rows[r].kept);
    }
  }
}

TEST_F(Shards, EveryAlteredByteAndEveryTruncationIsRefused) {
  const std::string& whole = texts_[0];
  for (std::size_t i = 0; i < whole.size(); i += 5 + i % 7) {
    std::string altered = whole;
    altered[i] = static_cast<char>(altered[i] ^ 1);
    put_first(altered);
    EXPECT_NE(complaint().find("shard-0001-of-0002.txt: is truncated or altered"), std::string::npos) << i;
    put_first(whole.substr(0, i));
    EXPECT_NE(complaint().find("shard-0001-of-0002.txt: is truncated or altered"), std::string::npos) << i;
  }
  put_first(whole);
  EXPECT_EQ(complaint(), "");
}

TEST_F(Shards, AnotherGeneratorIsRefused) {
  EXPECT_NE(complaint("1.2.4 abc").find("another version of restrip-generate"), std::string::npos);
  EXPECT_NE(complaint("1.2.3 abd").find("another version of restrip-generate"), std::string::npos);
  EXPECT_NE(generator_id("1"), generator_id("2"));
}

TEST_F(Shards, SealedNonsenseIsRefusedByLine) {
  const struct {
    const char* piece;
    const char* by;
    const char* words;
  } cases[] = {
      {"restrip-shard 1", "restrip-shard 2", ":1: 'restrip-shard 2' where"},
      {"max-k 3", "max-k 2", ":3: 'max-k 2' where"},
      {"max-k 3", "max-k 99", ":3: "},
      {"max-k 3", "max-k 4", ":6: "},
      {"shard 1 of 2", "shard 3 of 2", ":4: "},
      {"shard 1 of 2", "shard 1 of 2 3", ":4: "},
      {"shard 1 of 2", "shard 2 of 2", ":5: "},
      {"family split\n", "", "where 'family split' should be"},
      {"section k 3 a 1", "section k 3 a 2", "where 'section k 3 a 1' should be"},
      {"rule 0 0 ", "rule 8 0 ", "where the row of a greater key should be"},
      {"rule 0 0 ", "rule 0 ff ", "where the row of a greater key should be"},
      {"rule 0 0 ", "rule 0 0 40", "where the row of a greater key should be"},
      {"rule 0 0 ", "rule 7 0 ", "where the row of a greater key should be"},
      {" because ", " for ", "where the row of a greater key should be"},
      {"rule 0 0 ", "Rule 0 0 ", "where a row should be"},
  };
  for (const auto& [piece, by, words] : cases) {
    const std::string said = complaint_after(piece, by);
    EXPECT_NE(said.find("shard-000"), std::string::npos) << piece << " -> " << by << ": " << said;
    EXPECT_NE(said.find(words), std::string::npos) << piece << " -> " << by << ": " << said;
  }
  const std::string body = texts_[0].substr(0, texts_[0].rfind("end "));
  for (const std::string& more : {std::string("end 1\n"), std::string("section k 4 a 1\n"), std::string("\n")}) {
    put_first(body + more + "end " + sha256(body + more) + "\n");
    EXPECT_NE(complaint(), "") << more;
  }
}

}  // namespace
}  // namespace restrip::generator
