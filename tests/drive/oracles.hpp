// What is checked while a LiveMesh is driven: each oracle looks at the subject before and after every call, and throws
// std::logic_error when it is not as promised. None shares code with what it checks.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "drive/subject.hpp"
#include "restrip/operations/result.hpp"
#include "runtime/triangle_list.hpp"

namespace restrip::drive {

class Oracle {
 public:
  virtual ~Oracle() = default;
  virtual void begin(Subject& subject) = 0;
  virtual void before(const Step& /*step*/, Subject& /*subject*/) {}
  virtual void after(const Step& step, const Outcome& outcome, Subject& subject) = 0;
};

/// A caller who trusts only what is promised: it keeps a buffer on a device by the ranges of updates, makes a new one
/// only when an update reports that it was outgrown, and draws it with a decoder of its own. The device has the bytes
/// of the subject and draws the triangles of the mesh, each once with its winding; ranges are as the options ask; no
/// alarm is false.
class Device : public Oracle {
 public:
  void begin(Subject& subject) override;
  void after(const Step& step, const Outcome& outcome, Subject& subject) override;
  [[nodiscard]] std::size_t outgrown() const noexcept { return outgrown_; }

 private:
  void make(const BufferView& view);
  void check_ranges(const Upload& upload, const RangeOptions& options, const BufferView& view) const;
  std::vector<std::byte> bytes_;
  std::size_t width_ = 0;
  std::size_t room_ = 0;
  std::size_t outgrown_ = 0;
};

/// Undo and redo lead to the looks of the frames before and after, by the numbers of frames; refused operations change
/// nothing.
class FrameLooks : public Oracle {
 public:
  explicit FrameLooks(bool has_history) : has_history_(has_history) {}
  void begin(Subject& subject) override;
  void before(const Step& step, Subject& subject) override;
  void after(const Step& step, const Outcome& outcome, Subject& subject) override;

 private:
  using Look = std::vector<std::uint32_t>;
  void forget() { looks_.clear(), lost_ = true; }
  void begin_again(Subject& subject);
  void note_frame(std::size_t frame, const Look& look);
  void end_frame(Subject& subject);
  void move(bool forward, bool moved, Subject& subject);
  bool differs(const Look& look) const { return looks_.contains(at_) && look != looks_.at(at_); }

  bool has_history_;
  std::map<std::size_t, Look> looks_;  // by the numbers of frames
  std::size_t at_ = 0;
  bool lost_ = false;     // the number of the frame may be any
  bool changed_ = false;  // perhaps, since the last frame ended
  Look before_;
};

/// Adjacency by its definition, valid colours; strips, swaps and isolated triangles by a count of the whole mesh, and
/// the results of calls as differences of these counts; the locator of strips.
class Counts : public Oracle {
 public:
  void begin(Subject& subject) override;
  void after(const Step& step, const Outcome& outcome, Subject& subject) override;

 private:
  struct Census {
    std::size_t strips = 0;
    std::size_t isolated = 0;
    std::size_t swaps = 0;
    [[nodiscard]] std::size_t cost(const Cost& cost) const noexcept {
      return cost.restart * strips + cost.swap * swaps + cost.isolated * isolated;
    }
  };
  static Census count(const LiveMesh& live);
  Census last_;
};

/// An operation adds at most one strip, or six indices; closed fans isolate no triangle; each operation asks one rule.
class Bounds : public Oracle {
 public:
  void begin(Subject& /*subject*/) override {}
  void before(const Step& step, Subject& subject) override;
  void after(const Step& step, const Outcome& outcome, Subject& subject) override;
  /// The operations that were looked at, by their rules.
  [[nodiscard]] const RuleCounts& sum() const noexcept { return sum_; }

 private:
  bool applies_ = false;
  bool closed_fan_ = false;
  std::size_t cost_ = 0;
  RuleCounts rules_;
  RuleCounts sum_;
};

/// The functions of a StripMesh (operations.hpp, refine.hpp, apply.hpp) do the same: under the policy `rules` with the
/// same colours, under all with the same triangles and refusals.
class FreeFunctions : public Oracle {
 public:
  void begin(Subject& /*subject*/) override {}
  void before(const Step& step, Subject& subject) override;
  void after(const Step& step, const Outcome& outcome, Subject& subject) override;

 private:
  bool applies_ = false;
  StripMesh mesh_;
  Checked done_;
};

/// Another mesh, a bare list of triangles, to which the same is done: operations are granted exactly if they leave the
/// list a manifold, and then both have the same triangles. Decides only on lists of at most `most` triangles, which
/// takes quadratic time, and on meshes that are manifolds.
class Mirror : public Oracle {
 public:
  explicit Mirror(std::size_t most) : most_(most) {}
  void begin(Subject& subject) override;
  void before(const Step& step, Subject& subject) override;
  void after(const Step& step, const Outcome& outcome, Subject& subject) override;
  [[nodiscard]] std::size_t judged() const noexcept { return judged_; }

 private:
  std::optional<bare::List> wanted(const Step& step, const StripMesh& mesh) const;
  std::size_t most_;
  bool manifold_ = true;
  bool judges_ = false;
  bare::List list_;
  bare::Shape shape_;
  std::optional<bare::List> wanted_;
  std::size_t judged_ = 0;
};

/// Packed meshes have the lowest numbers, in order, with the same colours; saved ones load with everything that is
/// saved.
class Numbers : public Oracle {
 public:
  void begin(Subject& /*subject*/) override {}
  void before(const Step& step, Subject& subject) override;
  void after(const Step& step, const Outcome& outcome, Subject& subject) override;

 private:
  StripMesh mesh_;
  std::vector<std::uint32_t> settings_;
  std::vector<std::byte> saved_;
};

/// A second subject to which the same calls are made has the same results, triangles, neighbours and colours.
class Twin : public Oracle {
 public:
  explicit Twin(Subject& other) : other_(other) {}
  void begin(Subject& subject) override;
  void after(const Step& step, const Outcome& outcome, Subject& subject) override;

 private:
  Subject& other_;
};

/// All oracles that look at one LiveMesh; those that judge by lists do so up to `most_judged` triangles.
struct Oracles {
  explicit Oracles(std::size_t history, std::size_t most_judged = 60) : looks(history != 0), mirror(most_judged) {}
  [[nodiscard]] std::array<Oracle*, 7> all() {
    return {&device, &looks, &counts, &bounds, &functions, &mirror, &numbers};
  }
  Device device;
  FrameLooks looks;
  Counts counts;
  Bounds bounds;
  FreeFunctions functions;
  Mirror mirror;
  Numbers numbers;
};

}  // namespace restrip::drive
