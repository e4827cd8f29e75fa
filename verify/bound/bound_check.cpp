#include "bound/bound_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string_view>
#include <vector>

#include "model/input.hpp"

namespace restrip::verify {
namespace {

/// The mesh edges, each as two arrows, and twice the load of each arrow.
class Arrows {
 public:
  explicit Arrows(const TriangleList& list) : at_(list.vertices), triangles_(list.vertices, 0) {
    for (const auto& corners : list.triangles)
      for (const std::uint32_t v : corners) {
        ++triangles_[v];
        for (const std::uint32_t w : corners)
          if (v != w) at_[v].push_back({w, 0});
      }
    for (auto& leaving : at_) {
      std::sort(leaving.begin(), leaving.end(), [](const Arrow& a, const Arrow& b) { return a.to < b.to; });
      leaving.erase(
          std::unique(leaving.begin(), leaving.end(), [](const Arrow& a, const Arrow& b) { return a.to == b.to; }),
          leaving.end());
    }
  }

  std::uint64_t triangles_of(std::uint32_t v) const { return triangles_[v]; }

  /// Loads all arrows across the border of a set, which is ascending; false when one of them then has more than `most`.
  bool load(const std::vector<std::uint32_t>& set, std::uint64_t outward, std::uint64_t inward, std::uint64_t most) {
    bool fits = true;
    for (const std::uint32_t v : set)
      for (Arrow& arrow : at_[v]) {
        if (std::binary_search(set.begin(), set.end(), arrow.to)) continue;
        auto& other = at_[arrow.to];
        const auto back =
            std::lower_bound(other.begin(), other.end(), v, [](const Arrow& a, std::uint32_t to) { return a.to < to; });
        arrow.twice_the_load += outward;
        back->twice_the_load += inward;
        fits = fits && arrow.twice_the_load <= most && back->twice_the_load <= most;
      }
    return fits;
  }

  /// Components of the vertices that have triangles.
  std::uint64_t components() const {
    std::uint64_t found = 0;
    std::vector<bool> met(at_.size(), false);
    std::vector<std::uint32_t> open;
    for (std::uint32_t start = 0; start < at_.size(); ++start) {
      if (met[start] || at_[start].empty()) continue;
      ++found;
      met[start] = true;
      for (open.assign(1, start); !open.empty();) {
        const std::uint32_t v = open.back();
        open.pop_back();
        for (const Arrow& arrow : at_[v])
          if (!met[arrow.to]) {
            met[arrow.to] = true;
            open.push_back(arrow.to);
          }
      }
    }
    return found;
  }

 private:
  struct Arrow {
    std::uint32_t to;
    std::uint64_t twice_the_load;
  };

  std::vector<std::vector<Arrow>> at_;
  std::vector<std::uint64_t> triangles_;
};

class BoundReader {
 public:
  BoundReader(const std::string& file, const TriangleList& list)
      : file_(file), lines_(file, read_file(file)), list_(list), arrows_(list) {}

  ProvenBound check() {
    lines_.next("\"restrip-bound 1\"");
    lines_.expect_line("restrip-bound 1");
    claim("vertices", list_.vertices, "the mesh has");
    claim("triangles", list_.triangles.size(), "the mesh has");
    lines_.next("\"digest\" and a number");
    lines_.expect_words(2, "\"digest\" and a number");
    const std::string digest = fmt::format("digest {:016x}", digest_of(list_));
    if (lines_.rest(0) != digest)
      refute(fmt::format("the mesh has \"{}\": the certificate is that of another", digest));
    denominator_ = number("denominator", 1, std::numeric_limits<std::uint32_t>::max());
    const std::uint64_t cuts = number("cuts", 0, std::numeric_limits<std::uint32_t>::max());
    for (std::uint64_t i = 0; i < cuts; ++i) read_cut();
    const std::uint64_t arrows = (sum_ + denominator_ - 1) / denominator_;
    claim("arrows", arrows, "the multipliers prove");
    const std::uint64_t components = arrows_.components();
    claim("components", components, "the mesh has");
    const std::uint64_t indices = list_.triangles.size() + arrows + components - 1;
    claim("indices", indices, "triangles, arrows and restarts are");
    lines_.next("\"end\"");
    lines_.expect_line("end");
    if (!lines_.at_end()) lines_.fail("expected nothing behind \"end\"");
    return {cuts, indices};
  }

 private:
  [[noreturn]] void refute(const std::string& why) const {
    throw FalseBound(fmt::format("{}:{}: {}", file_, lines_.line(), why));
  }

  /// The number in a word of the line.
  std::uint64_t number_at(std::size_t word, std::uint64_t least, std::uint64_t most) const {
    const std::int64_t found = lines_.number(word);
    if (found < 0 || static_cast<std::uint64_t>(found) < least || static_cast<std::uint64_t>(found) > most)
      lines_.fail(fmt::format("expected a number from {} to {}, found {}", least, most, found));
    return static_cast<std::uint64_t>(found);
  }

  /// The next line, a word and a number.
  std::uint64_t number(std::string_view word, std::uint64_t least, std::uint64_t most) {
    const std::string expected = fmt::format("\"{}\" and a number", word);
    lines_.next(expected);
    lines_.expect_words(2, expected);
    if (!lines_.starts_with(word)) lines_.fail(fmt::format("expected {}, found \"{}\"", expected, lines_.rest(0)));
    return number_at(1, least, most);
  }

  void claim(std::string_view word, std::uint64_t is, std::string_view found) {
    const std::uint64_t told = number(word, 0, std::numeric_limits<std::int64_t>::max());
    if (told != is) refute(fmt::format("claims {} {}, but {} {}", told, word, found, is));
  }

  void read_cut() {
    const std::string expected = "\"cut\", a multiplier and vertices";
    lines_.next(expected);
    if (lines_.words().size() < 3 || !lines_.starts_with("cut"))
      lines_.fail(fmt::format("expected {}, found \"{}\"", expected, lines_.rest(0)));
    const std::uint64_t multiplier = number_at(1, 1, denominator_);
    set_.clear();
    std::uint64_t triangles = 0;
    for (std::size_t word = 2; word < lines_.words().size(); ++word) {
      const auto v = static_cast<std::uint32_t>(number_at(word, 0, list_.vertices - 1));
      if (!set_.empty() && v <= set_.back()) lines_.fail("expected vertices in ascending order, each once");
      set_.push_back(v);
      triangles += arrows_.triangles_of(v);
    }
    if (triangles % 3 == 0)
      refute(
          fmt::format("the vertices have {} triangles, a multiple of three: nothing need cross the border", triangles));
    // Missing are -triangles modulo 3. An arrow misses 2 where it begins and 1 where it ends.
    const bool one_missing = triangles % 3 == 2;
    if (!arrows_.load(set_, one_missing ? multiplier : 2 * multiplier, one_missing ? 2 * multiplier : multiplier,
                      2 * denominator_))
      refute("an arrow across the border is loaded by more than the denominator");
    sum_ += multiplier;
  }

  std::string file_;
  LineReader lines_;
  const TriangleList& list_;
  Arrows arrows_;
  std::uint64_t denominator_ = 1;
  std::uint64_t sum_ = 0;
  std::vector<std::uint32_t> set_;
};

}  // namespace

ProvenBound check_bound(const std::string& certificate, const TriangleList& list) {
  return BoundReader(certificate, list).check();
}

}  // namespace restrip::verify
