// Every single-bit flip of every shipped recolouring is noticed, for every configuration that the row serves. Rows are
// judged one by one, so one bit of all rows is flipped at a time and every configuration has to complain. (A flip in a
// row's key leaves its old key without a row, which is noticed for every row in the corpus tests.)

#include <gtest/gtest.h>

#include <iostream>

#include "input.hpp"
#include "judgment.hpp"

namespace restrip::verify {
namespace {

Row flipped(Row row, unsigned bit, const Section& section) {
  const Mask edge = single(bit < section.recoloring_bits ? bit : bit - section.recoloring_bits);
  (bit < section.recoloring_bits ? row.after.inner : row.after.ports) ^= edge;
  return row;
}

std::uint64_t complaints(const Judgment& judgment) {
  std::uint64_t count = 0;
  for (const Failures& failures : judgment.failures) count += failures.count;
  return count;
}

TEST(BitFlips, AllAreNoticed) {
  std::uint64_t flips = 0;
  std::uint64_t survivors = 0;
  for (const Family& family : all_families()) {
    const std::string file = std::string(RESTRIP_TABLES_DIR) + "/certificates/" + family.name + ".cert";
    const Certificate certificate = parse_certificate(file, read_file(file), family);
    for (std::size_t i = 0; i < family.sections.size(); ++i) {
      const Section& section = family.sections[i];
      const SectionRows& good = certificate.sections[i];
      const bool ports_too = section.operations.front().gives_ports_up;
      const unsigned bits = section.recoloring_bits + (ports_too ? section.ports : 0);
      std::vector<SectionRows> bad(bits, good);
      for (unsigned bit = 0; bit < bits; ++bit)
        for (Row& row : bad[bit].rows) row = flipped(row, bit, section);
      flips += std::uint64_t{bits} * good.rows.size();
      for (const Operation& operation : section.operations) {
        std::vector<Judge> judges;
        for (const SectionRows& rows : bad) judges.emplace_back(section, rows, operation, file);
        for (Mask ports = 0; ports < mask_count(section.ports); ++ports) {
          const PortSlice slice = slice_of(operation, ports);
          for (Judge& judge : judges) judge.judge(slice);
        }
        for (const Judge& judge : judges) survivors += judge.judgment().valid - complaints(judge.judgment());
      }
    }
  }
  std::cout << flips << " flips\n";
  EXPECT_GT(flips, 0U);
  EXPECT_EQ(survivors, 0U);
}

}  // namespace
}  // namespace restrip::verify
