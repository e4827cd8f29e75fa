#include "linked/linked_certificate.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace restrip::verify {

std::string Alternative::text() const { return fmt::format("alternative {:x} {:x}", ports, inner); }

List SectionLists::list(Mask ports) const {
  const auto from = std::find_if(rows.begin(), rows.end(), [&](const Alternative& row) { return row.ports == ports; });
  const auto to = std::find_if(from, rows.end(), [&](const Alternative& row) { return row.ports != ports; });
  return {from, to};
}

LinkedCertificate parse_linked_certificate(const std::string& file, std::string text, const LinkedFamily& family) {
  LinkedCertificate certificate;
  certificate.file = file;
  const std::array<const char*, 1> row_words = {"alternative"};
  parse_form(file, std::move(text), {"restrip-certificate 3", "operation " + family.name}, [&](LineReader& reader) {
    for (const Section& section : family.local.sections) {
      SectionLists& result = certificate.sections.emplace_back();
      parse_section_head(reader, section.position, linked_claim_words, result.claims, row_words);
      for (; reader.starts_with("alternative"); reader.next("an alternative, a section or \"end\"")) {
        reader.expect_words(3, "\"alternative\", 2 masks");
        const Alternative row{reader.mask(1, section.ports),
                              reader.mask(2, section.operations.front().after.inner_edges()), reader.line()};
        if (!result.rows.empty() && row.ports < result.rows.back().ports)
          reader.fail("expected lists in ascending order of ports");
        result.rows.push_back(row);
      }
      certificate.rows += result.rows.size();
    }
    return certificate.rows;
  });
  return certificate;
}

}  // namespace restrip::verify
