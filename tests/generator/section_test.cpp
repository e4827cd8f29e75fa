// Compares the generator's sections with independently counted figures (docs/explanation/theory.md section 6), and
// tests properties of every correct answer.
#include "solve/section.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "certify/certificate.hpp"
#include "common/digest.hpp"
#include "solved.hpp"
#include "tables/packing.hpp"

namespace restrip::generator {
namespace {

struct Reference {
  std::size_t valid = 0;
  std::size_t orbits = 0;
  std::size_t valid_orbits = 0;
  std::size_t costing = 0;
};
using SplitPosition = std::pair<unsigned, unsigned>;  // k, a

const std::map<SplitPosition, Reference> split_reference{{{3, 1}, {44, 40, 27, 0}},
                                                         {{4, 1}, {160, 144, 88, 0}},
                                                         {{4, 2}, {160, 84, 55, 2}},
                                                         {{5, 1}, {572, 544, 305, 0}},
                                                         {{5, 2}, {572, 544, 305, 6}},
                                                         {{6, 1}, {2040, 2112, 1050, 0}},
                                                         {{6, 2}, {2040, 2112, 1064, 14}},
                                                         {{6, 3}, {2040, 1104, 558, 19}},
                                                         {{7, 1}, {7268, 8320, 3703, 0}},
                                                         {{7, 2}, {7268, 8320, 3703, 40}},
                                                         {{7, 3}, {7268, 8320, 3703, 44}},
                                                         {{8, 1}, {25888, 33024, 13052, 0}},
                                                         {{8, 2}, {25888, 33024, 13102, 102}},
                                                         {{8, 3}, {25888, 33024, 13052, 118}},
                                                         {{8, 4}, {25888, 16704, 6670, 110}}};

// Valid configurations and those that cost a strip; published to k = 7.
const std::map<SplitPosition, std::pair<std::size_t, std::size_t>> collapse_reference{
    {{3, 1}, {278, 0}},    {{4, 1}, {998, 1}},     {{4, 2}, {1016, 4}},   {{5, 1}, {3562, 7}},
    {{5, 2}, {3640, 28}},  {{6, 1}, {12694, 23}},  {{6, 2}, {12988, 83}}, {{6, 3}, {13032, 104}},
    {{7, 1}, {45218, 67}}, {{7, 2}, {46280, 238}}, {{7, 3}, {46492, 321}}};

TEST(Sections, SplitCountsAreTheReference) {
  const auto sections = solved("split", 8, 2);
  ASSERT_EQ(sections.size(), split_reference.size());
  for (const Section& section : sections) {
    const Reference& r = split_reference.at({section.position.k, section.position.at});
    const Claims& c = section.claims.at(0);
    EXPECT_EQ(c.configurations, std::size_t{1} << (2 * section.position.k));
    EXPECT_EQ(c.valid, r.valid);
    EXPECT_EQ(c.orbits, r.orbits);
    EXPECT_EQ(c.valid_orbits, r.valid_orbits);
    EXPECT_EQ(c.costing, r.costing);
    EXPECT_LE(c.worst_strips, 1);
    EXPECT_LE(c.worst_isolated, 0);
  }
}

TEST(Sections, CollapseCountsAreTheReference) {
  std::size_t compared = 0;
  for (const Section& section : solved("collapse", 8, 2)) {
    for (std::size_t i = 0; i < section.serves.size(); ++i) {
      EXPECT_LE(section.claims[i].worst_strips, 1);
      EXPECT_LE(section.claims[i].worst_isolated, 0);
      const auto r = collapse_reference.find({section.position.k, section.serves[i].at});
      if (r == collapse_reference.end()) continue;
      EXPECT_EQ(section.claims[i].valid, r->second.first);
      EXPECT_EQ(section.claims[i].costing, r->second.second);
      ++compared;
    }
  }
  EXPECT_EQ(compared, collapse_reference.size());
}

TEST(Sections, CopiesAreImagesOfTheirRepresentatives) {
  for (const std::string& family : certificates_of(families())) {
    for (const Section& section : solved(family, 6, 1)) {
      std::size_t representatives = 0;
      for (const Row& row : section.rows) {
        if (row.witness < 0) {
          ++representatives;
          continue;
        }
        // The witness maps the ports to a smaller key whose recolouring is the image of this one.
        const PatchMap& s = section.symmetry.at(static_cast<std::size_t>(row.witness));
        const Mask ports = permute(row.key.ports, s.port);
        bool found = false;
        for (const Row& other : section.rows)
          found |= other.witness < 0 && other.key.ports == ports && other.key < row.key &&
                   other.recoloring == permute(row.recoloring, s.after) && other.kept == permute(row.kept, s.port);
        EXPECT_TRUE(found);
      }
      EXPECT_GT(representatives, 0U);
    }
  }
}

TEST(Packing, NoTwoKeysShareACell) {
  const std::vector<Certificate> splits = certify(solved("split", 8, 1), 1, false);
  const Packing packing = pack(splits, 8);
  for (const Section& section : splits.at(0).sections) {
    std::set<unsigned> taken;
    for (const Row& row : section.rows)
      for (const Mask joined : spellings(row.key)) {
        const unsigned cell = packing.start[std::size_t{1} << section.position.k | row.key.ports] + joined;
        EXPECT_LT(cell, packing.cells[section.position.k]);
        EXPECT_TRUE(taken.insert(cell).second);
      }
  }
}

TEST(Digest, OfTheStandardExample) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

}  // namespace
}  // namespace restrip::generator
