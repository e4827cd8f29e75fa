// Strips written in one form or another.
//
// Outline. The indices are first divided into strips: at restarts, and where several degenerate triangles in a row
// stitch two strips. Then each strip is written in the form wanted, whole, or cut where a batch ends. To wind its first
// triangle the other way a strip of odd length is written from its end, two indices of a strip of four are exchanged,
// or one index is repeated. In the stitched form a strip of odd length waits for the next such strip, so that no index
// is spent on parity.
//
// Cost: linear; 8 bytes a vertex if a batch has a limit of vertices.
#include "restrip/output/strip_format.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "restrip/precondition.hpp"

namespace restrip {
namespace {

class StripFormatter {
 public:
  StripFormatter(std::span<const std::uint32_t> text, const StripFormat& format) : text_(text), format_(format) {
    if ((format.most_vertices != 0 && format.most_vertices < 3) ||
        (format.most_indices != 0 && format.most_indices < 4))
      RESTRIP_THROW(std::invalid_argument, "restrip: a batch has at least 3 vertices and 4 indices");
    // One repeated index within a strip, a swap, draws one degenerate triangle. Several in a row stitch strips.
    for (std::size_t begin = 0; begin < text_.size();) {
      const auto end = static_cast<std::size_t>(
          std::find(text_.begin() + static_cast<std::ptrdiff_t>(begin), text_.end(), restart) - text_.begin());
      for (std::size_t i = begin; i + 2 < end;) {
        if (degenerate(i)) {
          ++i;
          continue;
        }
        const std::size_t first = i;
        std::size_t last = i;
        for (; i + 2 < end && i - last <= 2; ++i) {
          if (degenerate(i)) continue;
          last = i;
          ++triangles_;
        }
        strips_.push_back({first, last + 3 - first, (first - begin) % 2 != 0});
        for (std::size_t j = first; j < last + 3; ++j) highest_ = (std::max)(highest_, text_[j]);
      }
      begin = end + 1;
    }
  }

  IndexBuffer run() {
    write(format_.form);
    const std::size_t of_list = 3 * triangles_;
    if (format_.list_if_shorter && out_.size() > of_list) write(StripForm::list);
    IndexBuffer buffer{form_, {}, std::move(lengths_), std::move(batches_), triangles_, strips_.size()};
    const bool narrow = highest_ <= highest_index16;
    if (format_.width == IndexWidth::bits16 && !narrow)
      RESTRIP_THROW(std::length_error, "restrip: a vertex does not fit into indices of 16 bits");
    if (narrow && format_.width != IndexWidth::bits32)
      // The restart index becomes the one of 16 bits.
      buffer.indices.emplace<1>(out_.begin(), out_.end());
    else
      buffer.indices = std::move(out_);
    return buffer;
  }

 private:
  static constexpr std::uint32_t restart = 0xFFFF'FFFFU;

  // A strip in text_.
  struct Strip {
    std::size_t first;
    std::size_t count;
    bool odd;  // its first triangle is wound like the second one of a strip
  };

  [[nodiscard]] bool degenerate(std::size_t i) const noexcept {
    return text_[i] == text_[i + 1] || text_[i + 1] == text_[i + 2] || text_[i + 2] == text_[i];
  }

  void write(StripForm form) {
    form_ = form;
    out_.clear();
    lengths_.clear();
    batches_.clear();
    first_ = 0;
    ++batch_;
    in_batch_ = 0;
    const bool limited = format_.most_vertices != 0 || format_.most_indices != 0;
    if (format_.most_vertices != 0) batch_of_.assign(std::size_t{highest_} + 1, 0);
    out_.reserve(text_.size() + (form == StripForm::stitched ? strips_.size() : 0));
    if (form == StripForm::list) {
      for (const Strip& strip : strips_)
        for (std::size_t i = strip.first; i + 2 < strip.first + strip.count; ++i)
          if (!degenerate(i)) put_cut({i, 3, strip.odd != ((i - strip.first) % 2 != 0)});
    } else if (limited) {
      for (const Strip& strip : strips_) put_cut(strip);
    } else {
      const Strip* waits = nullptr;
      for (const Strip& strip : strips_) {
        if (form == StripForm::stitched && strip.count % 2 != 0 && waits == nullptr) {
          waits = &strip;
          continue;
        }
        if (strip.count % 2 != 0 && waits != nullptr) put(*std::exchange(waits, nullptr));
        put(strip);
      }
      if (waits != nullptr) put(*waits);
    }
    end_batch();
  }

  void put(const Strip& strip) {
    const bool begins = out_.size() == first_;
    if (form_ == StripForm::list) {
      const std::uint32_t* triangle = text_.data() + strip.first;
      out_.insert(out_.end(), {triangle[strip.odd ? 1 : 0], triangle[strip.odd ? 0 : 1], triangle[2]});
      return;
    }
    if (form_ == StripForm::restart && !begins) out_.push_back(restart);
    const bool odd = form_ == StripForm::stitched && (out_.size() - first_) % 2 != 0;
    const auto text = text_.subspan(strip.first, strip.count);
    // To wind its first triangle the other way, a strip is written from its end, two indices are exchanged, or one is
    // repeated.
    const bool turns = strip.odd != odd;
    const bool backwards = turns && strip.count % 2 != 0;
    const std::uint32_t front = backwards ? text.back() : text.front();
    if (form_ == StripForm::stitched && !begins && out_.back() != front) out_.insert(out_.end(), {out_.back(), front});
    const std::size_t before = out_.size();
    if (turns && !backwards && strip.count != 4) out_.push_back(front);
    if (backwards)
      out_.insert(out_.end(), text.rbegin(), text.rend());
    else
      out_.insert(out_.end(), text.begin(), text.end());
    if (turns && strip.count == 4) std::swap(out_[before + 1], out_[before + 2]);
    if (form_ == StripForm::lengths) lengths_.push_back(static_cast<std::uint32_t>(out_.size() - before));
  }

  // Writes the part of the strip that fits into the batch, and the rest into the next batches.
  void put_cut(Strip strip) {
    while (strip.count != 0) {
      std::size_t taken = fitting(strip);
      while (taken >= 3 && degenerate(strip.first + taken - 3)) --taken;
      if (taken < 3) {
        end_batch();
        continue;
      }
      put({strip.first, taken, strip.odd});
      if (taken == strip.count) return;
      std::size_t skipped = taken - 2;
      while (degenerate(strip.first + skipped)) ++skipped;
      strip = {strip.first + skipped, strip.count - skipped, strip.odd != (skipped % 2 != 0)};
    }
  }

  [[nodiscard]] std::size_t fitting(const Strip& strip) {
    const std::size_t used = out_.size() - first_;
    // The most additional indices: those that lead to the strip, and one for parity.
    std::size_t extra = form_ == StripForm::list ? 0 : 1;
    if (used != 0 && form_ == StripForm::restart) extra += 1;
    if (used != 0 && form_ == StripForm::stitched) extra += 2;
    const std::size_t most = format_.most_indices == 0 ? strip.count
                             : format_.most_indices > used + extra
                                 ? (std::min)(strip.count, format_.most_indices - used - extra)
                                 : 0;
    for (std::size_t i = 0; i < most && format_.most_vertices != 0; ++i) {
      std::size_t& batch = batch_of_[text_[strip.first + i]];
      if (batch == batch_) continue;
      if (in_batch_ == format_.most_vertices) return i;
      batch = batch_;
      ++in_batch_;
    }
    return most;
  }

  void end_batch() {
    if (out_.size() != first_) batches_.push_back({first_, out_.size() - first_});
    first_ = out_.size();
    ++batch_;
    in_batch_ = 0;
  }

  std::span<const std::uint32_t> text_;
  StripFormat format_;
  std::vector<Strip> strips_;
  std::size_t triangles_ = 0;
  std::uint32_t highest_ = 0;
  StripForm form_ = StripForm::restart;  // that is being written
  std::vector<std::uint32_t> out_;
  std::vector<std::uint32_t> lengths_;
  std::vector<IndexRange> batches_;
  std::size_t first_ = 0;  // of the batch
  std::size_t batch_ = 0;
  std::size_t in_batch_ = 0;           // different vertices
  std::vector<std::size_t> batch_of_;  // by vertex: the last batch that has it
};

}  // namespace

IndexBuffer format_strips(std::span<const std::uint32_t> indices, const StripFormat& format) {
  return StripFormatter(indices, format).run();
}

}  // namespace restrip
