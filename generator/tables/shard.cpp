#include "tables/shard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>

#include "common/digest.hpp"
#include "common/reading.hpp"
#include "tables/certificate_text.hpp"

namespace restrip::generator {

namespace fs = std::filesystem;

namespace {

/// Words and numbers of one line; `good` stays true while all are as expected.
class Words {
 public:
  explicit Words(std::string_view line) : rest_(line) {}

  std::string_view next() {
    const std::size_t end = std::min(rest_.find(' '), rest_.size());
    const std::string_view word = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return word;
  }
  void expect(std::string_view word) { good = next() == word && good; }
  Mask number(int base, Mask end) {
    const std::string_view word = next();
    Mask value = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value, base);
    good = good && error == std::errc{} && stop == word.data() + word.size() && value < end;
    return value;
  }
  [[nodiscard]] bool at_end() const { return rest_.empty(); }

  bool good = true;

 private:
  std::string_view rest_;
};

/// A file line by line, with the place for error messages.
struct Reader {
  std::filesystem::path file;
  std::string remedy;
  std::string_view text;
  std::size_t at = 0;
  std::size_t line = 1;

  [[nodiscard]] std::string_view peek() const { return text.substr(at, text.find('\n', at) - at); }
  void skip() {
    at += peek().size() + 1;
    ++line;
  }
  [[noreturn]] void refuse(const std::string& wanted) const {
    throw std::runtime_error(
        fmt::format("{}:{}: '{}' where {} should be; {}", file.string(), line, peek(), wanted, remedy));
  }
  void expect(const std::string& wanted) {
    if (peek() != wanted) refuse("'" + wanted + "'");
    skip();
  }
  [[nodiscard]] bool starts(std::string_view word) const { return text.substr(at, word.size()) == word; }
};

/// Roughly proportional to the time of a section, as measured for k = 8 … 10: it grows fourfold with k.
std::uint64_t weight_of(const Patches& section) {
  const Description& family = *section.position.family;
  std::uint64_t unit = std::get<SidePattern>(family.after).chords.empty() ? 1 : 8;
  // The claims of such a section count the configurations of every position served.
  if (serves_every_position(family)) unit = 2 * section.serves.size();
  return unit << (2 * section.position.k);
}

constexpr unsigned shard_version = 1;
constexpr std::size_t digest_length = 64;

std::string head(const Shard& shard, unsigned max_k, const std::string& id) {
  return fmt::format("restrip-shard {}\ngenerator {}\nmax-k {}\nshard {} of {}\n", shard_version, id, max_k,
                     shard.index, shard.count);
}

std::string command(const Shard& shard, unsigned max_k, const fs::path& directory) {
  return fmt::format("restrip-generate tables --shard {}/{} --max-k {} --out {}", shard.index, shard.count, max_k,
                     directory.string());
}

void read_rules(Section& section, Reader& reader) {
  const Operation operation = operation_of_rows(section.position);
  const Side& after = operation.patch.after;
  const Mask inner_end = Mask{1} << after.edges.size();
  std::tuple<Mask, std::size_t, std::string_view> last{};
  for (; reader.starts("rule ") || reader.starts("copy "); reader.skip()) {
    Words words(reader.peek());
    const bool rule = words.next() == "rule";
    Row row;
    row.key.ports = words.number(16, after.all_ports() + 1);
    const std::string_view joined = words.next();
    const bool key_is_good = PortPairs::read(joined, after.ports(), row.key.joined);
    row.recoloring = words.number(16, inner_end);
    row.kept = words.number(16, after.all_ports() + 1);
    words.expect(rule ? "because" : "by");
    const std::tuple order{row.key.ports, joined.size(), joined};
    if (!words.good || !key_is_good || words.at_end() || (!section.rows.empty() && order <= last))
      reader.refuse("the row of a greater key");
    section.rows.push_back(row);
    last = order;
  }
  if (section.rows.empty()) reader.refuse("a row");
  std::sort(section.rows.begin(), section.rows.end(), [](const Row& x, const Row& y) { return x.key < y.key; });
  // The input of the flip's table.
  if (section.position.family->numbers.empty()) section.relevant = relevant_pairs(operation);
}

/// The shard and the largest valence of a file with a matching digest. Reads the lines before the sections.
std::pair<Shard, unsigned> read_head(Reader& reader, const std::string& id) {
  const std::string_view text = reader.text;
  const auto refuse = [&](const std::string& why) {
    throw std::runtime_error(fmt::format("{}: {}", reader.file.string(), why));
  };
  const std::string last = "end ";
  const std::size_t tail = last.size() + digest_length + 1;
  const std::size_t body = text.size() < tail ? 0 : text.size() - tail;
  if (body == 0 || text.substr(body) != last + sha256(std::string(text.substr(0, body))) + "\n")
    refuse("is truncated or altered (its last line does not match the rest); remove it and run its shard again");
  reader.expect(fmt::format("restrip-shard {}", shard_version));
  if (reader.peek() != "generator " + id)
    refuse("was written by another version of restrip-generate; run all shards again with one version");
  reader.skip();
  Words max_k_words(reader.peek());
  max_k_words.expect("max-k");
  const unsigned max_k = max_k_words.number(10, 14);
  if (!max_k_words.good || max_k < 3) reader.refuse("'max-k' and a number from 3 to 13");
  reader.skip();
  Words words(reader.peek());
  words.expect("shard");
  const unsigned index = words.number(10, 10000);
  words.expect("of");
  const Shard shard{index, words.number(10, 10000)};
  if (!text.starts_with(head(shard, max_k, id)) || index < 1 || index > shard.count) reader.refuse("'shard I of N'");
  reader.skip();
  return {shard, max_k};
}

}  // namespace

Shard shard_named(const std::string& text) {
  std::string blank = text;
  std::replace(blank.begin(), blank.end(), '/', ' ');
  Words words(blank);
  const Shard shard{words.number(10, 10000), words.number(10, 10000)};
  if (shard.index < 1 || shard.index > shard.count || fmt::format("{}/{}", shard.index, shard.count) != text)
    throw std::invalid_argument(
        fmt::format("--shard {}: write I/N with 1 <= I <= N <= 9999, as in --shard 3/16", text));
  return shard;
}

std::vector<std::size_t> share_of(const std::vector<Patches>& all, unsigned index, unsigned count) {
  std::vector<std::uint64_t> weights;
  weights.reserve(all.size());
  for (const Patches& section : all) weights.push_back(weight_of(section));
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t x, std::size_t y) { return weights[x] > weights[y]; });
  std::vector<std::uint64_t> load(count, 0);
  std::vector<std::size_t> share;
  for (const std::size_t i : order) {
    const auto least = std::min_element(load.begin(), load.end());
    *least += weights[i];
    if (least - load.begin() == static_cast<std::ptrdiff_t>(index) - 1) share.push_back(i);
  }
  std::sort(share.begin(), share.end());
  return share;
}

std::string generator_id(const std::string& version) {
  std::string rules;
  for (const Patches& patches : patches_of(tabled_families(), 4)) rules += section_text(solve(patches));
  return version + " " + sha256(rules);
}

std::string file_name(const Shard& shard) { return fmt::format("shard-{:04}-of-{:04}.txt", shard.index, shard.count); }

std::string shard_text(const Shard& shard, unsigned max_k, const std::string& id, const std::vector<Section>& share,
                       const std::vector<std::string>& texts) {
  std::string text = head(shard, max_k, id);
  std::string family;
  for (std::size_t i = 0; i < share.size(); ++i) {
    if (share[i].certificate != family) text += fmt::format("family {}\n", share[i].certificate);
    family = share[i].certificate;
    text += texts[i];
  }
  return text + "end " + sha256(text) + "\n";
}

Merged read_shards(const fs::path& directory, const std::string& id) {
  std::error_code error;
  std::vector<fs::path> paths;
  for (fs::directory_iterator entry(directory, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name.rfind("shard-", 0) == 0 && entry->path().extension() == ".txt") paths.push_back(entry->path());
  }
  if (error)
    throw std::runtime_error(fmt::format("{}: cannot be read ({}); name the directory that holds the shards",
                                         directory.string(), error.message()));
  if (paths.empty())
    throw std::runtime_error(
        fmt::format("{}: holds no shard; first run restrip-generate tables --shard 1/N --out {}, and so on to N/N",
                    directory.string(), directory.string()));
  std::sort(paths.begin(), paths.end());
  std::vector<files::NamedBytes> shards;
  shards.reserve(paths.size());
  for (const fs::path& path : paths) shards.push_back({path, files::read_whole(path)});
  return merge_shards(shards, id, directory);
}

Merged merge_shards(const std::vector<files::NamedBytes>& shards, const std::string& id, const fs::path& directory) {
  Merged merged;
  std::vector<Patches> patches;
  std::vector<fs::path> seen;
  for (const auto& [path, text] : shards) {
    Reader reader{path, "remove it and run its shard again", text};
    const auto [shard, max_k] = read_head(reader, id);
    reader.remedy = "remove it and run " + command(shard, max_k, directory);
    if (seen.empty()) {
      patches = patches_of(tabled_families(), max_k);
      merged = {max_k, {}, std::vector<std::string>(patches.size())};
      for (const Patches& unsolved : patches) merged.sections.push_back({{unsolved}, {}, {}, 1, {}, {}});
      seen.resize(shard.count);
    }
    if (max_k != merged.max_k || shard.count != seen.size())
      throw std::runtime_error(fmt::format(
          "{}: is shard {} of {} with --max-k {}, but {} is one of {} with --max-k {}; keep one set of "
          "shards in a directory",
          path.string(), shard.index, shard.count, max_k, shards[0].name.string(), seen.size(), merged.max_k));
    if (!seen[shard.index - 1].empty())
      throw std::runtime_error(fmt::format("{}: is shard {} of {}, and so is {}; remove one of them", path.string(),
                                           shard.index, shard.count, seen[shard.index - 1].string()));
    seen[shard.index - 1] = path;

    std::string family;
    for (const std::size_t i : share_of(patches, shard.index, shard.count)) {
      Section& section = merged.sections[i];
      if (section.certificate != family) reader.expect("family " + section.certificate);
      family = section.certificate;
      const std::size_t begin = reader.at;
      reader.expect("section " + position_text(section.position));
      while (reader.starts("claim ")) reader.skip();
      read_rules(section, reader);
      merged.texts[i] = text.substr(begin, reader.at - begin);
    }
    if (!reader.starts("end ")) reader.refuse("the end");
    reader.skip();
    if (reader.at != reader.text.size()) reader.refuse("the end of the file");
  }
  for (unsigned i = 1; i <= seen.size(); ++i)
    if (seen[i - 1].empty()) {
      const Shard missing{i, static_cast<unsigned>(seen.size())};
      throw std::runtime_error(fmt::format("{}: is missing; run {}", (directory / file_name(missing)).string(),
                                           command(missing, merged.max_k, directory)));
    }
  return merged;
}

}  // namespace restrip::generator
