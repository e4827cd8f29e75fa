#include "draw.hpp"

#include <fmt/format.h>

namespace restrip::verify {
namespace {

char mark(bool is_solid_edge) { return is_solid_edge ? '=' : '-'; }

std::string port_marks(const Patch& patch, Coloring colors, Node node) {
  std::string marks;
  for (auto [edge, end] = boost::out_edges(node, patch.graph()); edge != end; ++edge)
    if (const DualEdge& port = patch.graph()[*edge]; port.kind == EdgeKind::port)
      marks += solid(port, colors) ? '"' : ':';
  return marks;
}

}  // namespace

std::string listed(PortPairs pairs, unsigned ports) {
  std::string text;
  for (unsigned i = 0; i < ports; ++i)
    for (unsigned j = i + 1; j < ports; ++j)
      if (pairs.has(i, j)) text += fmt::format("{}{}-{}", text.empty() ? "" : " ", i, j);
  return text.empty() ? "none" : text;
}

std::string drawn(const Patch& patch, Coloring colors, const std::string& indent) {
  const std::vector<Node>& triangles = patch.triangles();
  const auto name = [&](Node node) { return patch.graph()[node].name; };
  const auto neighbor_edge = [&](std::size_t i) { return mark(is_solid(colors.inner, static_cast<unsigned>(i))); };

  std::string row = indent;
  std::string below = indent;
  const std::size_t closing = triangles.size() - 1;
  if (patch.closed()) row += fmt::format("({} {}) ", name(triangles.back()), neighbor_edge(closing));
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    below.resize(row.size(), ' ');
    below += port_marks(patch, colors, triangles[i]);
    row += name(triangles[i]);
    if (i < closing) row += fmt::format(" {} ", neighbor_edge(i));
  }
  if (patch.closed()) row += fmt::format(" ({} {})", neighbor_edge(closing), name(triangles.front()));
  if (patch.chord()) row += fmt::format("     chord A {} D", mark(is_solid(colors.inner, *patch.chord())));
  below.resize(std::max(row.size(), below.size()) + 5, ' ');
  below += "ports: \" solid, : dashed";

  const std::string fault = fault_of(patch, colors);
  const std::string strips = fault.empty()
                                 ? "ports joined inside: " + listed(survey(patch, colors).joined, patch.ports())
                                 : "not valid: " + fault;
  return row + '\n' + below + '\n' + indent + strips + '\n';
}

}  // namespace restrip::verify
