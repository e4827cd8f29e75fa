// The choice of the linked look-up, for every configuration and every possible result of look_out. The look-up asks
// about one port after the other, and the next question depends on the answers, so its choices form a tree. Each
// tree is explored to its last leaf by asking again with other answers. Equal subtrees are printed once.
#include <array>
#include <cstdint>
#include <string>
#include <unordered_map>

#include "dump_output.hpp"
#include "restrip/operations/linked.hpp"

namespace restrip::dump {
namespace {

constexpr std::size_t most_ports = table_max_k;
constexpr int not_asked = -3;
constexpr auto nothing_known = [] {
  std::array<int, most_ports> known{};
  known.fill(not_asked);
  return known;
}();

/// The known answers for ports; other ports are answered by "the strip ends", and recorded as asked.
struct Answers {
  std::array<int, most_ports> known;
  std::array<std::size_t, most_ports> asked{};
  std::size_t count = 0;

  int operator()(std::size_t port) {
    if (known[port] == not_asked) {
      known[port] = strip_ends;
      asked[count++] = port;
    }
    return known[port];
  }
};

/// A question: the port, and where to continue when the strip ends, when it is out of sight, when it comes back through
/// port 0, 1, … Numbers of nodes are above all recolourings; 0 if an answer is impossible, else one more than that.
using Node = std::array<std::uint32_t, 3 + most_ports>;
constexpr std::uint32_t first_node = 1U << 16;

struct NodeHash {
  std::size_t operator()(const Node& node) const {
    std::uint64_t hash = 14695981039346656037U;
    for (const std::uint32_t word : node) {
      hash = (hash ^ word) * 1099511628211U;
      hash ^= hash >> 29U;
    }
    return hash;
  }
};

/// The trees of one position.
class Trees {
 public:
  explicit Trees(Output& out) : out_(&out) {}

  /// The root of the tree of `rule`, a function of look_out, after these answers; nodes that are new have been printed.
  template <class RuleOf>
  std::uint32_t root(const RuleOf& rule, Word ports, const std::array<int, most_ports>& known = nothing_known) {
    Answers answers{known};
    auto tree = static_cast<std::uint32_t>(rule(answers).colors);
    // One look-up yields a whole path of questions answered by "ends"; from the last one back, try the other answers.
    for (std::size_t i = answers.count; i-- > 0;) {
      const std::size_t port = answers.asked[i];
      auto now = answers.known;
      for (std::size_t later = i; later < answers.count; ++later) now[answers.asked[later]] = not_asked;
      Node node{static_cast<std::uint32_t>(port), tree + 1};
      now[port] = out_of_sight;
      node[2] = root(rule, ports, now) + 1;
      for (std::size_t other = 0; other < most_ports; ++other) {
        if (!has(ports, other) || other == port || now[other] != not_asked) continue;
        now[port] = static_cast<int>(other);
        now[other] = static_cast<int>(port);
        node[3 + other] = root(rule, ports, now) + 1;
        now[other] = not_asked;
      }
      tree = number_of(node);
    }
    return tree;
  }
  void word(std::uint32_t tree, char after) {
    if (tree >= first_node) out_->text("#");
    out_->hex(tree >= first_node ? tree - first_node : tree, after);
  }

 private:
  std::uint32_t number_of(const Node& node) {
    const auto [place, is_new] = numbers_.try_emplace(node, first_node + static_cast<std::uint32_t>(numbers_.size()));
    if (is_new) {
      out_->text("#");
      out_->hex(place->second - first_node, ' ');
      out_->hex(node[0], ' ');
      word(node[1] - 1, ' ');
      std::size_t end = node.size();
      while (node[end - 1] == 0) --end;
      word(node[2] - 1, end == 3 ? '\n' : ' ');
      for (std::size_t at = 3; at < end; ++at) {
        if (node[at] == 0) continue;
        out_->hex(at - 3, ' ');
        word(node[at] - 1, at + 1 == end ? '\n' : ' ');
      }
      out_->entry_done();
    }
    return place->second;
  }

  Output* out_;
  std::unordered_map<Node, std::uint32_t, NodeHash> numbers_;
};

}  // namespace

void linked_rules(Output& out, std::size_t max_k) {
  for (const bool collapse : {false, true})
    for (std::size_t k = 3; k <= max_k; ++k)
      for (std::size_t a = 1; a < k; ++a) {
        out.line((collapse ? "table linked-collapse k " : "table linked-split k ") + std::to_string(k) + " a " +
                 std::to_string(a));
        const SplitPosition at{k, a};
        Trees trees(out);
        for (Word before = 0; before < bit(collapse ? k + 3 : k); ++before)
          for (Word ports = 0; ports < bit(k); ++ports) {
            const auto rule = [&](Answers& answers) {
              return collapse ? linked_collapse_rule(at, before, ports, answers)
                              : linked_split_rule(at, before, ports, answers);
            };
            Answers answers{nothing_known};
            const bool valid = rule(answers).valid;
            const std::uint32_t tree = valid ? trees.root(rule, ports) : 0;
            out.hex(before, ' ');
            out.hex(ports, ' ');
            if (valid)
              trees.word(tree, '\n');
            else
              out.text("-\n");
            out.entry_done();
          }
      }
}

}  // namespace restrip::dump
