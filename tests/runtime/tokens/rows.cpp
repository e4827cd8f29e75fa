// Rules for rows: every key of rows with up to five ports, on words and on bit strings, some keys of longer ones.

#include "guarded_new.hpp"
#include "judge.hpp"
#include "restrip/rules/row.hpp"
#include "restrip/tables/row_automaton.hpp"

namespace {

using namespace restrip;
using exact::Row;
using exact::RowValue;
using judge::Bits;
using judge::Digest;
using judge::some_bits;

void tell(Digest& told, const RowValue& value) { told.add(value.solid, value.isolated, value.given_up); }

/// On bit strings.
void asked_long(Digest& told, const Row& row, BitSpan ports, BitSpan joined) {
  const Bits colors(row.triangles - 1, ~Word{0});
  const Bits kept(row.ports(), ~Word{0});
  const std::size_t before = judge::allocated;
  tell(told, exact::best_row<tables::row_automaton>(row, ports, joined, colors.write(), kept.write()));
  told.add(judge::allocated - before);
  colors.tell(told);
  kept.tell(told);
}

void asked(Digest& told, const Row& row, Word ports, Word joined) {
  const exact::RowRecoloring found = exact::best_row<tables::row_automaton>(row, ports, joined);
  told.add(found.colors, found.kept);
  tell(told, found.value);
  asked_long(told, row, BitSpan::of(ports), BitSpan::of(joined));
}

/// Calls with the four rows of so many triangles, at each place of their first port.
template <class Ask>
void each_row(std::size_t triangles, const Ask& ask) {
  for (const bool front : {false, true})
    for (const bool back : {false, true}) {
      const Row row{triangles, front, back, 0};
      for (std::size_t first = 0; first < row.ports(); ++first) ask(Row{triangles, front, back, first});
    }
}

void words() {
  for (std::size_t n = 1; n <= 4; ++n) {
    Digest told("rows", n);
    each_row(n, [&](const Row& row) {
      for (Word ports = 0; row.ports() < 6 && ports < bit(row.ports()); ++ports)
        for (Word joined = 0; joined < bit(row.ports()); ++joined) asked(told, row, ports, joined);
    });
  }
  for (const std::size_t n : judge::Sizes{5, 8, 17, 61, 62}) {
    Digest told("rows", n);
    each_row(n, [&](const Row& row) {
      for (int times = 0; times < (n < 10 ? 100 : 4); ++times)
        asked(told, row, some_bits(row.ports()), times % 2 == 0 ? some_bits(row.ports()) : low_bits(row.ports()));
    });
  }
}

void strings() {
  for (const std::size_t n : judge::Sizes{60, 63, 64, 65, 126, 129}) {
    Digest told("strings", n);
    each_row(n, [&](const Row& row) {
      const judge::SomeBits ports(row.ports());
      const judge::SomeBits joined(row.ports());
      asked_long(told, row, ports.read(), joined.read());
    });
  }
}

/// Strands over all ports between the first and the last, which are joined: one port between them, and all.
void across() {
  for (const std::size_t n : judge::Sizes{3, 4, 5, 8, 66}) {
    Digest told("across", n);
    each_row(n, [&](const Row& row) {
      if (n > 60 && row.first % 16 != 0) return;
      for (std::size_t last = 2; last < row.ports(); ++last)
        for (std::size_t first = 0; first + 1 < last; first += n > 60 ? 7 : 1)
          for (const std::size_t step : {std::size_t{1}, (last - first) / 2}) {
            const Bits ports(row.ports());
            const Bits joined(row.ports());
            for (std::size_t place = first; place < last; place += step) ports.write().set(row.port(place));
            ports.write().set(row.port(last));
            joined.write().set(row.port(first));
            asked_long(told, row, ports.read(), joined.read());
          }
    });
  }
}

/// Compilers find reads and writes outside the room of the longest words.
constexpr Word widest = exact::best_row<tables::row_automaton>({62, true, true, 0}, ~Word{0}, ~Word{0}).kept;

/// What members hold of which nothing is said, and what compares values.
void defaults() {
  Digest told("defaults");
  const Row row;
  told.add(row.triangles, row.front, row.back, row.first, widest);
  const exact::RowRecoloring found;
  told.add(found.colors, found.kept);
  tell(told, found.value);
  const RowValue values[] = {{0, 0, 0}, {2, 1, 1}, {1, 0, 0}, {2, 0, 1}, {3, 0, 2},
                             {1, 1, 0}, {2, 2, 1}, {3, 1, 2}, {3, 1, 3}};
  for (const RowValue& one : values)
    for (const RowValue& other : values) told.add(one == other, one.better_than(other));
}

}  // namespace

int main(int argc, char** argv) { return judge::run(argc, argv, {defaults, words, strings, across}); }
