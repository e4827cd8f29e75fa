// Masks and bit strings, at all sizes about those of a word.
#include "judge.hpp"

namespace {

using namespace restrip;
using judge::numbers;

void masks() {
  judge::Digest told("masks");
  for (std::size_t n = 0; n <= 130; ++n) {
    const Word mask = numbers();
    const Word other = numbers() >> (n % 64);
    told.add(bit(n), low_bits(n), words_for(n), has(mask, n), insert_zero(mask, n), remove_bit(mask, n));
    told.add(count_bits(mask), count_difference(mask, other), count_difference(mask >> 32, other & 0xffffffffU),
             count_difference(other & 0xffffffffU, mask >> 32));
    told.add(count_bits(low_bits(n)), count_bits(bit(n)), count_difference(bit(n), other & 1),
             count_difference(0, bit(n)));
    told.add(nowhere > n);
  }
}

void strings() {
  judge::Digest told("strings");
  const Word one_word = 0x8000000000000001U;
  told.add(BitSpan::of(one_word).words == &one_word, BitSpan{}.words == nullptr, MutableBitSpan{}.words == nullptr);
  for (std::size_t n = 0; n <= 194; ++n) {
    const judge::SomeBits words(n);
    const BitSpan bits = words.read();
    for (std::size_t i = 0; i < n; ++i) told.add(bits[i]);
    for (std::size_t to = 0; to <= n; ++to)
      for (std::size_t from = 0; from <= to; from += from / 3 + 1) told.add(bits.first_set(from, to));
    told.add(bits.first_set(n, n));
    const judge::Bits written(n, ~Word{0});
    const MutableBitSpan to = written.write();
    to.clear(n);
    written.tell(told);
    for (std::size_t i = n / 3; i < n; i += 5) to.set(i);
    written.tell(told);
    Word word = 0;
    MutableBitSpan::of(word).set(n % 64);
    told.add(word, static_cast<BitSpan>(MutableBitSpan::of(word)).words == &word);
  }
}

}  // namespace

int main(int argc, char** argv) { return judge::run(argc, argv, {masks, strings}); }
