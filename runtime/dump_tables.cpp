// restrip-dump-tables: prints what the compiled rules answer to every configuration, valid or not, in every position,
// so that those who trust neither the generator nor the look-up in the tables can compare (docs/certificate.md, "Table
// dump").
#include <cstdio>
#include <string>

#include "restrip/linked.hpp"
#include "restrip/rules.hpp"

namespace {

using restrip::Word;

class Output {
 public:
  explicit Output(std::FILE* file) : file_(file) { text_.reserve(size); }

  void line(const std::string& words) {
    text_ += words;
    text_ += '\n';
    flush_if_full();
  }
  void hex(Word value, char after) {
    char digits[16];
    int n = 0;
    do {
      digits[n++] = "0123456789abcdef"[value & 15U];
      value >>= 4;
    } while (value != 0);
    while (n > 0) text_ += digits[--n];
    text_ += after;
  }
  void configuration(Word before, Word ports, const restrip::Rule& rule) {
    hex(before, ' ');
    hex(ports, ' ');
    if (rule.valid)
      hex(rule.colors, '\n');
    else
      text_ += "-\n";
    entry_done();
  }
  void flip(bool inner, unsigned ports, const restrip::FlipRule& rule) {
    hex(inner ? 1 : 0, ' ');
    hex(ports, ' ');
    if (rule.valid) {
      hex(rule.inner ? 1 : 0, ' ');
      hex(rule.ports, '\n');
    } else {
      text_ += "-\n";
    }
    entry_done();
  }
  void entry_done() {
    ++lines_;
    flush_if_full();
  }
  /// False when not everything could be written.
  bool finish() {
    line("end " + std::to_string(lines_));
    flush();
    return std::fflush(file_) == 0 && std::ferror(file_) == 0;
  }

 private:
  static constexpr std::size_t size = std::size_t{1} << 16;
  void flush() {
    std::fwrite(text_.data(), 1, text_.size(), file_);
    text_.clear();
  }
  void flush_if_full() {
    if (text_.size() > size - 4096) flush();
  }
  std::FILE* file_;
  std::string text_;
  std::size_t lines_ = 0;
};

/// Every pair of masks, in ascending order.
template <class Rule>
void all(Output& out, std::size_t before_bits, std::size_t port_bits, Rule&& rule) {
  for (Word before = 0; before < restrip::bit(before_bits); ++before)
    for (Word ports = 0; ports < restrip::bit(port_bits); ++ports)
      out.configuration(before, ports, rule(before, ports));
}

template <class Table>
void lists(Output& out, const std::string& heading, const Table& table, std::size_t k, std::size_t place) {
  out.line(heading);
  for (Word ports = 0; ports < restrip::bit(k); ++ports) {
    const std::size_t list = table.first[k] + (place << k) + ports;
    out.hex(ports, ' ');
    for (std::size_t at = table.start[list]; at < table.start[list + 1]; ++at) {
      out.hex(table.rules[at].recoloring, ' ');
      out.hex(restrip::tables::pairings[table.rules[at].pairing], at + 1 < table.start[list + 1] ? ' ' : '\n');
    }
    out.entry_done();
  }
}

}  // namespace

int main() {
  using std::to_string;
  Output out(stdout);
  out.line("restrip-table-dump 2");
  const std::size_t max_k = restrip::table_max_k;
  for (const bool collapse : {false, true}) {
    for (std::size_t k = 3; k <= max_k; ++k) {
      for (std::size_t a = 1; a < k; ++a) {
        out.line((collapse ? "table collapse k " : "table split k ") + to_string(k) + " a " + to_string(a));
        const restrip::SplitPosition at{k, a};
        all(out, collapse ? k + 3 : k, k, [&](Word before, Word ports) {
          return collapse ? collapse_rule(at, before, ports) : split_rule(at, before, ports);
        });
      }
    }
  }
  for (const bool collapse : {false, true}) {
    for (std::size_t k = 1; k <= max_k; ++k) {
      for (std::size_t i = 0; i <= k; ++i) {
        for (std::size_t j = i + 1; j <= k; ++j) {
          out.line((collapse ? "table open-collapse k " : "table open-split k ") + to_string(k) + " gaps " +
                   to_string(i) + " " + to_string(j));
          const restrip::GapPair at{k, i, j};
          all(out, collapse ? k + 2 : k - 1, k, [&](Word before, Word ports) {
            return collapse ? open_collapse_rule(at, before, ports) : open_split_rule(at, before, ports);
          });
        }
      }
    }
  }
  for (const bool collapse : {false, true}) {
    for (std::size_t k = 1; k <= max_k; ++k) {
      for (std::size_t i = 0; i <= k; ++i) {
        out.line((collapse ? "table boundary-collapse k " : "table boundary-split k ") + to_string(k) + " gap " +
                 to_string(i));
        const restrip::Gap at{k, i};
        all(out, collapse ? k : k - 1, k, [&](Word before, Word ports) {
          return collapse ? boundary_collapse_rule(at, before, ports) : boundary_split_rule(at, before, ports);
        });
      }
    }
  }
  for (std::size_t k = 3; k <= max_k; ++k)
    for (std::size_t a = 1; a <= k / 2; ++a)
      lists(out, "table linked-split k " + to_string(k) + " a " + to_string(a), restrip::tables::linked_split, k,
            a - 1);
  for (std::size_t k = 3; k <= max_k; ++k)
    lists(out, "table linked-collapse k " + to_string(k), restrip::tables::linked_collapse, k, 0);
  out.line("table flip");
  for (const bool inner : {false, true})
    for (unsigned ports = 0; ports < 16; ++ports) out.flip(inner, ports, restrip::flip_rule(inner, ports));
  return out.finish() ? 0 : 1;
}
