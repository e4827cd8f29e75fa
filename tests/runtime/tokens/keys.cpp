// Keys and validity: on words and on bit strings, by the general formulas and by those written out, in every patch.
#include "judge.hpp"
#include "restrip/rules/key.hpp"
#include "restrip/rules/rules.hpp"

namespace {

using namespace restrip;
using judge::Digest;
using judge::some_bits;

void tell(Digest& told, const detail::InnerPairs& pairs) { told.add(pairs.joined, pairs.over_chord, pairs.count()); }

void layout(Digest& told, const detail::Layout& patch) {
  told.add(patch.k, patch.inserted, patch.opposite, patch.ring, patch.has_chord(), patch.size(), patch.edges(),
           patch.chord(), patch.colors());
  for (std::size_t port = 0; port < patch.k; ++port) told.add(patch.element(port));
  for (std::size_t e = 0; e < patch.size(); ++e) {
    told.add(patch.is_fan(e));
    if (patch.is_fan(e)) told.add(patch.port(e));
  }
}

/// A patch asked about these colours, by the general formulas.
void patch_of(Digest& told, const detail::Layout& patch, Word colors, Word ports) {
  const bool valid = detail::valid(patch, colors, ports);
  const detail::Walker walker{patch, BitSpan::of(colors), BitSpan::of(ports)};
  told.add(valid, walker.valid());
  if (((colors >> patch.colors()) | (ports >> patch.k)) != 0) return;
  told.add(patch.spread(ports), patch.gather(patch.spread(ports)));
  told.add(detail::isolated(patch, colors, ports), detail::isolated(patch, walker.inner, walker.ports));
  Word joined = ~Word{0};
  walker.joined(MutableBitSpan::of(joined));
  tell(told, detail::inner_pairs(patch, colors, ports));
  told.add(joined);
}

/// Each function of the headers.
void asked(Digest& told, std::size_t k, Word colors, Word ports) {
  const BitSpan c = BitSpan::of(colors);
  const BitSpan p = BitSpan::of(ports);
  Word joined = 0;
  const MutableBitSpan to = MutableBitSpan::of(joined);
  if (k > 2) {
    told.add(valid_closed(k, colors, ports), valid_closed(k, c, p));
    joined_closed(k, c, p, to);
    told.add(joined, joined_closed(k, colors & low_bits(k), ports & low_bits(k)));
    told.add(canonical_joined(ports, joined), detail::isolated_closed(k, colors, ports),
             detail::ends_closed(k, colors, ports));
  }
  patch_of(told, detail::closed_fan(k), colors, ports);
  patch_of(told, detail::open_fan(k), colors, ports);
  joined_open(k, c, p, to);
  told.add(valid_open(k, colors, ports), valid_open(k, c, p), joined, joined_open(k, colors, ports));
  judge::each_position(
      k,
      [&](std::size_t a) {
        patch_of(told, detail::ring_with_chord(k, a), colors, ports);
        joined_ring(k, a, c, p, to);
        told.add(valid_ring(k, a, colors, ports), valid_ring(k, a, c, p), joined, joined_ring(k, a, colors, ports));
        tell(told, detail::ring_pairs(k, a, colors, ports));
        told.add(ring_ports(a, ports), detail::isolated_ring(k, a, colors, ports),
                 detail::ends_ring(k, a, colors, ports));
      },
      [&](std::size_t i, std::size_t j) {
        if (k > 12 && (i + j) % 7 != 0 && i + 1 != j && j != k) return;
        patch_of(told, detail::path_with_chord(k, i, j), colors, ports);
        joined_path_with_chord(k, i, j, c, p, to);
        told.add(valid_path_with_chord(k, i, j, colors, ports), valid_path_with_chord(k, i, j, c, p), joined,
                 joined_path_with_chord(k, i, j, colors, ports));
      },
      [&](std::size_t i) {
        patch_of(told, detail::path(k, i), colors, ports);
        joined_path(k, i, c, p, to);
        told.add(valid_path(k, i, colors, ports), valid_path(k, i, c, p), joined, joined_path(k, i, colors, ports));
      });
}

void layouts() {
  Digest told("layouts");
  for (const std::size_t k : judge::Sizes{1, 2, 3, 5, 61, 64, 130}) {
    layout(told, detail::closed_fan(k));
    layout(told, detail::open_fan(k));
    for (std::size_t i = 0; i <= k; i += i / 4 + 1) {
      layout(told, detail::path(k, i));
      if (0 < i && i < k) layout(told, detail::ring_with_chord(k, i));
      for (std::size_t j = i + 1; j <= k; j += j / 4 + 1) layout(told, detail::path_with_chord(k, i, j));
    }
  }
}

/// All colours of small fans, with a bit too many; some of large ones.
void words() {
  for (std::size_t k = 1; k <= 3; ++k) {
    Digest told("keys", k);
    for (Word colors = 0; colors < bit(k + 4); ++colors)
      for (Word ports = 0; ports < bit(k + 1); ++ports) asked(told, k, colors, ports);
  }
  for (const std::size_t k : judge::Sizes{4, 5, 8, 12, 30, 59, 60, 61}) {
    Digest told("keys", k);
    for (std::size_t n = 0; n < (k < 6 ? 1000 : k < 13 ? 300 : 12); ++n) {
      asked(told, k, some_bits(k + 4 - n % 4), some_bits(k + (n % 8 == 0 ? 1 : 0)));
      asked(told, k, some_bits(k + 3 - n % 4) & some_bits(k), some_bits(k) & some_bits(k));
    }
  }
}

void strings() {
  for (const std::size_t k : judge::Sizes{1, 2, 3, 61, 62, 63, 64, 65, 126, 127, 128, 130}) {
    Digest told("strings", k);
    for (int n = 0; n < 60; ++n) {
      for (const detail::Layout& patch :
           {detail::closed_fan(k), detail::open_fan(k), detail::ring_with_chord(k + 1, (k + 1) / 2),
            detail::ring_with_chord(k + 1, k), detail::path_with_chord(k, k / 3, k),
            detail::path_with_chord(k, 0, (k + 1) / 2), detail::path(k, k / 3)}) {
        const judge::SomeBits colors(patch.colors());
        const judge::SomeBits ports(patch.k);
        const judge::Bits joined(patch.k, ~Word{0});
        const detail::Walker walker{patch, colors.read(), ports.read()};
        walker.joined(joined.write());
        joined.tell(told);
        told.add(walker.valid(), detail::isolated(patch, walker.inner, walker.ports));
      }
    }
  }
}

/// What members hold of which nothing is said.
void defaults() {
  Digest told("defaults");
  const detail::Layout patch;
  told.add(patch.k, patch.inserted, patch.opposite, patch.ring);
  tell(told, {});
}

}  // namespace

int main(int argc, char** argv) { return judge::run(argc, argv, {defaults, layouts, words, strings}); }
