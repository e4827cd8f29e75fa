#include "automaton/automaton_dump.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "automaton/answers.hpp"
#include "certificate/stream_lines.hpp"
#include "model/coloring.hpp"

namespace restrip::verify {
namespace {

using NumbersOf = std::vector<std::uint64_t>;

/// A case in the four-bit code of restrip/tables/automaton_format.hpp.
std::uint64_t coded(std::size_t number) {
  constexpr std::string_view reach = "-ept";
  const Case wanted = case_at(number);
  return 4 * reach.find(wanted.left) + reach.find(wanted.right);
}

class AutomatonDumpReader {
 public:
  AutomatonDumpReader(StreamLines& lines, const AutomatonCertificate& certificate, unsigned max_k,
                      AutomatonDumpCheck& check)
      : lines_(lines), certificate_(certificate), max_k_(max_k), check_(check) {}

  void run() {
    lines_.expect("restrip-automaton-dump 2");
    const std::size_t classes = certificate_.classes.size();
    const NumbersOf next = array("next", letters.size() * classes);
    const NumbersOf before = array("before", letters.size() * classes);
    const NumbersOf closed = array("closed", classes);
    first_ = array("first", classes);
    second_ = array("second", classes);
    meet_ = array("meet", {});
    meetings_ = array("meetings", {});
    seconds_ = array("seconds", 1).front();
    for (std::size_t c = 0; c < classes; ++c) compare_class(c, next, before, closed);
    read_answers();
    lines_.expect_last(fmt::format("end {}", entries_));
  }

 private:
  NumbersOf array(const std::string& name, std::optional<std::size_t> size) {
    const std::string head = fmt::format("array {} ", name);
    const std::string_view line = lines_.next(head);
    if (!line.starts_with(head)) lines_.fail(fmt::format("expected \"{}\" and a size, found \"{}\"", head, line));
    const std::uint64_t found = lines_.number_in(line.substr(head.size()), 10);
    if (size && found != *size) lines_.fail(fmt::format("expected {} numbers of {}, found {}", *size, name, found));
    NumbersOf numbers;
    for (std::uint64_t i = 0; i < found; ++i, ++entries_)
      numbers.push_back(lines_.number_in(lines_.next("a number"), 16));
    return numbers;
  }

  template <class Where>
  void compare(std::uint64_t found, std::uint64_t stated, unsigned line, const Where& where) {
    ++check_.numbers;
    if (found != stated)
      check_.wrong_numbers.add(fmt::format("{}: the table holds {}, but line {} of {} gives {}\n", where(), found, line,
                                           certificate_.file, stated));
  }

  void compare_class(std::size_t c, const NumbersOf& next, const NumbersOf& before, const NumbersOf& closed) {
    const AutomatonClass& stated = certificate_.classes[c];
    for (std::size_t letter = 0; letter < stated.steps.size(); ++letter) {
      const std::size_t place = stated.steps.size() * c + letter;
      const auto where = [&](const char* array) { return [=] { return fmt::format("{}[{}]", array, place); }; };
      const auto& step = stated.steps[letter];
      if (!step) continue;
      compare(next[place], step->to, step->line, where("next"));
      const AutomatonClass& to = certificate_.classes[step->to];
      for (std::size_t i = 0; i < case_count; ++i)
        if (to.costs[i]) compare(four_bits(before[place], coded(i)), coded(step->from[i]), step->line, where("before"));
    }
    if (const auto& closing = certificate_.closings[c])
      compare(closed[c], coded(closing->arc), closing->line, [&] { return fmt::format("closed[{}]", c); });
    if (!stated.as_first) return;
    for (std::size_t other = 0; other < certificate_.classes.size(); ++other) {
      if (!certificate_.classes[other].as_second) continue;
      const AutomatonMeeting& met = certificate_.meeting(c, other);
      const std::uint64_t place = seconds_ * first_[c] + second_[other];
      const std::uint64_t found = place < meet_.size() && meet_[place] < meetings_.size() ? meetings_[meet_[place]] : 0;
      compare(found, coded(met.first) + 16 * coded(met.second) + (met.chord ? 256U : 0U), met.line,
              [&] { return fmt::format("the meeting of classes {} and {}", c, other); });
    }
  }

  void read_answers() {
    const AutomatonReader certified(certificate_);
    for (const char* family : {"split", "collapse", "open-split", "boundary-split", "fan-collapse"})
      for (unsigned k = 1; k <= max_k_; ++k)
        for (const FanPlace& place : all_places(k))
          if (place.family == family) read_place(certified, place);
  }

  void read_place(const AutomatonReader& certified, const FanPlace& place) {
    std::string head = fmt::format("answers {} {}", place.family, place.k);
    if (place.family.ends_with("split")) head += fmt::format(" {}", place.a);
    if (place.family == "open-split") head += fmt::format(" {}", place.b);
    const Side patch = patch_after(place.family, {place.k, place.a, place.b});
    std::uint64_t keys = 1;
    for (unsigned i = 0; i < place.k; ++i) keys *= 3;
    head += fmt::format(" keys {} digest ", keys);
    const std::string_view line = lines_.next(head);
    if (!line.starts_with(head)) lines_.fail(fmt::format("expected \"{}\" and a digest, found \"{}\"", head, line));
    ++entries_;
    std::uint64_t digest = 0;
    std::uint64_t changes = 0;
    for (std::uint64_t n = 0; n < keys; ++n) {
      const FanKey key = seen_key(written_key(place.k, n), place);
      const Mask inner = certified.answer(place, key).inner;
      digest = digest * 1000003 + inner;
      changes = changes * 1000003 + std::uint64_t{64} * solid_count(inner) + isolated_of(patch, {inner, key.ports});
    }
    check_.keys += keys;
    if (const std::string right = fmt::format("{}{:x} told {:x}", head, digest, changes); line != right)
      check_.wrong_answers.add(
          fmt::format("line {}: the certificate's answers give\n  {}\nfound\n  {}\n", lines_.number(), right, line));
  }

  StreamLines& lines_;
  const AutomatonCertificate& certificate_;
  unsigned max_k_;
  AutomatonDumpCheck& check_;
  std::uint64_t entries_ = 0;
  NumbersOf first_, second_, meet_, meetings_;
  std::uint64_t seconds_ = 0;
};

}  // namespace

AutomatonDumpCheck check_automaton_dump(std::FILE* stream, const AutomatonCertificate& certificate, unsigned max_k) {
  return found_in<AutomatonDumpCheck>(stream, [&](StreamLines& lines, AutomatonDumpCheck& check) {
    AutomatonDumpReader(lines, certificate, max_k, check).run();
  });
}

AutomatonDumpCheck check_automaton_dump_of(const std::string& program, const AutomatonCertificate& certificate,
                                           unsigned max_k) {
  return checked_output_of(program,
                           [&](std::FILE* stream) { return check_automaton_dump(stream, certificate, max_k); });
}

Digests automaton_digests(const AutomatonCertificate& certificate, unsigned max_k) {
  constexpr std::array<std::string_view, 5> operations = {"split", "collapse", "open-split", "fan-collapse",
                                                          "boundary-split"};
  constexpr std::uint32_t most_keys = 7000;
  constexpr std::uint32_t drawn_keys = 64;
  const AutomatonReader reader(certificate);
  Digests digests;
  std::uint32_t keys = 1;
  for (unsigned k = 1; k <= max_k; ++k) {
    if (keys <= most_keys) keys *= 3;
    for (const FanPlace& place : all_places(k)) {
      const auto operation = std::find(operations.begin(), operations.end(), place.family) - operations.begin();
      std::uint32_t& digest = digests[fmt::format("{} {} {} {}", operation, k, place.a, place.b)];
      for (std::uint32_t n = 0; n < (keys <= most_keys ? keys : drawn_keys); ++n) {
        const auto drawn = [&](Mask number) { return low_part(mixed_number(n, number, 0), k); };
        const FanKey key = keys <= most_keys ? written_key(k, n) : FanKey{drawn(0), drawn(1)};
        digest += mixed_number(n, key.ports, 0x80000000U | reader.answer(place, seen_key(key, place)).inner);
      }
    }
  }
  return digests;
}

}  // namespace restrip::verify
