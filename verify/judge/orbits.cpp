// Compares configurations by nauty: two configurations are in one orbit if their coloured graphs are isomorphic. The
// graph of a configuration has these nodes:
//   - one for each port, coloured by solid or dashed and by whether it may be given up; if no triangle of a side has
//     several ports, it represents the triangle too;
//   - one for each other triangle, coloured by its side (before or after);
//   - one in the middle of each inner edge before the operation, coloured solid or dashed.
// The inner edges after the operation are plain edges, which fix the position.
//
// nauty's canonical graph does not contain the sizes of the colour classes: all edges solid and all edges dashed have
// the same canonical graph. So the class sizes are part of a configuration's canonical form.

#include "judge/orbits.hpp"

#include <nauty/nauty.h>

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>

namespace restrip::verify {
namespace {

constexpr int most_nodes = 22;
// A set of at most 64 nodes is one word.
using NautyGraph = std::array<graph, most_nodes>;

enum class NodeClass {
  dashed_port,
  solid_port,
  dashed_port_that_may_go,
  solid_port_that_may_go,
  own_before,
  own_after,
  dashed_edge,
  solid_edge
};
constexpr std::size_t class_count = 8;

/// The adjacency matrix of the canonical graph, and the sizes of the colour classes that vary.
using CanonicalForm = std::array<std::uint64_t, 4>;
static_assert(most_nodes * (most_nodes - 1) / 2 + 3 * 4 <= BitRow::capacity);

class ConfigurationGraph {
 public:
  explicit ConfigurationGraph(const Operation& operation)
      : ports_(operation.ports()), may_give_up_(operation.may_give_up) {
    for (unsigned port = 0; port < ports_; ++port) add_node(port_class(port, false));
    const std::vector<int> before = add_triangles(operation.before, NodeClass::own_before);
    const std::vector<int> after = add_triangles(operation.after, NodeClass::own_after);
    for (const auto& [one, other] : operation.after.edges) join(after[one], after[other]);
    first_edge_ = size();
    for (const auto& [one, other] : operation.before.edges) {
      const int middle = add_node(NodeClass::dashed_edge);
      join(middle, before[one]);
      join(middle, before[other]);
    }
  }

  bool has_too_many_nodes() const { return size() > most_nodes; }

  /// nauty keeps working memory for each thread, which an ending thread must release.
  ~ConfigurationGraph() {
    nauty_freedyn();
    nautil_freedyn();
    naugraph_freedyn();
  }
  ConfigurationGraph(const ConfigurationGraph&) = delete;
  ConfigurationGraph& operator=(const ConfigurationGraph&) = delete;

  void color(Mask inner, Mask ports) {
    for (unsigned port = 0; port < ports_; ++port) classes_[port] = port_class(port, is_solid(ports, port));
    for (std::size_t i = first_edge_; i < classes_.size(); ++i)
      classes_[i] =
          is_solid(inner, static_cast<unsigned>(i - first_edge_)) ? NodeClass::solid_edge : NodeClass::dashed_edge;
  }

  /// True if the identity is the only automorphism of the graph with its present colours.
  bool rigid() {
    run(nullptr);
    return stats_.grpsize1 == 1.0 && stats_.grpsize2 == 0;
  }

  CanonicalForm canonical_form() {
    NautyGraph canonical{};
    run(&canonical);
    BitRow form;
    for (int row = 0; row < static_cast<int>(size()); ++row)
      for (int column = row + 1; column < static_cast<int>(size()); ++column)
        form.append(ISELEMENT(GRAPHROW(canonical.data(), row, 1), column) != 0);
    form.append(class_size(NodeClass::solid_port), 4);
    form.append(class_size(NodeClass::solid_port_that_may_go), 4);
    form.append(class_size(NodeClass::solid_edge), 4);
    return form.words;
  }

 private:
  std::size_t size() const { return classes_.size(); }

  NodeClass port_class(unsigned port, bool solid) const {
    if (is_solid(may_give_up_, port))
      return solid ? NodeClass::solid_port_that_may_go : NodeClass::dashed_port_that_may_go;
    return solid ? NodeClass::solid_port : NodeClass::dashed_port;
  }

  int add_node(NodeClass node_class) {
    classes_.push_back(node_class);
    graph_.push_back(0);  // without edges
    return static_cast<int>(size()) - 1;
  }

  void join(int one, int other) { ADDONEEDGE(graph_.data(), one, other, 1); }

  /// The node of each triangle. The only port of a triangle represents it as well. Next to a triangle with several
  /// ports this is wrong: an inner edge between the two could be mistaken for one more port.
  std::vector<int> add_triangles(const Side& side, NodeClass own_class) {
    const std::set<unsigned> owners(side.owner_of_port.begin(), side.owner_of_port.end());
    std::vector<int> node_of(side.triangles, -1);
    if (owners.size() == side.ports())
      for (unsigned port = 0; port < side.ports(); ++port) node_of[side.owner_of_port[port]] = static_cast<int>(port);
    for (int& node : node_of)
      if (node < 0) node = add_node(own_class);
    if (owners.size() != side.ports())
      for (unsigned port = 0; port < side.ports(); ++port)
        join(node_of[side.owner_of_port[port]], static_cast<int>(port));
    return node_of;
  }

  void run(NautyGraph* canonical) {
    static DEFAULTOPTIONS_GRAPH(defaults);
    optionblk options = defaults;
    options.getcanon = canonical != nullptr;
    options.defaultptn = FALSE;
    std::array<int, most_nodes> labels{};
    std::array<int, most_nodes> partition{};
    std::array<int, most_nodes> orbits{};
    int count = 0;
    for (std::size_t node_class = 0; node_class < class_count; ++node_class) {
      const int first = count;
      for (std::size_t node = 0; node < size(); ++node)
        if (static_cast<std::size_t>(classes_[node]) == node_class) {
          labels[static_cast<std::size_t>(count)] = static_cast<int>(node);
          partition[static_cast<std::size_t>(count)] = 1;
          ++count;
        }
      if (count > first) partition[static_cast<std::size_t>(count) - 1] = 0;
    }
    densenauty(graph_.data(), labels.data(), partition.data(), orbits.data(), &options, &stats_, 1,
               static_cast<int>(size()), canonical != nullptr ? canonical->data() : nullptr);
    if (stats_.errstatus != 0) throw std::runtime_error("nauty failed");
  }

  unsigned class_size(NodeClass node_class) const {
    return static_cast<unsigned>(std::count(classes_.begin(), classes_.end(), node_class));
  }

  unsigned ports_;
  Mask may_give_up_;
  std::size_t first_edge_ = 0;
  std::vector<NodeClass> classes_;
  std::vector<graph> graph_;  ///< a word for each node
  statsblk stats_{};
};

std::uint64_t different(std::vector<CanonicalForm>& forms) {
  std::sort(forms.begin(), forms.end());
  return static_cast<std::uint64_t>(std::unique(forms.begin(), forms.end()) - forms.begin());
}

/// A cost that counts all members is invariant under every symmetry of the patch.
bool counts_everything(const Operation& operation) {
  for (const Criterion& criterion : operation.cost)
    for (const Term& term : criterion)
      if (among_of(term.count) != Among::nothing) return false;
  return true;
}

}  // namespace

std::optional<OrbitCounts> nauty_orbits(const Operation& operation, const std::vector<bool>& valid) {
  if (!counts_everything(operation)) return {};
  ConfigurationGraph configuration(operation);
  if (configuration.has_too_many_nodes()) return {};
  if (configuration.rigid())
    return OrbitCounts{valid.size(), static_cast<std::uint64_t>(std::count(valid.begin(), valid.end(), true))};
  std::vector<CanonicalForm> all;
  std::vector<CanonicalForm> of_valid;
  const unsigned port_bits = operation.ports();
  for (Mask both = 0; both < valid.size(); ++both) {
    configuration.color(high_part(both, port_bits), low_part(both, port_bits));
    all.push_back(configuration.canonical_form());
    if (valid[both]) of_valid.push_back(all.back());
  }
  return OrbitCounts{different(all), different(of_valid)};
}

}  // namespace restrip::verify
