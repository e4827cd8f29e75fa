// Prints a table dump as Coq files, one Tables_FAMILY.v for each family.
//
//   print_tables DIRECTORY < dump
//
// The dump is text: `restrip-table-dump 2`, then for each table its header and one line `before ports after` for each
// configuration, ascending by (before, ports), hexadecimal, `-` for no answer; at last `end N`, N the number of
// configuration lines. A flip's line is `inner ports inner ports` (or `inner ports -`), and its answer's mask
// is inner | ports << 1. Tables of linked rules, and those of positions that notation.md does not list, which nothing
// is proved of here, are read and left out.
//
// A table becomes the list of the nodes of a binary trie, equal subtrees once; Table.v says how they are read. At the
// end of a file stands the function from positions, lists of numbers such as [8; 3], to the family's tables.
// Anything unexpected ends the program with a message and exit code 1.
#include <array>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

[[noreturn]] void fail(const std::string& what) {
  std::cerr << "print_tables: " << what << '\n';
  std::exit(1);
}

// What a header says: the family, the position, and how many bits each mask has.
struct Header {
  std::string family;
  std::vector<unsigned> position;
  unsigned ports = 0;
  unsigned before = 0;
  unsigned after = 0;

  std::string joined_by(const std::string& separator) const {
    std::string text;
    for (const unsigned n : position) text += (text.empty() ? "" : separator) + std::to_string(n);
    return text;
  }
};

Header read_header(const std::string& line) {
  std::istringstream words(line);
  std::string table, family, word;
  words >> table >> family;
  Header header;
  header.family = family;
  for (char& c : header.family) c = c == '-' ? '_' : c;
  if (line == "table flip") {
    header.ports = 4;
    header.before = 1;
    header.after = 5;
    return header;
  }
  while (words >> word)
    if (word != "k" && word != "a" && word != "gap" && word != "gaps")
      header.position.push_back(static_cast<unsigned>(std::stoul(word)));
  if (table != "table" || header.position.empty()) fail("no header: " + line);
  const unsigned k = header.ports = header.position[0];
  if (k < 1 || k > 12) fail("valence out of range: " + line);
  const std::map<std::string, std::array<unsigned, 2>> bits = {
      {"split", {k, k + 3}},          {"collapse", {k + 3, k}},
      {"open-split", {k - 1, k + 2}}, {"open-collapse", {k + 2, k - 1}},
      {"boundary-split", {k - 1, k}}, {"boundary-collapse", {k, k - 1}},
  };
  const auto found = bits.find(family);
  if (found == bits.end()) fail("unknown family: " + line);
  header.before = found->second[0];
  header.after = found->second[1];
  return header;
}

constexpr long no_answer = -1;

// A fork of two nodes, by number; or a leaf: no_answer and the mask.
using Node = std::array<long, 2>;

class Table {
 public:
  explicit Table(const Header& header)
      : header_(header), answers_(std::size_t{1} << (header.ports + header.before), no_answer) {}

  std::size_t configurations() const { return answers_.size(); }

  // The number-th line of the table.
  void read_line(std::size_t number, const std::string& line) {
    std::istringstream words(line);
    std::string before, ports, after, kept, rest;
    words >> before >> ports >> after;
    const bool flip = header_.family == "flip";
    if (flip) words >> kept;
    const bool answered = after != "-";
    if (after.empty() || words >> rest || (flip && answered && kept.empty()) ||
        (!answered && kept != "" && kept != "-"))
      fail(header_.family + ": bad line: " + line);
    const std::size_t b = std::stoul(before, nullptr, 16);
    const std::size_t p = std::stoul(ports, nullptr, 16);
    if (b != number >> header_.ports || p != (number & ((std::size_t{1} << header_.ports) - 1)))
      fail(header_.family + ": line out of order: " + line);
    if (!answered) return;
    answers_[number] = static_cast<long>(std::stoul(after, nullptr, 16));
    if (flip) answers_[number] |= static_cast<long>(std::stoul(kept, nullptr, 16) << 1);
    if (answers_[number] >> header_.after != 0) fail(header_.family + ": answer too wide: " + line);
  }

  void print(std::ostream& out) {
    node(0, 0);
    constexpr std::size_t chunk = 500;
    const std::string name = header_.joined_by("_");
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (i % chunk == 0) out << "Definition nodes_" << name << "_part_" << i / chunk << " : list node := [\n";
      const auto [dashed, solid] = nodes_[i];
      if (dashed == no_answer)
        out << "Mask " << solid;
      else
        out << "Node " << dashed << ' ' << solid;
      out << (i % chunk + 1 == chunk || i + 1 == nodes_.size() ? "].\n" : i % 8 == 7 ? ";\n" : "; ");
    }
    out << "Definition table_" << name << " : trie := table_of " << header_.after << " (";
    for (std::size_t c = 0; c * chunk < nodes_.size(); ++c) out << "nodes_" << name << "_part_" << c << " ++ ";
    out << "[]).\n";
  }

 private:
  // The number of the subtrie in which the first `depth` bits are `bits`: ports first, then `before`, lowest bits
  // first.
  long node(unsigned depth, std::size_t bits) {
    Node found;
    if (depth == header_.ports + header_.before) {
      const long answer = answers_[bits];
      if (answer == no_answer) return 0;
      found = {no_answer, answer};
    } else {
      found = {node(depth + 1, bits), node(depth + 1, bits | std::size_t{1} << depth)};
      if (found == Node{0, 0}) return 0;
    }
    const auto [place, fresh] = numbers_.try_emplace(found, nodes_.size() + 1);
    if (fresh) nodes_.push_back(found);
    return place->second;
  }

  Header header_;
  std::vector<long> answers_;  // index before << number of ports | ports
  std::vector<Node> nodes_;    // node n is nodes_[n - 1]; node 0 has no answer
  std::map<Node, long> numbers_;
};

// Positions are [k; a], [k; i; j] or [k; i]; the others are mirror images or half turns of these.
bool listed(const Header& header) {
  unsigned sum = 0;
  for (std::size_t i = 1; i < header.position.size(); ++i) sum += header.position[i];
  return header.family == "flip" || (header.position.size() == 3 ? sum : 2 * sum) <= header.position[0];
}

// The file of one family.
class File {
 public:
  File(const std::string& directory, const std::string& family)
      : path_(directory + "/Tables_" + family + ".v"), out_(path_) {
    out_ << "(* Printed by print_tables from a table dump. *)\n"
            "Require Import NArith List.\nImport ListNotations.\nRequire Import Table.\nLocal Open Scope N_scope.\n";
  }
  void add(const Header& header, Table& table) {
    table.print(out_);
    cases_ += "  | [" + header.joined_by("; ") + "] => table_" + header.joined_by("_") + "\n";
  }
  void close() {
    out_ << "Definition table (position : list nat) : trie :=\n  match position with\n"
         << cases_ << "  | _ => Nothing\n  end%nat.\n";
    out_.close();
    if (!out_) fail("cannot write " + path_);
  }

 private:
  std::string path_;
  std::ofstream out_;
  std::string cases_;
};

// Passes over a table of lists, one line for each of 2^k port masks; returns how many there were.
std::size_t skip_lists(std::istream& in, const std::string& header) {
  std::istringstream words(header);
  std::string table, family, word;
  unsigned k = 0;
  words >> table >> family >> word >> k;
  if (word != "k" || k < 1 || k > 12) fail("no header: " + header);
  std::string line;
  for (std::size_t ports = 0; ports < std::size_t{1} << k; ++ports) {
    if (!std::getline(in, line)) fail("the dump ends in the middle of a table");
    if (std::stoul(line, nullptr, 16) != ports) fail(family + ": line out of order: " + line);
  }
  return std::size_t{1} << k;
}

void print_all(std::istream& in, const std::string& directory) {
  std::string line;
  if (!std::getline(in, line) || line != "restrip-table-dump 2") fail("not a table dump");
  std::size_t lines = 0;
  std::map<std::string, File> files;
  while (std::getline(in, line) && line.rfind("table ", 0) == 0) {
    if (line.rfind("table linked-", 0) == 0) {
      lines += skip_lists(in, line);
      continue;
    }
    const Header header = read_header(line);
    Table table(header);
    for (std::size_t i = 0; i < table.configurations(); ++i, ++lines) {
      if (!std::getline(in, line)) fail("the dump ends in the middle of a table");
      table.read_line(i, line);
    }
    if (!listed(header)) continue;
    files.try_emplace(header.family, directory, header.family).first->second.add(header, table);
  }
  if (line != "end " + std::to_string(lines)) fail("the dump does not end with `end " + std::to_string(lines) + "`");
  for (auto& [family, file] : files) file.close();
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) fail("usage: print_tables DIRECTORY < dump");
  print_all(std::cin, argv[1]);
} catch (const std::exception& error) {
  fail(error.what());
}
