// Prints a certificate (docs/certificate.md) as a Coq file Rows_FAMILY.v.
//
//   print_rows DIRECTORY < FAMILY.cert
//
// Of a copy the recolouring is left out: Rows.v works it out again from the symmetry. Reasons and sums are left out,
// too: the proof searches. At the end of the file stands the function from positions, lists of numbers such as [8; 3],
// to the rows of their sections.
// Anything unexpected ends the program with a message and exit code 1.
#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace {

[[noreturn]] void fail(const std::string& what) {
  std::cerr << "print_rows: " << what << '\n';
  std::exit(1);
}

struct Section {
  std::vector<std::string> position;
  std::vector<std::string> rows;

  std::string joined_by(const std::string& separator) const {
    std::string text;
    for (const std::string& n : position) text += (text.empty() ? "" : separator) + n;
    return text;
  }

  void print(std::ostream& out) const {
    constexpr std::size_t chunk = 500;
    const std::string name = joined_by("_");
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i % chunk == 0) out << "Definition rows_" << name << "_part_" << i / chunk << " : list row := [\n";
      out << rows[i] << (i % chunk + 1 == chunk || i + 1 == rows.size() ? "].\n" : i % 6 == 5 ? ";\n" : "; ");
    }
    out << "Definition rows_" << name << " : list row := ";
    for (std::size_t c = 0; c * chunk < rows.size(); ++c) out << "rows_" << name << "_part_" << c << " ++ ";
    out << "[].\n";
  }
};

unsigned number_in(const std::string& word, int base) {
  std::size_t read = 0;
  const unsigned long value = std::stoul(word, &read, base);
  if (read != word.size()) fail("bad number: " + word);
  return static_cast<unsigned>(value);
}

std::string hexadecimal(unsigned number) {
  std::ostringstream text;
  text << std::hex << number;
  return text.str();
}

// The theory has a bit for each port that is joined to the solid port before it; a certificate has pairs of ports, bit
// j (j - 1) / 2 + i for i < j.
unsigned joined_to_preceding(unsigned long long pairs, unsigned ports, unsigned count, bool closed) {
  unsigned joined = 0;
  for (unsigned port = 0; port < count; ++port) {
    if ((ports >> port & 1) == 0) continue;
    for (unsigned step = 1; step < count && (closed || step <= port); ++step) {
      const unsigned other = (port + count - step) % count;
      if ((ports >> other & 1) == 0) continue;
      const unsigned low = std::min(port, other);
      const unsigned high = std::max(port, other);
      if ((pairs >> (high * (high - 1) / 2 + low) & 1) != 0) {
        joined |= 1U << port;
      }
      break;
    }
  }
  return joined;
}

// A permutation of the ports as the turn or mirror that it is.
std::string symmetry_of(const std::vector<unsigned>& to) {
  const auto k = static_cast<unsigned>(to.size());
  bool turn = true;
  bool mirror = true;
  for (unsigned i = 0; i < k; ++i) {
    turn = turn && to[i] == (i + to[0]) % k;
    mirror = mirror && to[i] == (to[0] + k - i) % k;
  }
  if (!turn && !mirror) fail("neither a turn nor a mirror");
  return (turn ? "(Turn " : "(Mirror ") + std::to_string(to[0]) + ")";
}

// `rule P J R K because …` or `copy P J R K by port…`, as a row of Rows.v.
std::string read_row(const std::string& line, unsigned count, bool closed) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  if (words.size() < 6 || words[1] != words[4]) fail("bad row: " + line);
  const unsigned ports = number_in(words[1], 16);
  const unsigned long long pairs = std::stoull(words[2], nullptr, 16);
  const std::string key = " 0x" + words[1] + " 0x" + hexadecimal(joined_to_preceding(pairs, ports, count, closed));
  if (words[0] == "rule" && words[5] == "because") return "Rule" + key + " 0x" + words[3];
  if (words[0] != "copy" || words[5] != "by" || words.size() != 6 + count) fail("bad row: " + line);
  std::vector<unsigned> to;
  for (std::size_t i = 6; i < words.size(); ++i) to.push_back(number_in(words[i], 10));
  return "Copy" + key + " " + symmetry_of(to);
}

Section read_section(const std::string& line) {
  std::istringstream words(line);
  std::string word;
  Section section;
  while (words >> word)
    if (word.find_first_not_of("0123456789") == std::string::npos) section.position.push_back(word);
  return section;
}

void print_all(std::istream& in, const std::string& directory) {
  std::string line;
  if (!std::getline(in, line) || line != "restrip-certificate 3") fail("not a certificate");
  if (!std::getline(in, line) || line.rfind("operation ", 0) != 0) fail("no family");
  std::string family = line.substr(10);
  const bool closed = family == "split" || family == "collapse";
  for (char& c : family) c = c == '-' ? '_' : c;
  std::vector<Section> sections;
  std::size_t rows = 0;
  while (std::getline(in, line) && line.rfind("end ", 0) != 0) {
    if (line.rfind("section ", 0) == 0) {
      sections.push_back(read_section(line));
    } else if (line.rfind("claim ", 0) != 0) {
      if (sections.empty()) fail("a row before the first section: " + line);
      if (sections.back().position.empty()) fail("a section without a number");
      sections.back().rows.push_back(read_row(line, number_in(sections.back().position[0], 10), closed));
      ++rows;
    }
  }
  if (line.rfind("end " + std::to_string(rows) + " ", 0) != 0)
    fail("the certificate does not end with `end " + std::to_string(rows) + "` and two sums");

  const std::string path = directory + "/Rows_" + family + ".v";
  std::ofstream out(path);
  out << "(* Printed by print_rows from a certificate. *)\n"
         "Require Import NArith List.\nImport ListNotations.\nRequire Import Rows.\n";
  for (const Section& section : sections) section.print(out);
  out << "Definition rows (position : list nat) : list row :=\n  match position with\n";
  for (const Section& section : sections)
    out << "  | [" << section.joined_by("; ") << "] => rows_" << section.joined_by("_") << "\n";
  out << "  | _ => []\n  end.\n";
  out.close();
  if (!out) fail("cannot write " + path);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) fail("usage: print_rows DIRECTORY < certificate");
  print_all(std::cin, argv[1]);
} catch (const std::exception& error) {
  fail(error.what());
}
