// The generator's shards.
#include "common/digest.hpp"
#include "tables/certificate_text.hpp"
#include "tables/shard.hpp"
#include "target.hpp"

namespace restrip::fuzz {
namespace {

using namespace generator;

const std::string id = "1.2.3 abc";

/// With a matching digest, so that alterations reach the reader.
std::string sealed(std::string_view text) {
  const std::string above(text.substr(0, text.rfind("end ")));
  return above + "end " + sha256(above) + "\n";
}

}  // namespace

std::vector<Target> shard_targets() {
  const std::vector<Section> all = solve_all(patches_of(tabled_families(), 3), 1, Watched::no);
  const auto read = [](std::string_view bytes) {
    const Merged merged = merge_shards({{"f", sealed(bytes)}}, id, "folder");
    for (const Section& section : merged.sections)
      promise(!section.rows.empty(), "every section of one shard of one has rows");
    return true;
  };
  return {{"shard", {shard_text({1, 1}, 3, id, all, section_texts(all, 1))}, refusing<std::runtime_error>(read), 500}};
}

}  // namespace restrip::fuzz
