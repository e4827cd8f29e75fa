// A LiveMesh driven by bytes: which mesh, policy, cost, format and history, then operations, updates, undo, redo and
// allocations that fail.
//
// The program here is a caller who trusts only what is promised. It keeps a device buffer by the ranges that updates
// return, makes a new one only when an update reports that it was outgrown, and draws it with a decoder of its own. The
// claims, after every update: the device holds the bytes of the LiveMesh and draws the triangles of the mesh, each once
// with its winding; ranges are as the options ask; no alarm is false. After every undo and redo: triangles, handles and
// colours are those of that frame. Packing keeps the triangles. At the end all frames are undone and redone, and the
// mesh is saved and loaded.
#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <new>
#include <optional>
#include <stdexcept>

#include "restrip/live_mesh.hpp"
#include "restrip/output/live_buffer.hpp"
#include "restrip/search/policy.hpp"
#include "runtime/form_reader.hpp"
#include "support/failing_new.hpp"
#include "support/random_operations.hpp"
#include "target.hpp"

namespace restrip::fuzz {
namespace {

using Halfedge = LiveMesh::Halfedge;
using sample::Corners;

/// The bytes of the input one after the other, then zeros.
class Input {
 public:
  explicit Input(std::string_view bytes) : bytes_(bytes) {}
  [[nodiscard]] bool over() const noexcept { return bytes_.empty(); }
  std::uint32_t byte() noexcept {
    if (over()) return 0;
    const auto value = static_cast<unsigned char>(bytes_.front());
    bytes_.remove_prefix(1);
    return value;
  }
  std::uint32_t word() noexcept {
    const std::uint32_t low = byte();
    return low | byte() << 8;
  }
  template <class Value, std::size_t N>
  Value one_of(const std::array<Value, N>& values) noexcept {
    return values[byte() % N];
  }

 private:
  std::string_view bytes_;
};

// ---- what is drawn

/// The buffer on the device: written only by uploads, made again only when it is outgrown.
struct Device {
  std::vector<std::byte> bytes;
  std::size_t width = 0;  ///< bytes of an index
  std::size_t room = 0;   ///< in indices

  void make(const LiveMesh& live) {
    width = live.index_bytes();
    room = live.room();
    bytes.assign(room * width, std::byte{0xA5});
  }
  [[nodiscard]] std::uint32_t index(std::size_t i) const {
    std::uint16_t narrow = 0;
    std::uint32_t wide = 0;
    if (width == 4) {
      std::memcpy(&wide, bytes.data() + 4 * i, 4);
      return wide;
    }
    std::memcpy(&narrow, bytes.data() + 2 * i, 2);
    return narrow;
  }
  [[nodiscard]] std::vector<Corners> drawn(StripForm form, std::span<const IndexRange> draws) const {
    const std::uint32_t restart = width == 4 ? 0xFFFFFFFF : 0xFFFF;
    form_reader::Reader reader(bytes, width);
    for (const auto& [first, count] : draws) {
      promise(count <= room && first <= room - count, "draws lie within the buffer");
      for (std::size_t i = first; form != StripForm::restart && i < first + count; ++i)
        promise(index(i) != restart, "only the form with restarts has the restart index");
      if (form == StripForm::list)
        reader.list(first, count);
      else
        reader.strip(first, count, form == StripForm::restart);
    }
    return std::move(reader).triangles();
  }
};

// ---- what the mesh is

std::vector<Corners> triangles_of(const StripMesh& mesh) {
  std::vector<Corners> triangles = sample::triangles_of(mesh);
  promise(triangles.size() == mesh.triangle_count(), "triangles are counted");
  return triangles;
}

/// Triangles by number with their corners, neighbours and colours, and the first spokes of the vertices.
using State = std::vector<std::uint32_t>;
State state_of(const StripMesh& mesh) {
  State state{static_cast<std::uint32_t>(mesh.triangle_bound()), static_cast<std::uint32_t>(mesh.vertex_bound())};
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    state.push_back(mesh.has_triangle(t) ? 1 : 0);
    for (unsigned side = 0; mesh.has_triangle(t) && side < 3; ++side) {
      const Halfedge h = StripMesh::halfedge(t, side);
      promise(mesh.solid(h) == mesh.solid(mesh.opposite(h)), "both sides of an edge have one colour");
      state.insert(state.end(), {mesh.from(h), mesh.opposite(h).id, mesh.solid(h) ? 1U : 0U});
    }
    promise(!mesh.has_triangle(t) || mesh.solid_degree(t) <= 2, "strips do not branch");
  }
  for (Vertex v = 0; v < mesh.vertex_bound(); ++v)
    if (mesh.spoke(v) != Halfedge{}) state.insert(state.end(), {v, mesh.spoke(v).id});
  return state;
}

/// The same without first spokes, which depend on how the mesh was made.
State colored(const StripMesh& mesh) {
  State state = state_of(mesh);
  for (Vertex v = 0; v < mesh.vertex_bound(); ++v)
    if (mesh.spoke(v) != Halfedge{}) state.resize(state.size() - 2);
  return state;
}

/// Whether 16 bits can name every vertex of a triangle.
bool fits_16_bits(const StripMesh& mesh) {
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.has_triangle(t))
      for (const Vertex v : mesh.corners(t))
        if (v > highest_index16) return false;
  return true;
}

// ---- the caller

class Caller {
 public:
  Caller(Input& input, std::span<const Corners> triangles, std::size_t vertices, const LiveOptions& options)
      : input_(input), options_(options), live_(triangles, vertices, options) {
    device_.make(live_);
    std::copy(live_.bytes().begin(), live_.bytes().end(), device_.bytes.begin());
    compare();
    frames_.push_back(state_of(mesh()));
  }

  void run() {
    constexpr int most_steps = 400;
    constexpr std::size_t most_triangles = 1500;
    for (int step = 0; step < most_steps && !input_.over() && mesh().triangle_bound() < most_triangles; ++step) {
      constexpr std::uint32_t operations = sum_of_shares(all_operations);
      const std::uint32_t choice = input_.byte() % (operations + attentions.size());
      if (choice < operations)
        operate(kind_at(all_operations, choice));
      else
        attend(attentions[choice - operations]);
    }
    memory_fails_ = 0;
    update();
    while (move(false)) update();
    while (move(true)) update();
    promise_saved();
  }

 private:
  [[nodiscard]] const StripMesh& mesh() const noexcept { return live_.mesh(); }

  /// Any side of any triangle number, or a number that names no side.
  Halfedge side() noexcept {
    const std::uint32_t number = input_.word();
    const std::size_t bound = mesh().triangle_bound();
    const std::uint32_t kind = number >> 13;
    if (bound == 0 || kind == 7) return {number * 0x9E3779B1U};
    const Halfedge h = StripMesh::halfedge(static_cast<Triangle>(number % bound), (number >> 8) % 3);
    if (kind == 5) return StripMesh::across_boundary(h);
    return kind == 6 && mesh().alive(h) ? mesh().opposite(h) : h;
  }
  /// Another spoke of the vertex that h leaves, some turns away, or any.
  Halfedge other_spoke(Halfedge h, std::uint32_t turns) noexcept {
    if (turns == 7) return side();
    for (; turns > 0 && mesh().alive(h) && !StripMesh::on_boundary(h); --turns)
      h = mesh().opposite(mesh().next(mesh().next(h)));
    return h;
  }
  VertexSplit place_of_split() noexcept {
    using Spokes = VertexSplit::Spokes;
    const Halfedge left = side();
    const std::uint32_t how = input_.byte();
    constexpr std::array spokes{Spokes::both,      Spokes::both, Spokes::both, Spokes::both,
                                Spokes::left_only, Spokes::both, Spokes::both, Spokes::right_only};
    return {left, other_spoke(left, how & 7U), spokes[how >> 5]};
  }
  Vertex new_vertex() noexcept {
    const auto next = static_cast<Vertex>(mesh().vertex_bound());
    return input_.one_of(std::array<Vertex, 16>{none, none, none, none, none, none, none, 0, 7, next, next + 1, 65'534,
                                                65'535, 65'536, 70'000, none - 1});
  }

  /// Calls work(), perhaps with an allocation that fails. False if it failed.
  template <class Work>
  bool done(Work&& work) {
    const std::uint32_t failing = std::exchange(memory_fails_, 0);
    if (failing != 0)
      testing_support::fail_allocation(
          failing / 2, failing % 2 == 0 ? testing_support::Shortage::once : testing_support::Shortage::for_good);
    try {
      work();
      testing_support::end_shortage();
      return true;
    } catch (const std::bad_alloc&) {
      promise(testing_support::end_shortage(), "memory runs out only if an allocation fails");
    } catch (const std::length_error&) {
      testing_support::end_shortage();
      promise(options_.format.width == IndexWidth::bits16 && !fits_16_bits(mesh()),
              "16 bits are refused only if a vertex needs more");
    } catch (...) {
      testing_support::end_shortage();
      throw;
    }
    return false;
  }

  void operate(OperationKind kind) {
    const bool splits = kind == OperationKind::split;
    const DrawnOperation drawn{kind, splits ? Halfedge{} : side(), splits ? place_of_split() : VertexSplit{}};
    const Vertex name = splits ? new_vertex() : none;
    Checked result;
    const bool returned = done([&] { result = perform(live_, drawn, name); });
    promise(!returned || !result || mesh().alive(result.rewrite.halfedge), "an operation returns an edge of the mesh");
    changed_ |= !returned || result.granted();
  }

  /// What a caller does between operations, some of it more often.
  enum class Attention : std::uint8_t {
    improve,
    exhaust_memory,
    update,
    update_with_options,
    undo,
    redo,
    move,
    recolor,
    keep,
    pack
  };
  static constexpr std::array attentions{Attention::improve,
                                         Attention::exhaust_memory,
                                         Attention::update,
                                         Attention::update,
                                         Attention::update_with_options,
                                         Attention::undo,
                                         Attention::redo,
                                         Attention::move,
                                         Attention::recolor,
                                         Attention::keep,
                                         Attention::pack};
  void attend(Attention choice) {
    if (choice == Attention::improve) {
      const std::uint32_t budget = 1 + 16 * input_.byte();
      changed_ = true;
      done([&] { live_.improve(budget); });
    }
    if (choice == Attention::exhaust_memory) {
      const std::uint32_t failing = input_.byte();
      memory_fails_ = 2 + failing;
    }
    if (choice == Attention::update) update();
    if (choice == Attention::update_with_options) update_with_options();
    if ((choice == Attention::undo && move(false)) || (choice == Attention::redo && move(true)))
      if (input_.byte() % 4 != 0) update();
    if (choice == Attention::move) move(input_.byte() % 2 == 0);
    if (choice == Attention::pack) pack();
    const Cost cost = input_.one_of(std::array{Cost::indices(), Cost::strips()});
    if (choice == Attention::recolor) {
      changed_ = true;
      done([&] { live_.recolor(Effort::fast, cost); });
    }
    if (choice == Attention::keep) {
      const Policy policy = policies[input_.byte() % (policies.size() - 1)].policy;  // the best takes too long
      done([&] { live_.keep(policy, cost); });
    }
  }

  void pack() {
    const std::vector<Corners> before = triangles_of(mesh());
    Renumbering numbers;
    if (!done([&] { numbers = live_.pack(); })) return lose_track();
    promise(live_.undoable() + live_.redoable() == 0, "packing begins the history again");
    lose_track();
    frames_.push_back(state_of(mesh()));
    changed_ = any_before_ = any_after_ = false;
    std::vector<Corners> after;
    for (Corners corners : before) {
      for (Vertex& v : corners) v = numbers.vertices[v];
      after.push_back(corners);
    }
    promise(mesh().triangle_bound() == after.size(), "packed triangles have the lowest numbers");
    promise(sample::triangles_of(mesh()).size() == after.size(), "packing keeps the triangles");
    for (Corners& corners : after)
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    std::sort(after.begin(), after.end());
    promise(triangles_of(mesh()) == after, "packed triangles are those of before");
  }
  void promise_saved() const {
    if (options_.format.width == IndexWidth::bits16 && !fits_16_bits(mesh())) return;
    const LiveMesh loaded = LiveMesh::load(live_.save());
    promise(colored(loaded.mesh()) == colored(mesh()), "every saved mesh loads as the same mesh");
  }

  void update_with_options() {
    constexpr std::size_t most = std::numeric_limits<std::size_t>::max();
    RangeOptions options;
    options.merge_gap = input_.one_of(
        std::array{std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{30}, most / 2, most - 39, most});
    options.align = input_.one_of(std::array{std::size_t{2}, std::size_t{4}, std::size_t{8}, std::size_t{12},
                                             std::size_t{256}, most / 2 + 1, most - 3});
    update(options);
  }

  void update(const RangeOptions& options = {}) {
    Upload upload;
    if (!done([&] { upload = live_.update(options); })) return lose_track();
    check_ranges(upload, options);
    if (upload.outgrown) device_.make(live_);
    for (const auto& [first, count] : upload)
      std::copy_n(live_.bytes().data() + first * device_.width, count * device_.width,
                  device_.bytes.data() + first * device_.width);
    compare();
    note_frame();
  }
  void check_ranges(const Upload& upload, const RangeOptions& options) const {
    const std::size_t width = live_.index_bytes();
    const std::size_t size = live_.bytes().size() / width;
    promise(size <= live_.room(), "a buffer fits into its room");
    if (upload.outgrown)
      promise(width != device_.width || live_.room() > device_.room, "no alarm is false");
    else
      promise(width == device_.width && size <= device_.room, "an outgrown buffer is reported");
    if (upload.outgrown && size != 0)
      promise(upload.size() == 1 && upload[0] == IndexRange{0, size}, "everything is uploaded to a new buffer");
    std::size_t end = 0;
    for (const auto& [first, count] : upload) {
      promise(count != 0 && count <= size && first <= size - count, "ranges lie within the buffer");
      promise(end == 0 || (first > end && first - end > options.merge_gap), "ranges ascend, and close ones are joined");
      end = first + count;
      promise(first * width % options.align == 0, "ranges begin at multiples of the alignment");
      promise(end * width % options.align == 0 || end == size, "ranges end at multiples of the alignment, or last");
    }
  }
  void compare() {
    live_.buffer().draws(draws_);
    promise(std::equal(live_.bytes().begin(), live_.bytes().end(), device_.bytes.begin()),
            "the ranges of an update are all that has changed");
    promise(device_.drawn(options_.format.form, draws_) == triangles_of(mesh()),
            "what is drawn are the triangles of the mesh");
  }

  // ---- frames

  /// What is before and after is no longer known.
  void lose_track() {
    frames_.clear();
    at_ = 0;
    any_before_ = any_after_ = true;
    changed_ = true;
  }
  /// After an update: a frame has ended if the mesh has changed.
  void note_frame() {
    const bool may_have_changed = std::exchange(changed_, false);
    if (options_.history == 0) return promise(live_.undoable() + live_.redoable() == 0, "no history has no frames");
    State now = state_of(mesh());
    if (frames_.empty()) return frames_.push_back(std::move(now));
    if (now != frames_[at_]) {
      promise(may_have_changed, "refused operations change nothing");
      promise(live_.undoable() > 0 && live_.redoable() == 0, "a change is a frame");
      frames_.resize(++at_);
      frames_.push_back(std::move(now));
      any_after_ = false;
    } else if (may_have_changed) {  // a frame if free handles are in another order
      lose_track();
      changed_ = false;
      frames_.push_back(std::move(now));
    }
  }
  /// Undoes or redoes a frame. False if no frame is left, or memory ran out.
  bool move(bool forward) {
    const bool tracked = !frames_.empty() && options_.history != 0;
    State before = changed_ && tracked ? state_of(mesh()) : State{};
    const bool ends_a_frame = changed_ && tracked && before != frames_[at_];
    bool moved = false;
    if (!done([&] { moved = forward ? live_.redo() : live_.undo(); })) {
      lose_track();
      return false;
    }
    promise(!moved || options_.history != 0, "nothing is undone without a history");
    promise(moved || (forward ? live_.redoable() : live_.undoable()) == 0,
            "frames that are left can be undone and redone");
    if (ends_a_frame) {
      promise(moved != forward, "a change is undone first, and nothing is redone after it");
      frames_.resize(at_ + 1);
      frames_.push_back(std::move(before));
      any_after_ = false;
      if (forward) ++at_;
    } else if (changed_ || !tracked) {  // free handles in another order may be a frame
      lose_track();
      frames_.push_back(state_of(mesh()));
    } else if (moved) {
      step(forward);
    }
    changed_ = false;
    if (moved && !forward && ends_a_frame) expect_restored();
    return moved;
  }
  void step(bool forward) {
    if (forward ? at_ + 1 < frames_.size() : at_ > 0) {
      at_ = forward ? at_ + 1 : at_ - 1;
      return expect_restored();
    }
    promise(forward ? any_after_ : any_before_, "no frame is undone or redone that was not made");
    frames_.insert(forward ? frames_.end() : frames_.begin(), state_of(mesh()));
    at_ = forward ? frames_.size() - 1 : 0;
  }
  void expect_restored() const {
    promise(state_of(mesh()) == frames_[at_], "triangles, handles and colours are restored exactly");
  }

  Input& input_;
  LiveOptions options_;
  LiveMesh live_;
  Device device_;
  std::vector<IndexRange> draws_;
  std::vector<State> frames_;  // those that are known, consecutive
  std::size_t at_ = 0;         // the one that the mesh is at
  bool any_before_ = false;    // perhaps frames before these can be undone, or after these redone
  bool any_after_ = false;
  bool changed_ = false;            // perhaps, since the last update
  std::uint32_t memory_fails_ = 0;  // in the next call: twice the number of the allocation, plus one for good
};

// ---- meshes

/// A sheet of w by h squares, closed in both directions if `wraps`.
std::vector<Corners> sheet(std::uint32_t w, std::uint32_t h, bool wraps) {
  std::vector<Corners> triangles;
  const std::uint32_t row = wraps ? w : w + 1;
  const auto at = [&](std::uint32_t x, std::uint32_t y) { return (wraps ? y % h * row + x % w : y * row + x); };
  for (std::uint32_t y = 0; y < h; ++y)
    for (std::uint32_t x = 0; x < w; ++x) {
      triangles.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      triangles.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  return triangles;
}

std::vector<Corners> any_mesh(Input& input) {
  const std::uint32_t kind = input.byte() % 8;
  const std::uint32_t size = input.byte();
  if (kind < 3) return sheet(1 + size % 8, 1 + size / 8 % 8, false);
  if (kind < 5) return sheet(3 + size % 5, 3 + size / 8 % 5, true);
  if (kind == 5) return {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  std::vector<Corners> any;  // also with corners twice or out of range, edges of many triangles
  for (std::uint32_t t = 0; t < size % 40; ++t)
    any.push_back({input.byte() % 16, input.byte() % 16, input.byte() % 17});
  return any;
}

LiveOptions any_options(Input& input) {
  LiveOptions options;
  const std::uint32_t policy = input.byte();
  options.policy = static_cast<Policy>(policy % policies.size());
  options.effort = static_cast<Effort>(policy / 16 % 3);
  options.cost = input.one_of(std::array{Cost::strips(), Cost::indices(), Cost{2, 1, 1}});
  options.history = input.one_of(std::array{std::size_t{0}, std::size_t{1}, std::size_t{60}, std::size_t{100'000},
                                            std::numeric_limits<std::size_t>::max(), std::size_t{100'000}});
  const std::uint32_t format = input.byte();
  options.format.form = static_cast<StripForm>(format % 4);
  options.format.width =
      std::array{IndexWidth::automatic, IndexWidth::automatic, IndexWidth::bits16, IndexWidth::bits32}[format / 4 % 4];
  const std::uint32_t layout = input.byte();
  options.layout.cache = std::array{32U, 32U, 32U, 16U, 1U, 64U, 0U, layout == 255 ? 65U : 3U}[layout % 8];
  options.layout.waste = std::array{95U, 95U, 0U, 2000U}[layout / 8 % 4];
  options.layout.work = std::array{5U, 5U, 0U, 1U, 100U, 5U, 5U, 5U}[layout / 32];
  const std::uint32_t limits = input.byte();
  if (limits == 255) options.format.most_vertices = 3;
  if (limits >= 254) options.format.most_indices = std::numeric_limits<std::size_t>::max() - 2;
  return options;
}

/// False for a format that a LiveMesh refuses.
bool drive(std::string_view bytes) {
  Input input(bytes);
  const LiveOptions options = any_options(input);
  const std::vector<Corners> triangles = any_mesh(input);
  std::size_t vertices = 0;
  for (const Corners& corners : triangles)
    for (const std::uint32_t v : corners) vertices = std::max<std::size_t>(vertices, v % 16 == 0 ? v : v + 1);
  std::optional<Caller> caller;
  try {
    caller.emplace(input, triangles, vertices, options);
  } catch (const std::invalid_argument&) {
    return false;
  }
  caller->run();
  return true;
}

/// Bytes that look random, the same on every machine, after the options.
std::string some_steps(std::initializer_list<int> options, std::size_t length, std::uint32_t seed) {
  std::string bytes;
  for (const int option : options) bytes.push_back(static_cast<char>(option));
  for (std::size_t i = 0; i < length; ++i) {
    seed = seed * 1'664'525 + 1'013'904'223;
    bytes.push_back(static_cast<char>(seed >> 24));
  }
  return bytes;
}

}  // namespace

std::vector<Target> live_targets() {
  std::vector<std::string> seeds;
  std::uint32_t seed = 1;
  for (const int format : {0, 1, 2, 3, 8, 12})
    for (const int policy : {1, 2, 3, 4})
      for (const int mesh : {0, 3}) seeds.push_back(some_steps({policy, 1, 3, format, 0, 0, mesh, 45}, 150, ++seed));
  seeds.push_back(some_steps({5, 0, 2, 4, 3, 0, 7, 30}, 300, 77));
  seeds.push_back(some_steps({0, 2, 0, 0, 134, 0, 5, 0}, 60, 78));
  return {{"live", seeds, drive, 400}};
}

}  // namespace restrip::fuzz
