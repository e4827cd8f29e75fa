// In place of nauty, whose library is for this machine: the part of its interface that finds symmetries. The programs,
// which use nauty, write the same files.
//
// The generators are a chain of stabilisers: for each vertex v, with the vertices before it fixed, an automorphism for
// each image of v that those found so far do not reach. The order of the group is the product of the sizes of these
// orbits. Automorphisms are found by backtracking over images of the same colour with the same neighbours so far.
#pragma once
#include <cstdint>
#include <vector>

using graph = std::uint64_t;
using setword = std::uint64_t;
struct optionblk {
  int defaultptn = 1;
  void (*userautomproc)(int, int*, int*, int, int, int) = nullptr;
};
struct statsblk {
  double grpsize1 = 1;
  int grpsize2 = 0;
};
#define DEFAULTOPTIONS_GRAPH(options) optionblk options
#define SETWORDSNEEDED(n) (((n) + 63) / 64)
#define GRAPHROW(g, v, m) ((g) + static_cast<std::size_t>(m) * static_cast<std::size_t>(v))
#define ADDELEMENT(row, v) ((row)[(v) / 64] |= std::uint64_t{1} << (v) % 64)
#define FALSE 0

inline void nauty_freedyn() {}
inline void nautil_freedyn() {}
inline void naugraph_freedyn() {}

namespace automorphisms {

struct Search {
  const graph* rows;
  int words;
  int size;
  std::vector<int> color;
  std::vector<int> image;  ///< -1: none yet
  std::vector<bool> taken;

  bool joined(int one, int other) const { return (GRAPHROW(rows, one, words)[other / 64] >> other % 64 & 1) != 0; }

  bool fits(int vertex, int to) const {
    if (taken[static_cast<std::size_t>(to)] ||
        color[static_cast<std::size_t>(vertex)] != color[static_cast<std::size_t>(to)])
      return false;
    for (int other = 0; other < size; ++other)
      if (image[static_cast<std::size_t>(other)] >= 0 &&
          joined(vertex, other) != joined(to, image[static_cast<std::size_t>(other)]))
        return false;
    return true;
  }

  /// Extends the images of the vertices before `vertex` to an automorphism.
  bool complete(int vertex) {
    if (vertex == size) return true;
    if (image[static_cast<std::size_t>(vertex)] >= 0) return complete(vertex + 1);
    for (int to = 0; to < size; ++to) {
      if (!fits(vertex, to)) continue;
      image[static_cast<std::size_t>(vertex)] = to;
      taken[static_cast<std::size_t>(to)] = true;
      if (complete(vertex + 1)) return true;
      image[static_cast<std::size_t>(vertex)] = -1;
      taken[static_cast<std::size_t>(to)] = false;
    }
    return false;
  }
};

}  // namespace automorphisms

inline void densenauty(graph* rows, int* lab, int* ptn, int* /*orbits*/, optionblk* options, statsblk* stats, int words,
                       int size, graph* /*canonical*/) {
  const auto n = static_cast<std::size_t>(size);
  automorphisms::Search search{rows, words, size, std::vector<int>(n), {}, {}};
  for (int i = 0, color = 0; i < size; ++i) {
    search.color[static_cast<std::size_t>(lab[i])] = color;
    if (ptn[i] == 0) ++color;
  }
  std::vector<std::vector<int>> found;  // each fixes the vertices before the one that it was found for
  *stats = {};
  for (int vertex = size; vertex-- > 0;) {
    std::vector<bool> in_orbit(n);
    std::vector<int> orbit;
    const auto grow = [&](int first) {
      if (!in_orbit[static_cast<std::size_t>(first)]) {
        in_orbit[static_cast<std::size_t>(first)] = true;
        orbit.push_back(first);
      }
      for (std::size_t i = 0; i < orbit.size(); ++i)
        for (const auto& map : found) {
          const int to = map[static_cast<std::size_t>(orbit[i])];
          if (in_orbit[static_cast<std::size_t>(to)]) continue;
          in_orbit[static_cast<std::size_t>(to)] = true;
          orbit.push_back(to);
        }
    };
    grow(vertex);
    for (int to = vertex + 1; to < size; ++to) {
      if (in_orbit[static_cast<std::size_t>(to)]) continue;
      search.image.assign(n, -1);
      search.taken.assign(n, false);
      for (int fixed = 0; fixed < vertex; ++fixed) {
        search.image[static_cast<std::size_t>(fixed)] = fixed;
        search.taken[static_cast<std::size_t>(fixed)] = true;
      }
      if (!search.fits(vertex, to)) continue;
      search.image[static_cast<std::size_t>(vertex)] = to;
      search.taken[static_cast<std::size_t>(to)] = true;
      if (!search.complete(vertex + 1)) continue;
      found.push_back(search.image);
      grow(to);
    }
    stats->grpsize1 *= static_cast<double>(orbit.size());
  }
  for (auto& map : found) options->userautomproc(0, map.data(), nullptr, 0, 0, size);
}
