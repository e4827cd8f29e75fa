// Validity, soundness and keys, by union-find.

#include <algorithm>

#include "naive_tables.hpp"

namespace restrip::verify::test {
namespace {

bool has(int mask, int i) { return (mask >> i) % 2 != 0; }
int count(int mask) { return mask == 0 ? 0 : mask % 2 + count(mask / 2); }
int size(const NaivePatch& patch) { return 1 << static_cast<int>(patch.edges.size()); }

class Sets {
 public:
  int root(int x) {
    while (parent_.contains(x)) x = parent_[x];
    return x;
  }
  /// False when both were in one set already.
  bool unite(int x, int y) {
    if (root(x) == root(y)) return false;
    parent_[root(x)] = root(y);
    return true;
  }

 private:
  std::map<int, int> parent_;
};

bool cycle_allowed(const NaivePatch& patch, int inner, Dropped dropped) {
  const bool uses_chord = patch.chord >= 0 && has(inner, patch.chord);
  return dropped == Dropped::all_cycles || (dropped == Dropped::outer_cycle && patch.chord >= 0 && !uses_chord) ||
         (dropped == Dropped::chord_cycles && uses_chord);
}

bool degree_allowed(int triangle, int degree, Dropped dropped) {
  return degree <= 2 || dropped == Dropped::degrees || (dropped == Dropped::new_degrees && triangle >= triangle_a);
}

}  // namespace

std::optional<Anatomy> anatomy(const NaivePatch& patch, NaiveColors colors, Dropped dropped) {
  Sets strips;
  std::map<int, int> degree;
  for (int i = 0; i < static_cast<int>(patch.edges.size()); ++i) {
    if (!has(colors.inner, i)) continue;
    const auto [one, other] = patch.edges[static_cast<std::size_t>(i)];
    ++degree[one];
    ++degree[other];
    if (!strips.unite(one, other) && !cycle_allowed(patch, colors.inner, dropped)) return {};
  }
  const int ports = static_cast<int>(patch.port_owner.size());
  const auto owner = [&](int port) { return patch.port_owner[static_cast<std::size_t>(port)]; };
  for (int port = 0; port < ports; ++port)
    if (has(colors.ports, port)) ++degree[owner(port)];
  Anatomy result;
  for (const int triangle : patch.triangles) {
    if (!degree_allowed(triangle, degree[triangle], dropped)) return {};
    if (degree[triangle] == 0) ++result.isolated;
  }
  for (int i = 0; i < ports; ++i)
    for (int j = i + 1; j < ports; ++j)
      if (has(colors.ports, i) && has(colors.ports, j) && strips.root(owner(i)) == strips.root(owner(j)))
        result.joined.insert({i, j});
  result.solid = count(colors.inner) + count(colors.ports);
  return result;
}

std::vector<Candidate> sound_recolorings(const NaiveOperation& operation, NaiveColors before, Dropped dropped) {
  const std::set<Pair> joined = anatomy(operation.before, before)->joined;
  std::vector<Candidate> result;
  for (int kept = 0; kept <= before.ports; ++kept) {
    if ((kept & before.ports) != kept || (kept != before.ports && !operation.flip)) continue;
    for (int inner = 0; inner < size(operation.after); ++inner) {
      const std::optional<Anatomy> after = anatomy(operation.after, {inner, kept}, dropped);
      if (!after) continue;
      if (dropped != Dropped::pairing &&
          !std::includes(joined.begin(), joined.end(), after->joined.begin(), after->joined.end()))
        continue;
      const int given_up = count(before.ports) - count(kept);
      result.push_back({{inner, kept}, {after->solid, -(after->isolated + given_up), count(kept)}});
    }
  }
  return result;
}

NaiveKey naive_key(const NaiveOperation& operation, NaiveColors before) {
  if (operation.flip) return {before.ports, before.inner};
  const std::set<Pair> joined = anatomy(operation.before, before)->joined;
  std::vector<int> solid;
  for (int port = 0; port < static_cast<int>(operation.before.port_owner.size()); ++port)
    if (has(before.ports, port)) solid.push_back(port);
  int mask = 0;
  for (std::size_t i = 0; i < solid.size(); ++i) {
    if (i == 0 && !operation.before.closed) continue;
    const int preceding = i == 0 ? solid.back() : solid[i - 1];
    if (joined.contains({std::min(preceding, solid[i]), std::max(preceding, solid[i])})) mask += 1 << solid[i];
  }
  return {before.ports, mask};
}

void for_each_valid(const NaiveSection& section, const std::function<void(const NaiveOperation&, NaiveColors)>& visit) {
  for (const NaiveOperation& operation : section.operations)
    for (int inner = 0; inner < size(operation.before); ++inner)
      for (int ports = 0; ports < 1 << static_cast<int>(operation.before.port_owner.size()); ++ports)
        if (anatomy(operation.before, {inner, ports})) visit(operation, {inner, ports});
}

}  // namespace restrip::verify::test
