// One graph for each configuration of an operation: two configurations are in one orbit when their coloured graphs are
// isomorphic. Its nodes:
//   * one for each port, coloured solid or dashed; it stands for the triangle as well where a triangle has one port;
//   * one for each triangle without a port, and for each triangle with several, coloured by the side (before or after)
//     that it belongs to;
//   * one in the middle of each inner edge before the operation, coloured solid or dashed.
// The inner edges after the operation are plain edges: they hold the position fast.
//
// nauty's canonical graph does not tell how large the colour classes are: all edges solid and all edges dashed have
// the same canonical graph. So the class sizes are part of a configuration's canonical form.

#include <nauty/nauty.h>

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

#include "orbits.hpp"

namespace restrip::verify {
namespace {

constexpr int most_nodes = 22;
// A set of at most 64 nodes is one word.
using NautyGraph = std::array<graph, most_nodes>;

enum class NodeClass { dashed_port, solid_port, own_before, own_after, dashed_edge, solid_edge };
constexpr std::size_t class_count = 6;

/// The adjacency matrix of the canonical graph, and the sizes of the colour classes that vary.
using CanonicalForm = std::array<std::uint64_t, 4>;
static_assert(most_nodes * (most_nodes - 1) / 2 + 2 * 4 <= BitRow::capacity);

class ConfigurationGraph {
 public:
  explicit ConfigurationGraph(const Operation& operation) : ports_(operation.before.ports()) {
    EMPTYGRAPH(graph_.data(), 1, most_nodes);
    for (unsigned port = 0; port < ports_; ++port) classes_.push_back(NodeClass::dashed_port);
    const std::map<Node, int> before = add_triangles(operation.before, NodeClass::own_before);
    const std::map<Node, int> after = add_triangles(operation.after, NodeClass::own_after);
    add_edges(operation.after, after, false);
    first_edge_ = size();
    add_edges(operation.before, before, true);
  }

  /// nauty keeps working memory for each thread; a thread that ends must give it back.
  ~ConfigurationGraph() {
    nauty_freedyn();
    nautil_freedyn();
    naugraph_freedyn();
  }
  ConfigurationGraph(const ConfigurationGraph&) = delete;
  ConfigurationGraph& operator=(const ConfigurationGraph&) = delete;

  void color(Mask inner, Mask ports) {
    for (unsigned port = 0; port < ports_; ++port)
      classes_[port] = is_solid(ports, port) ? NodeClass::solid_port : NodeClass::dashed_port;
    for (std::size_t i = first_edge_; i < classes_.size(); ++i)
      classes_[i] =
          is_solid(inner, static_cast<unsigned>(i - first_edge_)) ? NodeClass::solid_edge : NodeClass::dashed_edge;
  }

  /// True when only the identity carries the graph onto itself with its present colours.
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
    form.append(class_size(NodeClass::solid_edge), 4);
    return form.words;
  }

 private:
  std::size_t size() const { return classes_.size(); }

  int add_node(NodeClass node_class) {
    classes_.push_back(node_class);
    if (size() > most_nodes) throw std::logic_error("patch too large for its nauty graph");
    return static_cast<int>(size()) - 1;
  }

  void join(int one, int other) { ADDONEEDGE(graph_.data(), one, other, 1); }

  std::map<Node, int> add_triangles(const Patch& patch, NodeClass own_class) {
    std::map<Node, std::vector<int>> ports_of;
    for (unsigned port = 0; port < patch.ports(); ++port)
      ports_of[patch.owner_of_port(port)].push_back(static_cast<int>(port));
    std::map<Node, int> node_of;
    for (const Node triangle : patch.triangles()) {
      const std::vector<int>& ports = ports_of[triangle];
      if (ports.size() == 1) {
        node_of[triangle] = ports.front();
        continue;
      }
      node_of[triangle] = add_node(own_class);
      for (const int port : ports) join(node_of[triangle], port);
    }
    return node_of;
  }

  void add_edges(const Patch& patch, const std::map<Node, int>& node_of, bool with_middle) {
    // Boost lists edges in the order in which they were added, inner edges among them in ascending order of index.
    for (auto [edge, end] = boost::edges(patch.graph()); edge != end; ++edge) {
      if (patch.graph()[*edge].kind != EdgeKind::inner) continue;
      const int one = node_of.at(boost::source(*edge, patch.graph()));
      const int other = node_of.at(boost::target(*edge, patch.graph()));
      if (!with_middle) {
        join(one, other);
        continue;
      }
      const int middle = add_node(NodeClass::dashed_edge);
      join(middle, one);
      join(middle, other);
    }
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
  std::size_t first_edge_ = 0;
  std::vector<NodeClass> classes_;
  NautyGraph graph_{};
  statsblk stats_{};
};

std::uint64_t different(std::vector<CanonicalForm>& forms) {
  std::sort(forms.begin(), forms.end());
  return static_cast<std::uint64_t>(std::unique(forms.begin(), forms.end()) - forms.begin());
}

}  // namespace

OrbitCounts nauty_orbits(const Operation& operation, const std::vector<bool>& valid) {
  ConfigurationGraph configuration(operation);
  if (configuration.rigid())
    return {valid.size(), static_cast<std::uint64_t>(std::count(valid.begin(), valid.end(), true))};
  std::vector<CanonicalForm> all;
  std::vector<CanonicalForm> of_valid;
  const unsigned port_bits = operation.before.ports();
  for (Mask both = 0; both < valid.size(); ++both) {
    configuration.color(high_part(both, port_bits), low_part(both, port_bits));
    all.push_back(configuration.canonical_form());
    if (valid[both]) of_valid.push_back(all.back());
  }
  return {different(all), different(of_valid)};
}

}  // namespace restrip::verify
