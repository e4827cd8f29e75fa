// Prints the automaton of rows as it was compiled, and digests of what the look-up of a family answers, for
// `restrip-verify-automaton --operation FILE --dump-command PROGRAM` (docs/certificate.md, "Dump of the automaton").
// For a family NAME with a number k from 3, whose position k has k ports, the whole program is
//
//     #include "restrip/automaton/NAME.hpp"
//     #include "restrip/tables/row_dump.hpp"
//     int main() {
//       restrip::tables::RowDump dump(restrip::tables::row_automaton);
//       for (unsigned k = 3; k <= 8; ++k)
//         dump.answers("NAME", {k}, k, [k](auto ports, auto joined) {
//           return restrip::exact::best_NAME(k, ports, joined);
//         });
//       return dump.end();
//     }
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <initializer_list>

namespace restrip::tables {

class RowDump {
 public:
  template <class Automaton>
  explicit RowDump(const Automaton& numbers) {
    std::printf("restrip-automaton-dump 2\n");
    array("next", numbers.next);
    array("before", numbers.before);
  }

  /// The answers to all keys of one position of the family, best(ports, joined).
  template <class Best>
  void answers(const char* family, std::initializer_list<unsigned> position, unsigned ports, const Best& best) {
    std::uint64_t keys = 1;
    for (unsigned i = 0; i < ports; ++i) keys *= 3;
    std::uint64_t digest = 0;
    std::uint64_t told = 0;
    for (std::uint64_t n = 0; n < keys; ++n) {
      std::uint64_t solid = 0;
      std::uint64_t joined = 0;
      std::uint64_t digits = n;
      for (unsigned i = ports; i-- > 0; digits /= 3) {
        if (digits % 3 != 0) solid |= std::uint64_t{1} << i;
        if (digits % 3 == 2) joined |= std::uint64_t{1} << i;
      }
      const auto found = best(solid, joined);
      digest = (digest * 1000003 + found.colors) * 1000003 + found.kept;
      told = told * 1000003 +
             static_cast<std::uint64_t>(4096 * found.value.solid + 64 * found.value.isolated + found.value.given_up);
    }
    std::printf("answers %s", family);
    for (const unsigned number : position) std::printf(" %u", number);
    std::printf(" keys %llu digest %llx told %llx\n", static_cast<unsigned long long>(keys),
                static_cast<unsigned long long>(digest), static_cast<unsigned long long>(told));
    ++lines_;
  }

  /// The last line. 0, or 1 when standard output takes no more.
  int end() {
    std::printf("end %zu\n", lines_);
    return std::fflush(stdout) == 0 && std::ferror(stdout) == 0 ? 0 : 1;
  }

 private:
  template <class Numbers>
  void array(const char* name, const Numbers& numbers) {
    std::printf("array %s %zu\n", name, numbers.size());
    for (const auto number : numbers) std::printf("%llx\n", static_cast<unsigned long long>(number));
    lines_ += numbers.size();
  }

  std::size_t lines_ = 0;
};

}  // namespace restrip::tables
