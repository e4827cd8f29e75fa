#include "drive/oracles.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "restrip/operations/operations.hpp"
#include "restrip/operations/refine.hpp"
#include "restrip/output/live_buffer.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/policy.hpp"
#include "runtime/whole_mesh.hpp"

namespace restrip::drive {

using End = Outcome::End;

// ---- Device

void Device::make(const BufferView& view) {
  width_ = view.width;
  room_ = view.room;
  bytes_.assign(room_ * width_, std::byte{0xA5});
}

void Device::begin(Subject& subject) {
  const BufferView view = subject.buffer();
  make(view);
  std::copy(view.bytes.begin(), view.bytes.end(), bytes_.begin());
}

void Device::after(const Step& step, const Outcome& outcome, Subject& subject) {
  if (step.call == Call::reload && outcome.done()) return begin(subject);
  if (step.call != Call::update || !outcome.done()) return;
  const BufferView view = subject.buffer();
  if (step.lost) return;
  check_ranges(outcome.upload, step.ranges, view);
  if (outcome.upload.outgrown) ++outgrown_, make(view);
  for (const auto& [first, count] : outcome.upload)
    std::copy_n(view.bytes.data() + first * width_, count * width_, bytes_.data() + first * width_);
  promise(std::equal(view.bytes.begin(), view.bytes.end(), bytes_.begin()),
          "the ranges of an update are all that has changed");
  form_reader::Reader reader(bytes_, width_);
  for (const IndexRange& draw : view.draws) {
    promise(draw.count <= room_ && draw.first <= room_ - draw.count, "draws lie within the buffer");
    promise(view.form == StripForm::restart || !reader.has_restart(draw),
            "only the form with restarts has the restart index");
  }
  reader.draw(view.form, view.draws);
  promise(std::move(reader).triangles() == subject.triangles(), "what is drawn are the triangles of the mesh");
}

void Device::check_ranges(const Upload& upload, const RangeOptions& options, const BufferView& view) const {
  const std::size_t size = view.bytes.size() / view.width;
  promise(view.bytes.size() % 4 == 0, "the length of a buffer is a multiple of four bytes");
  promise(size <= view.room, "a buffer fits into its room");
  if (upload.outgrown)
    promise(view.width != width_ || view.room > room_, "no alarm is false");
  else
    promise(view.width == width_ && size <= room_, "an outgrown buffer is reported");
  if (upload.outgrown && size != 0)
    promise(upload.size() == 1 && upload[0] == IndexRange{0, size}, "everything is uploaded to a new buffer");
  std::size_t end = 0;
  for (const auto& [first, count] : upload) {
    promise(count != 0 && count <= size && first <= size - count, "ranges lie within the buffer");
    promise(end == 0 || (first > end && first - end > options.merge_gap), "ranges ascend, and close ones are joined");
    end = first + count;
    promise(first * view.width % options.align == 0, "ranges begin at multiples of the alignment");
    promise(end * view.width % options.align == 0 || end == size, "ranges end at multiples of the alignment, or last");
  }
}

// ---- FrameLooks

void FrameLooks::begin(Subject& subject) { begin_again(subject); }

void FrameLooks::begin_again(Subject& subject) {
  promise(subject.undoable() + subject.redoable() == 0, "a history begins without frames");
  looks_.clear();
  at_ = subject.frame();
  looks_[at_] = subject.look();
  lost_ = changed_ = false;
}

void FrameLooks::before(const Step& step, Subject& subject) {
  if (step.call == Call::undo || step.call == Call::redo) before_ = subject.look();
}

void FrameLooks::after(const Step& step, const Outcome& outcome, Subject& subject) {
  if (!has_history_) return promise(subject.undoable() + subject.redoable() == 0 && !outcome.moved, "no history");
  const bool failed = outcome.end == End::out_of_memory;
  switch (step.call) {
    case Call::pack:
    case Call::reload:
      if (outcome.done()) return begin_again(subject);
      if (failed) forget();
      return;
    case Call::update:
      return failed ? forget() : end_frame(subject);
    case Call::undo:
    case Call::redo:
      return outcome.done() ? move(step.call == Call::redo, outcome.moved, subject) : forget();
    default:
      changed_ |= outcome.end != End::refused;
  }
}

/// A new frame; those after it cannot be redone.
void FrameLooks::note_frame(std::size_t frame, const Look& look) {
  promise(changed_, "a frame has changes");
  looks_.erase(looks_.lower_bound(frame), looks_.end());
  looks_[frame] = look;
}

void FrameLooks::end_frame(Subject& subject) {
  const std::size_t frame = subject.frame();
  const Look now = subject.look();
  if (lost_ || frame == at_) {
    promise(lost_ || !differs(now), "a change is a frame, and refused operations change nothing");
    if (lost_) looks_.clear();
    looks_[frame] = now;
  } else {
    promise(frame == at_ + 1 && subject.undoable() > 0 && subject.redoable() == 0, "a change is one frame, the last");
    note_frame(frame, now);
  }
  at_ = frame;
  lost_ = changed_ = false;
}

void FrameLooks::move(bool forward, bool moved, Subject& subject) {
  promise(moved || (forward ? subject.redoable() : subject.undoable()) == 0, "frames that are left can be reached");
  const std::size_t frame = subject.frame();
  const Look now = subject.look();
  if (!lost_) {
    // What has changed since the last frame is a frame first.
    const bool ended = changed_ && frame == at_ + (forward ? 1 : 0) && moved != forward;
    if (ended)
      note_frame(at_ + 1, before_);
    else
      promise(frame == (!moved    ? at_
                        : forward ? at_ + 1
                                  : at_ - 1) &&
                  !differs(before_),
              "frames are reached in order");
  }
  if (looks_.contains(frame)) promise(now == looks_.at(frame), "triangles, handles and colours are restored exactly");
  looks_[frame] = now;
  at_ = frame;
  lost_ = changed_ = false;
}

// ---- Counts

Counts::Census Counts::count(const LiveMesh& live) {
  promise(fault_of(live.mesh()).empty(), "triangles, neighbours and first spokes agree");
  const ColoringReport report = check_coloring(live.mesh());
  promise(report.valid, "strips neither branch nor close");
  promise(report.triangles == live.mesh().triangle_count(), "triangles are counted");
  return {report.strips, report.isolated, count_swaps(live.mesh())};
}

void Counts::begin(Subject& subject) {
  last_ = count(*subject.live());
  after({.call = Call::update}, {}, subject);
}

void Counts::after(const Step& step, const Outcome& outcome, Subject& subject) {
  const LiveMesh& live = *subject.live();
  const Keeper& keeper = live.keeper();
  const Census before = std::exchange(last_, count(live));
  if (!keeper.up_to_date()) return;
  promise(keeper.strips() == last_.strips && live.strips() == last_.strips, "strips are counted");
  if (live.level()) return;  // records have no other counts
  promise(keeper.isolated() == last_.isolated, "isolated triangles are counted");
  promise(keeper.swaps() == last_.swaps, "swaps are counted");
  if (const StripLocator* const locator = detail::locator_of(keeper))
    promise(disagreement(*locator, live.mesh()).empty(), "strips are located");
  if (!outcome.done()) return;
  if (is_operation(step.call)) {
    promise(static_cast<long>(before.strips) + outcome.rewrite.strips == static_cast<long>(last_.strips),
            "operations report strips");
    promise(static_cast<long>(before.isolated) + outcome.rewrite.isolated == static_cast<long>(last_.isolated),
            "operations report isolated triangles");
  }
  if (step.call == Call::improve)
    promise(before.cost(keeper.weights()) - outcome.number == last_.cost(keeper.weights()),
            "the cost saved is reported");
  if (step.call == Call::recolor) promise(outcome.number == last_.strips, "the strips made are reported");
}

// ---- Bounds

void Bounds::before(const Step& step, Subject& subject) {
  const LiveMesh& live = *subject.live();
  const Keeper& keeper = live.keeper();
  applies_ = is_operation(step.call) && step.call != Call::replace && keeper.up_to_date() && !live.level() &&
             keeper.policy() != Policy::bare;
  if (!applies_) return;
  cost_ = keeper.cost();
  rules_ = keeper.rule_counts();
  const StripMesh& mesh = live.mesh();
  const auto inside = [&](Vertex v) { return mesh.spoke(v).id != none && !mesh.leaves_boundary(mesh.spoke(v)); };
  const Halfedge h = step.where.left;
  closed_fan_ = step.call <= Call::collapse && mesh.alive(h) && inside(mesh.from(h)) && inside(mesh.to(h));
}

void Bounds::after(const Step& step, const Outcome& outcome, Subject& subject) {
  if (!applies_ || !outcome.done()) return;
  const Keeper& keeper = subject.live()->keeper();
  const bool rules_only = keeper.policy() == Policy::rules;
  if (keeper.weights() == Cost::strips()) {
    promise(outcome.rewrite.strips <= most_strips_added, "an operation adds at most one strip");
    promise(!closed_fan_ || outcome.rewrite.isolated <= 0, "a closed fan isolates no triangle");
  }
  if (keeper.weights() == Cost::indices() && !rules_only)
    promise(keeper.cost() <= cost_ + most_indices_added, "an operation adds at most six indices");
  const RuleCounts& now = keeper.rule_counts();
  promise(now.asked == rules_.asked + 1 && now.taken + now.kept == rules_.taken + rules_.kept + 1,
          "an operation asks one rule");
  promise(!rules_only || detail::locator_of(keeper) != nullptr || now.improved == rules_.improved,
          "nothing follows a rule under the policy `rules`");
  promise(!(keeper.weights() == Cost::strips()) || now.kept == rules_.kept, "rules are taken for fewest strips");
  (void)step;
  sum_.asked += 1;
  sum_.taken += now.taken - rules_.taken;
  sum_.kept += now.kept - rules_.kept;
  sum_.improved += now.improved - rules_.improved;
}

// ---- FreeFunctions

namespace {

Checked replace(StripMesh& mesh, const Step& step) {
  Checked done;
  done.refusal = check_replace(mesh, step.out, step.in);
  if (!done) return done;
  const StripMesh before = mesh;
  std::vector<Triangle> made(step.in.size());
  mesh.replace(step.out, step.in, made);
  promise(made.size() == step.in.size(), "a new triangle for each that was given");
  for (std::size_t i = 0; i < made.size(); ++i) {
    promise(mesh.corners(made[i]) == step.in[i] && mesh.solid_degree(made[i]) == 0, "as it was given, and isolated");
    promise(i >= step.out.size() || made[i] == step.out[i], "removed triangles leave their numbers to new ones");
  }
  return done;
}

Checked by_free_function(StripMesh& mesh, const Step& step) {
  const Halfedge h = step.where.left;
  switch (step.call) {
    case Call::split:
      return checked_split(mesh, step.where, step.name);
    case Call::collapse:
      return checked_collapse(mesh, h);
    case Call::flip:
      return checked_flip(mesh, h);
    case Call::split_face:
      return split_face(mesh, h);
    case Call::join_faces:
      return join_faces(mesh, h);
    case Call::bisect:
      return bisect(mesh, h);
    case Call::merge:
      return merge(mesh, h);
    case Call::apply:
      return checked_apply(mesh, operations()[step.number % operations().size()], h);
    default:
      return replace(mesh, step);
  }
}

}  // namespace

void FreeFunctions::before(const Step& step, Subject& subject) {
  const LiveMesh& live = *subject.live();
  applies_ = is_operation(step.call) && !step.by_vertices && !live.level();
  if (!applies_) return;
  mesh_ = live.mesh();
  const Vertex next = mesh_.next_vertex();
  std::vector<Triangle> changed;
  mesh_.watch(&changed);
  done_ = by_free_function(mesh_, step);
  mesh_.watch(nullptr);
  promise(names_all_changes(changed, live.mesh(), mesh_), "a watch names every triangle that changes");
  promise(step.call != Call::split || !done_ || step.name != none || done_.new_vertex() == next,
          "a split takes the vertex that was announced");
}

void FreeFunctions::after(const Step& step, const Outcome& outcome, Subject& subject) {
  if (!applies_ || outcome.end == End::out_of_memory) return;
  promise(done_.granted() == outcome.done(), "a LiveMesh refuses what the functions of a StripMesh refuse");
  promise(std::strcmp(describe(done_.refusal), outcome.reason) == 0, "for the same reason");
  const LiveMesh& live = *subject.live();
  promise(sample::triangles_of(mesh_) == subject.triangles(), "a LiveMesh does what they do");
  const Keeper& keeper = live.keeper();
  if (!outcome.done() || keeper.policy() != Policy::rules || detail::locator_of(keeper) != nullptr) return;
  if (!(keeper.weights() == Cost::strips())) return;
  promise(differing_triangles(mesh_, live.mesh()).empty(), "and nothing else under the policy `rules`");
  promise(step.call == Call::replace ||
              (done_.rewrite.strips == outcome.rewrite.strips && done_.rewrite.isolated == outcome.rewrite.isolated),
          "and counts the same");
}

// ---- Mirror

namespace {

constexpr Vertex placeholder = 2'000'000'000;  // names of new vertices that are not known yet

/// The list without `out` and with `in`, if all vertices of both are manifold then, and no closed fan has two
/// triangles.
std::optional<bare::List> replaced(const bare::List& list, const bare::List& out, const bare::List& in) {
  bare::List after;
  std::copy_if(list.begin(), list.end(), std::back_inserter(after), [&](const Corners& c) {
    return std::none_of(out.begin(), out.end(),
                        [&](const Corners& o) { return bare::sorted({o}) == bare::sorted({c}); });
  });
  if (after.size() + out.size() != list.size()) return {};
  after.insert(after.end(), in.begin(), in.end());
  std::set<Vertex> named;
  for (const bare::List* some : {&out, &in})
    for (const Corners& c : *some) named.insert(c.begin(), c.end());
  const bare::Shape shape = bare::shape_of(after);
  if (shape.degenerate) return {};
  for (const Vertex v : named) {
    if (!shape.vertices.contains(v)) continue;
    const auto link = bare::link_of(after, v);
    if (!link || (link->closed && link->triangles() < 3)) return {};
  }
  return after;
}

OperationPlace place_of(const StripMesh& mesh, Call call, Halfedge h) {
  if (call == Call::split_face) return split_face_at(mesh, h);
  if (call == Call::join_faces) return join_faces_at(mesh, h);
  return call == Call::bisect ? bisect_at(mesh, h) : merge_at(mesh, h);
}

}  // namespace

void Mirror::begin(Subject& subject) {
  const StripMesh& mesh = subject.live()->mesh();
  manifold_ = true;
  for (Vertex v = 0; v < mesh.vertex_bound(); ++v)
    if (mesh.spoke(v).id != none && mesh.non_manifold(v)) manifold_ = false;
  list_ = subject.triangles();
  shape_ = bare::shape_of(list_);
}

std::optional<bare::List> Mirror::wanted(const Step& step, const StripMesh& mesh) const {
  using Spokes = VertexSplit::Spokes;
  const auto& [left, right, spokes] = step.where;
  if (step.call == Call::replace) {
    bare::List out;
    for (const Triangle t : step.out) {
      if (!mesh.alive(t) || std::count(step.out.begin(), step.out.end(), t) != 1) return {};
      out.push_back(mesh.corners(t));
    }
    return replaced(list_, out, step.in);
  }
  if (step.call == Call::split) {
    if (spokes != Spokes::right_only && !mesh.alive(left)) return {};
    if (spokes != Spokes::left_only && !mesh.alive(right)) return {};
    const Vertex v = mesh.from(spokes == Spokes::right_only ? right : left);
    if (spokes == Spokes::both && mesh.from(right) != v) return {};
    const auto end = [&](Halfedge h, Spokes other) {
      return spokes == other ? std::optional<Vertex>() : std::optional(mesh.to(h));
    };
    return bare::split(list_, shape_, v, end(left, Spokes::right_only), end(right, Spokes::left_only),
                       step.name == none ? placeholder : step.name);
  }
  if (!mesh.alive(left)) return {};
  if (step.call == Call::collapse) return bare::collapse(list_, shape_, mesh.from(left), mesh.to(left));
  if (step.call == Call::flip) return bare::flip(list_, shape_, mesh.from(left), mesh.to(left));
  const OperationPlace at = step.call == Call::apply
                                ? OperationPlace{operations()[step.number % operations().size()], left}
                                : place_of(mesh, step.call, left);
  if (!mesh.alive(at.where)) return {};
  return bare::applied(list_, shape_, at.table, mesh.from(at.where), mesh.to(at.where),
                       {placeholder, placeholder + 1, placeholder + 2});
}

void Mirror::before(const Step& step, Subject& subject) {
  judges_ =
      is_operation(step.call) && manifold_ && list_.size() <= most_ && (step.name == none || step.name < placeholder);
  if (judges_) wanted_ = wanted(step, subject.live()->mesh());
}

void Mirror::after(const Step& step, const Outcome& outcome, Subject& subject) {
  bare::List now = subject.triangles();
  if (step.call == Call::pack || step.call == Call::reload || step.call == Call::undo || step.call == Call::redo ||
      step.call == Call::move_to_level || outcome.end == End::out_of_memory) {
    if (now != list_) begin(subject);
    return;
  }
  if (judges_) {
    ++judged_;
    promise(outcome.done() == wanted_.has_value(), "operations are granted exactly if they leave a manifold");
    if (wanted_)
      for (Corners& corners : *wanted_)
        for (Vertex& v : corners)
          if (v >= placeholder) v = outcome.added[v - placeholder];
    promise(now == (wanted_ ? bare::sorted(*wanted_) : list_), "an operation does what it does to any mesh");
  } else {
    promise(now == list_ || (is_operation(step.call) && outcome.done()), "nothing else changes triangles");
  }
  if (now == list_) return;
  list_ = std::move(now);
  if (list_.size() <= most_) shape_ = bare::shape_of(list_);
}

// ---- Numbers

namespace {

std::vector<std::uint32_t> settings_of(const LiveMesh& live) {
  const Keeper& keeper = live.keeper();
  const LiveBuffer& buffer = live.buffer();
  const Cost& cost = keeper.weights();
  return {static_cast<std::uint32_t>(keeper.policy()),
          cost.restart,
          cost.swap,
          cost.isolated,
          static_cast<std::uint32_t>(buffer.format().form),
          static_cast<std::uint32_t>(buffer.format().width),
          buffer.layout().cache,
          buffer.layout().waste,
          buffer.layout().work};
}

void check_packed(const StripMesh& before, const StripMesh& after, const Renumbering& numbers) {
  promise(numbers.triangles.size() == before.triangle_bound() && numbers.vertices.size() == before.vertex_bound(),
          "packing names a number for each number");
  promise(after.triangle_bound() == before.triangle_count(), "packed triangles have the lowest numbers");
  Triangle next = 0;
  for (Triangle t = 0; t < before.triangle_bound(); ++t) {
    const Triangle to = numbers.triangles[t];
    promise(to == (before.alive(t) ? next : none), "packed triangles stay in order");
    if (to == none) continue;
    ++next;
    promise(after.solid_sides(to) == before.solid_sides(t), "packing keeps colours");
    for (unsigned corner = 0; corner < 3; ++corner)
      promise(after.corners(to)[corner] == numbers.vertices[before.corners(t)[corner]], "packing keeps corners");
  }
}

}  // namespace

void Numbers::before(const Step& step, Subject& subject) {
  if (step.call != Call::pack && step.call != Call::reload) return;
  mesh_ = subject.live()->mesh();
  settings_ = settings_of(*subject.live());
  saved_ = subject.live()->save();
}

void Numbers::after(const Step& step, const Outcome& outcome, Subject& subject) {
  if (!outcome.done()) return;
  const LiveMesh& live = *subject.live();
  if (step.call == Call::pack) check_packed(mesh_, live.mesh(), outcome.numbers);
  if (step.call != Call::reload) return;
  promise(live.mesh().vertex_bound() == mesh_.vertex_bound() && differing_triangles(live.mesh(), mesh_).empty(),
          "a saved mesh loads with its numbers, neighbours and colours");
  for (Vertex v = 0; v < mesh_.vertex_bound(); ++v)
    promise(live.mesh().non_manifold(v) == mesh_.non_manifold(v), "a saved mesh loads with its marks");
  promise(settings_of(live) == settings_, "a saved mesh loads with its policy, cost, format and layout");
  promise(live.save() == saved_, "what is loaded saves to the same bytes");
}

// ---- Twin

void Twin::begin(Subject& subject) { promise(subject.Subject::look() == other_.Subject::look(), "twins begin alike"); }

void Twin::after(const Step& step, const Outcome& outcome, Subject& subject) {
  const Outcome other = other_.perform(step);
  promise(outcome.end == other.end && std::strcmp(outcome.reason, other.reason) == 0, "twins refuse the same");
  promise(outcome.moved == other.moved && outcome.number == other.number, "twins report the same");
  if (is_operation(step.call) && outcome.done()) {
    promise(outcome.rewrite.strips == other.rewrite.strips && outcome.rewrite.isolated == other.rewrite.isolated,
            "twins count the same");
    promise(step.call == Call::replace ||
                std::equal(outcome.added.begin(), outcome.added.end(), other.added.begin(), other.added.end()),
            "twins have the same new vertices");
  }
  promise(std::equal(outcome.upload.begin(), outcome.upload.end(), other.upload.begin(), other.upload.end()) &&
              outcome.upload.outgrown == other.upload.outgrown,
          "twins upload the same");
  promise(subject.Subject::look() == other_.Subject::look(), "twins look the same");
  promise(subject.frame() == other_.frame() && subject.strips() == other_.strips(), "twins count frames and strips");
}

}  // namespace restrip::drive
