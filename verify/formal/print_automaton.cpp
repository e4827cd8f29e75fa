// Prints a dump of the automaton as the Coq file AutomatonNumbers.v.
//
//   print_automaton DIRECTORY < dump
//
// The dump is text: `restrip-automaton-dump 2`; for each array `array NAME SIZE` and its numbers, hexadecimal, one a
// line; for each position `answers FAMILY POSITION keys N digest D told T`; at last `end N`, N the number of lines that
// are numbers or answers. The answers become lists of families, positions and digests; Header.v and Automaton.v say
// what is digested. Anything unexpected ends the program with a message and exit code 1.
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
  std::cerr << "print_automaton: " << what << '\n';
  std::exit(1);
}

bool is_hexadecimal(const std::string& word) {
  return !word.empty() && word.find_first_not_of("0123456789abcdef") == std::string::npos;
}

std::string next_line(std::istream& in) {
  std::string line;
  if (!std::getline(in, line)) fail("the dump is cut off");
  return line;
}

void print_array(std::istream& in, std::ostream& out, std::istringstream& words, std::size_t& lines) {
  std::string name, rest;
  std::size_t size = 0;
  if (!(words >> name >> size) || words >> rest || size == 0) fail("bad head of an array: " + words.str());
  out << "Definition " << name << "_numbers : list N := [";
  for (std::size_t i = 0; i < size; ++i, ++lines) {
    const std::string number = next_line(in);
    if (!is_hexadecimal(number)) fail("bad number of " + name + ": " + number);
    out << (i == 0 ? "" : i % 16 == 0 ? ";\n" : "; ") << "0x" << number;
  }
  out << "]%N.\n";
}

// Families and positions with the digests of answers, and of what they tell.
struct Digests {
  std::vector<std::string> answers;
  std::vector<std::string> told;
};

void read_answers(std::istringstream& words, Digests& digests) {
  static const std::map<std::string, std::string> families = {{"split", "Splits"},
                                                              {"collapse", "Collapses"},
                                                              {"open-split", "OpenSplits"},
                                                              {"boundary-split", "BoundarySplits"},
                                                              {"fan-collapse", "FanCollapses"}};
  std::string family, word, position, keys, digest, behind, told, rest;
  words >> family;
  while (words >> word && word != "keys") {
    if (word.find_first_not_of("0123456789") != std::string::npos) fail("bad position: " + words.str());
    position += (position.empty() ? "" : "; ") + word;
  }
  if (families.count(family) == 0 || !(words >> keys >> word >> digest) || word != "digest" ||
      !is_hexadecimal(digest) || !(words >> behind >> told) || behind != "told" || !is_hexadecimal(told) ||
      words >> rest)
    fail("bad answers: " + words.str());
  const std::string place = "(" + families.at(family) + ", [" + position + "], 0x";
  digests.answers.push_back(place + digest + "%N)");
  digests.told.push_back(place + told + "%N)");
}

void print_all(std::istream& in, const std::string& directory) {
  if (next_line(in) != "restrip-automaton-dump 2") fail("not a dump of the automaton");
  const std::string path = directory + "/AutomatonNumbers.v";
  std::ofstream out(path);
  out << "(* Printed by print_automaton from the dump of the shipped header. *)\n"
         "Require Import NArith List.\nImport ListNotations.\nRequire Import Header.\n";
  Digests digests;
  std::size_t lines = 0;
  for (std::string line = next_line(in);; line = next_line(in)) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "array") {
      print_array(in, out, words, lines);
    } else if (kind == "answers") {
      read_answers(words, digests);
      ++lines;
    } else if (line == "end " + std::to_string(lines)) {
      break;
    } else {
      fail("bad line: " + line);
    }
  }
  std::string rest;
  if (std::getline(in, rest)) fail("something follows the end: " + rest);
  const auto print = [&](const char* name, const std::vector<std::string>& all) {
    out << "Definition " << name << " : list (walked_family * list nat * N) := [\n";
    for (std::size_t i = 0; i < all.size(); ++i) out << all[i] << (i + 1 < all.size() ? ";\n" : "].\n");
  };
  print("digests", digests.answers);
  print("told_digests", digests.told);
  out.close();
  if (!out) fail("cannot write " + path);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) fail("usage: print_automaton DIRECTORY < dump");
  print_all(std::cin, argv[1]);
} catch (const std::exception& error) {
  fail(error.what());
}
