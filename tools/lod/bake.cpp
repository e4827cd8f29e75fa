#include "lod/bake.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>

#include "common/progress.hpp"
#include "common/stopwatch.hpp"
#include "lod/coloring_check.hpp"
#include "lod/trail_search.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "search/chain_search.hpp"
#include "search/strip_locator.hpp"
#include "search/tunnel.hpp"

namespace restrip::tools {
namespace {

using Halfedge = StripMesh::Halfedge;

/// What all bakers share. They walk up from the base; the flips of a record are the dual edges whose colours have
/// changed since its split.
class Baker {
 public:
  explicit Baker(BakedMesh& baked) : baked_(baked) {}
  virtual ~Baker() = default;
  Baker(const Baker&) = delete;
  Baker& operator=(const Baker&) = delete;

  /// Call it once.
  BakeReport run() {
    report_.seconds = nanoseconds_of([this] { walk_up(); }) * 1e-9;
    return report_;
  }

 protected:
  virtual void begin(StripMesh& base) = 0;
  /// Splits by split_plainly(), then may change colours.
  virtual void bake_split(const VertexSplit& where, Vertex v_t) = 0;
  [[nodiscard]] virtual std::size_t strips() const = 0;
  [[nodiscard]] virtual std::size_t states() const = 0;

  [[nodiscard]] StripMesh& mesh() { return mesh_; }

  Rewrite split_plainly(const VertexSplit& where, Vertex v_t) {
    const Rewrite done = split_baked(mesh_, where, {}, v_t);
    note_colors();
    return done;
  }

  /// Watches every change of a colour. While watching is off, only the triangles passed to changed() are noted.
  void watch(bool on) { mesh_.watch(on ? &changed_ : nullptr); }
  void changed(Halfedge h) {
    changed_.push_back(StripMesh::triangle(h));
    changed_.push_back(StripMesh::triangle(mesh_.opposite(h)));
  }

  /// The dual edges whose colours have changed since the last split, sorted.
  [[nodiscard]] std::vector<Halfedge> flips() {
    // After long searches the list is a thousand times longer than the lasting changes.
    std::erase_if(changed_, [this](Triangle t) { return mesh_.solid_sides(t) == noted_[t]; });
    std::sort(changed_.begin(), changed_.end());
    changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
    std::vector<Halfedge> flips;
    for (const Triangle t : changed_) {
      const unsigned differing = mesh_.solid_sides(t) ^ noted_[t];
      for (unsigned side = 0; side < 3; ++side) {
        const Halfedge h = StripMesh::halfedge(t, side);
        if ((differing >> side & 1U) != 0 && h.id < mesh_.opposite(h).id) flips.push_back(h);
      }
    }
    return flips;
  }

 private:
  void walk_up() {
    begin(baked_.base);
    mesh_ = baked_.base;
    mesh_.reserve(baked_.mesh.fine_triangles(), baked_.mesh.points.size());
    changed_.resize(mesh_.triangle_bound());
    std::iota(changed_.begin(), changed_.end(), Triangle{0});
    note_colors();
    watch(true);
    report_.components = connected_components(mesh_);
    report_.base_strips = strips();
    count_level();
    BakedRecords& records = baked_.records;
    Progress progress("baking", baked_.mesh.splits.size());
    for (std::size_t i = 0; i < baked_.mesh.splits.size(); ++i) {
      bake_split(possible_split(mesh_, baked_.mesh, i), baked_.mesh.splits[i].v_t);
      const std::vector<Halfedge> more = flips();
      records.flips.insert(records.flips.end(), more.begin(), more.end());
      if (records.flips.size() > std::numeric_limits<std::uint32_t>::max())
        throw BadInput("the mesh is too large: its records flip more than 2^32 colours");
      records.first.push_back(static_cast<std::uint32_t>(records.flips.size()));
      count_level();
      progress.at(i);
    }
    report_.top_strips = strips();
    report_.top_indices = strip_indices(mesh_).size();
    report_.top_at_least = strips_at_least(mesh_);
    report_.states = states();
  }

  void count_level() {
    report_.most_strips = std::max(report_.most_strips, strips());
    if (strips() <= report_.components) ++report_.fewest_levels;
  }

  /// The other triangles kept their colours.
  void note_colors() {
    noted_.resize(mesh_.triangle_bound());
    for (const Triangle t : changed_) noted_[t] = static_cast<std::uint8_t>(mesh_.solid_sides(t));
    changed_.clear();
  }

  BakedMesh& baked_;
  BakeReport report_;
  StripMesh mesh_;
  std::vector<Triangle> changed_;  // since colours were noted
  std::vector<std::uint8_t> noted_;
};

/// Bakes for the fewest strips.
class StripBaker final : public Baker {
 public:
  StripBaker(BakedMesh& baked, std::size_t effort) : Baker(baked), effort_(effort) {}

 private:
  [[nodiscard]] std::size_t strips() const override { return locator_.strips(); }
  [[nodiscard]] std::size_t states() const override { return trails_.states() + tunnel_.counts().states; }

  void begin(StripMesh& base) override {
    // Searches on the base are cheap, and every level inherits the result.
    constexpr std::size_t states_per_triangle = 1000;
    stripify(base, Effort::full, Cost::strips(), states_per_triangle * base.triangle_count());
    locator_.rebuild(base);
    counts_.emplace(base);
  }

  void bake_split(const VertexSplit& where, Vertex v_t) override {
    const std::size_t before = strips();
    fan_triangles(mesh(), where.spoke(), patch_);
    locator_.before_patch(mesh(), patch_);
    counts_->before_split(mesh(), patch_);
    const Halfedge chord = split_plainly(where, v_t).halfedge;
    edge_triangles(mesh(), chord, patch_);
    locator_.after_patch(mesh(), patch_);
    counts_->after_split(mesh(), patch_);
    // Inserted triangles first: trails from there are the shortest.
    const auto inserted = [&](Triangle t) {
      return t == StripMesh::triangle(chord) || t == StripMesh::triangle(mesh().opposite(chord));
    };
    std::stable_partition(patch_.begin(), patch_.end(), inserted);
    // Both isolated: together they form one strip.
    if (where.spokes == VertexSplit::Spokes::both && mesh().solid_degree(patch_[0]) == 0 &&
        mesh().solid_degree(patch_[1]) == 0)
      locator_.link(mesh(), chord);
    add_strips_since(before);
    if (counts_->can_spare(patch_.front()) && !join_around(strips() > before)) join_from_afar();
  }

  /// In the component that contains the patch.
  void add_strips_since(std::size_t before) {
    counts_->add(patch_.front(), static_cast<std::ptrdiff_t>(strips()) - static_cast<std::ptrdiff_t>(before));
  }

  /// Tries short trails from the strip ends in the patch until their component has no excess strip or no trail is
  /// found. False if the split added a strip (`cost`) that the trails did not save.
  bool join_around(bool cost) {
    bool saved = !cost;
    while (counts_->can_spare(patch_.front())) {
      ends_.clear();
      for (const Triangle t : patch_)
        if (mesh().solid_degree(t) < 2) ends_.push_back(t);
      // Excess strips of earlier splits get a short search only: they were searched for already.
      constexpr std::size_t short_look = 20'000;
      if (ends_.empty()) break;
      watch(false);  // the search tries many more colours than it keeps
      const bool joined = trails_.join(mesh(), locator_, ends_, saved ? std::min(effort_, short_look) : effort_);
      watch(true);
      if (!joined) break;
      for (const Halfedge h : trails_.flips()) changed(h);
      counts_->add(patch_.front(), -1);
      saved = true;
    }
    return saved && (!counts_->can_spare(patch_.front()) || ++waited_ < wait_);
  }

  /// Tunnels from the patch first, then from every strip end of the mesh.
  void join_from_afar() {
    const std::vector<Halfedge> flips_before = flips();
    const std::size_t strips_before = strips();
    const auto states = static_cast<std::uint32_t>(std::min<std::size_t>(effort_ / 4, 1U << 20));
    for (const Triangle t : patch_)
      if (mesh().solid_degree(t) < 2) tunnel_.join(mesh(), locator_, t, states);
    add_strips_since(strips_before);
    if (strips() == strips_before && ++waited_ >= wait_) {
      rounds_.run(mesh(), locator_, tunnel_, effort_ / 4, counts_->needed(),
                  [this](Triangle t) { return counts_->can_spare(t); });
      if (strips() < strips_before) counts_->recount(mesh());
      // If little is found, the wait doubles. If some of many excess strips are found, as in components that need more
      // strips than their bound, it halves. Otherwise the next attempt follows at once.
      const std::size_t found = strips_before - strips();
      const std::size_t wanted = strips_before - counts_->needed();
      waited_ = 0;
      if (64 * found <= wanted)
        wait_ = std::min<std::size_t>(2 * wait_, 1024);
      else
        wait_ = 8 * found < wanted ? std::max<std::size_t>(wait_ / 2, 1) : 1;
    }
    if (strips() < strips_before) return;
    // A search that found nothing has moved strips; its flips need not be played.
    const std::vector<Halfedge> flips_after = flips();
    std::vector<Halfedge> wandered;
    std::set_symmetric_difference(flips_before.begin(), flips_before.end(), flips_after.begin(), flips_after.end(),
                                  std::back_inserter(wandered), [](Halfedge g, Halfedge h) { return g.id < h.id; });
    const auto missing =
        std::partition(wandered.begin(), wandered.end(), [this](Halfedge h) { return mesh().solid(h); });
    std::for_each(wandered.begin(), missing, [this](Halfedge h) { locator_.cut(mesh(), h); });
    std::for_each(missing, wandered.end(), [this](Halfedge h) { locator_.link(mesh(), h); });
  }

  std::size_t effort_;
  StripLocator locator_;
  std::optional<ComponentStrips> counts_;  // of the mesh; set by begin()
  TrailSearch trails_;
  Tunnel tunnel_;
  TunnelRounds rounds_{256, 4096};
  std::vector<Triangle> patch_;
  std::vector<Triangle> ends_;
  std::size_t wait_ = 1;
  std::size_t waited_ = 0;
};

/// Bakes for the fewest indices. After each plain split, it searches for chains of moves from the strip ends around it.
/// Short chains come first, because each flip is played at run time.
class IndexBaker final : public Baker {
 public:
  IndexBaker(BakedMesh& baked, const BakeOptions& options) : Baker(baked), search_(options.cost) {
    constexpr std::size_t effort_of_a_look = 600;
    constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max();
    limits_ = {.looks = static_cast<std::uint32_t>(std::min(options.effort / effort_of_a_look, most)),
               .length = 16,
               .worse = 2};
  }

 private:
  [[nodiscard]] std::size_t strips() const override { return strips_; }
  [[nodiscard]] std::size_t states() const override { return search_.counts().looked; }

  void begin(StripMesh& base) override {
    stripify(base, Effort::best, search_.cost());
    strips_ = count_strips(base);
  }

  void bake_split(const VertexSplit& where, Vertex v_t) override {
    const Rewrite done = split_plainly(where, v_t);
    edge_triangles(mesh(), done.halfedge, from_);
    add_rings(mesh(), from_, 2);
    const ColoringChange change = search_.run(mesh(), from_, limits_);
    strips_ += static_cast<std::size_t>(done.strips + change.strips);
  }

  ChainSearch search_;
  ChainLimits limits_;
  std::size_t strips_ = 0;
  std::vector<Triangle> from_;
};

}  // namespace

BakedMesh bake(ProgressiveMesh mesh, const BakeOptions& options, BakeReport* report) {
  BakedMesh baked;
  baked.base = StripMesh::build(mesh.base, mesh.points.size());
  mesh.base = corners_of(baked.base);
  baked.mesh = std::move(mesh);
  const BakeReport made =
      options.cost == Cost::strips() ? StripBaker(baked, options.effort).run() : IndexBaker(baked, options).run();
  if (report != nullptr) *report = made;
  return baked;
}

}  // namespace restrip::tools
