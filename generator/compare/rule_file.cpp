#include "compare/rule_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <tuple>

#include "common/line_reader.hpp"
#include "files/reading.hpp"
#include "tables/certificate_text.hpp"

namespace restrip::generator {
namespace {

constexpr unsigned most_ports_of_a_key = 16;
constexpr Mask any_mask = ~Mask{0};

constexpr const char* remedy = "have it made again";

/// The rest of the line behind a word and a space.
std::string behind(std::string_view word, Reader& reader) {
  const std::string_view line = reader.peek();
  if (!reader.starts(std::string(word) + " ") || line.size() <= word.size() + 1)
    reader.refuse(fmt::format("'{} …'", word));
  std::string rest(line.substr(word.size() + 1));
  reader.skip();
  return rest;
}

/// A row of a certificate but for what shows that it is right; false where it is one of a list of linked rules.
bool read_row(Reader& reader, RuleLine& rule) {
  if (reader.starts("alternative ")) return false;
  Words words(reader.peek());
  const std::string_view kind = words.next();
  rule.line = reader.line;
  rule.key.ports = words.number(16, any_mask);
  words.good = PortPairs::read(words.next(), most_ports_of_a_key, rule.key.joined) && words.good;
  rule.recoloring = words.number(16, any_mask);
  rule.kept = words.number(16, any_mask);
  if (!words.good || (kind != "rule" && kind != "copy")) reader.refuse("the row of a rule");
  return true;
}

/// A decimal number, perhaps negative.
bool is_decimal(std::string_view word) {
  if (word.starts_with('-')) word.remove_prefix(1);
  return !word.empty() && std::all_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// An entry of a dump, whose costs are not read: the verifier judges what a table tells.
void read_entry(Reader& reader, RuleLine& rule) {
  Words words(reader.peek());
  rule.line = reader.line;
  rule.inner = words.number(16, any_mask);
  rule.key.ports = words.number(16, any_mask);
  const bool none = reader.peek().ends_with(" -");
  rule.none = none;
  if (none) {
    words.expect("-");
  } else {
    rule.recoloring = words.number(16, any_mask);
    rule.kept = words.number(16, any_mask);
    words.good = is_decimal(words.next()) && (words.at_end() || is_decimal(words.next())) && words.good;
  }
  if (!words.good || !words.at_end()) reader.refuse("an entry");
}

}  // namespace

bool is_before(const RuleLine& x, const RuleLine& y) { return std::tie(x.inner, x.key) < std::tie(y.inner, y.key); }

RuleFile read_rule_file(const std::string& file) {
  RuleFile read{file, files::read_whole(file), {}, {}};
  Reader reader{file, remedy, read.text};
  if (!read.text.ends_with('\n')) throw std::runtime_error(fmt::format("{}: has no last line; {}", file, remedy));
  const bool dump = reader.starts("restrip-table-dump ");
  if (!dump && !reader.starts("restrip-certificate ")) reader.refuse("the first line of a certificate or a table dump");
  reader.expect(dump ? "restrip-table-dump 4" : "restrip-certificate 3");
  if (!dump) read.operation = behind("operation", reader);
  const char* const begins = dump ? "table " : "section ";
  std::set<std::string> places;
  std::size_t rows = 0;
  do {
    RulePart& part = read.parts.emplace_back();
    part.place = behind(dump ? "table" : "section", reader);
    if (!places.insert(part.place).second)
      throw std::runtime_error(
          fmt::format("{}:{}: {} is there already; {}", file, reader.line - 1, part.place, remedy));
    part.line = reader.line;
    part.begin = reader.at;
    for (; !reader.starts(begins) && !reader.starts("end "); reader.skip()) {
      if (reader.at == read.text.size()) reader.refuse("the last line");
      rows += reader.starts("claim ") ? 0U : 1U;
    }
    part.end = reader.at;
  } while (!reader.starts("end "));
  const std::string last = fmt::format("end {}", rows);
  if (dump ? reader.peek() != last : sealed(read.text.substr(0, reader.at), rows) != read.text)
    reader.refuse(dump ? fmt::format("'{}'", last) : "the last line for these bytes");
  reader.skip();
  if (reader.at != read.text.size()) reader.refuse("the end of the file");
  return read;
}

PartRules rules_of(const RuleFile& file, const RulePart& part) {
  PartRules all;
  Reader reader{file.file, remedy, std::string_view(file.text).substr(0, part.end), part.begin, part.line};
  while (!file.is_dump() && reader.starts("claim ")) reader.skip();
  const bool lists = part.place.starts_with("linked-");  // of linked rules, in a dump
  for (; reader.at < part.end; reader.skip()) {
    RuleLine rule;
    const bool is_rule = file.is_dump() ? !lists : read_row(reader, rule);
    if (file.is_dump() && is_rule) read_entry(reader, rule);
    if (is_rule)
      all.rules.push_back(rule);
    else
      all.lists.emplace_back(reader.peek());
    if (!all.rules.empty() && !all.lists.empty()) reader.refuse("a line of the same kind as those before");
  }
  if (all.rules.empty() && all.lists.empty()) reader.refuse("a rule");
  std::sort(all.rules.begin(), all.rules.end(), is_before);
  const auto twice = std::adjacent_find(all.rules.begin(), all.rules.end(),
                                        [](const RuleLine& x, const RuleLine& y) { return !is_before(x, y); });
  if (twice != all.rules.end())
    throw std::runtime_error(fmt::format("{}:{}: line {} has a rule for the same; {}", file.file,
                                         std::max(twice->line, (twice + 1)->line),
                                         std::min(twice->line, (twice + 1)->line), remedy));
  return all;
}

}  // namespace restrip::generator
