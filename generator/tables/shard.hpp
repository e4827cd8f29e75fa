// Shards: files with the sections that one machine has solved, and how they are combined (docs/how-to/cluster.md). The
// format:
//
//   shard    = "restrip-shard 1" NL
//              "generator" version digest NL        digest: SHA-256 of all sections up to k = 4
//              "max-k" n NL
//              "shard" I "of" N NL
//              ( "family" name NL section+ )*       sections as in certificates, word for word
//              "end" digest NL                      SHA-256 of everything before this line
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "common/output.hpp"
#include "solve/section.hpp"

namespace restrip::generator {

struct Shard {
  unsigned index = 1;  ///< 1 … count
  unsigned count = 1;  ///< 1 … 9999
};

/// The shard that "3/16" names. Throws std::invalid_argument.
[[nodiscard]] Shard shard_named(const std::string& text);

/// The indices in `all` of the sections that belong to shard `index` (1 … count) of `count`, ascending. Every section
/// is in exactly one shard. Sections are distributed by an estimate of their time, the longest first, each to the shard
/// with the least total. So shards take about the same time if there are clearly more long sections than shards.
[[nodiscard]] std::vector<std::size_t> share_of(const std::vector<Patches>& all, unsigned index, unsigned count);

/// What must be equal for shards to be combined: the version, and a digest of all rules up to k = 4, which
/// distinguishes generators with different preferences.
[[nodiscard]] std::string generator_id(const std::string& version);

/// shard-0003-of-0016.txt
[[nodiscard]] std::string file_name(const Shard& shard);

/// The file of a shard: its sections and their texts.
[[nodiscard]] std::string shard_text(const Shard& shard, unsigned max_k, const std::string& id,
                                     const std::vector<Section>& share, const std::vector<std::string>& texts);

/// The combined shards. The sections are solved as far as certificates and headers need.
struct Merged {
  unsigned max_k = 0;
  std::vector<Section> sections;
  std::vector<std::string> texts;
};

/// Reads every shard-*.txt in a directory. Throws std::runtime_error, naming the file and the remedy, if a shard is
/// missing, duplicated, truncated or altered, or does not match the others or this generator.
[[nodiscard]] Merged read_shards(const std::filesystem::path& directory, const std::string& id);

/// Combines at least one shard, given by the path and the content of its file. Throws as read_shards() does;
/// `directory` is used in the remedies.
[[nodiscard]] Merged merge_shards(const std::vector<files::NamedBytes>& shards, const std::string& id,
                                  const std::filesystem::path& directory);

}  // namespace restrip::generator
