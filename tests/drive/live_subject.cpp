#include "drive/live_subject.hpp"

#include <new>
#include <utility>

#include "restrip/formats/baked_file.hpp"
#include "restrip/output/live_buffer.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/tables/shipped_operations.hpp"
#include "runtime/whole_mesh.hpp"

namespace restrip::drive {
namespace {

Outcome of(const Checked& checked) {
  Outcome outcome;
  outcome.end = checked ? Outcome::End::done : Outcome::End::refused;
  outcome.reason = describe(checked.refusal);
  outcome.rewrite = checked.rewrite;
  outcome.added = checked.new_vertices;
  return outcome;
}

/// Collapse, flip or split as a program with another mesh calls them.
Checked by_vertices(LiveMesh& live, const Step& step) {
  using Spokes = VertexSplit::Spokes;
  const StripMesh& mesh = live.mesh();
  const auto& [left, right, spokes] = step.where;
  const Halfedge spoke = spokes == Spokes::right_only ? right : left;
  const Vertex v = mesh.from(spoke);
  if (step.call == Call::collapse) return live.collapse(v, mesh.to(spoke));
  if (step.call == Call::flip) return live.flip(v, mesh.to(spoke));
  return live.split(v, spokes == Spokes::right_only ? none : mesh.to(left),
                    spokes == Spokes::left_only ? none : mesh.to(right), step.name);
}

/// Both spokes of a split leave one vertex, so it can be named.
bool has_vertices(const StripMesh& mesh, const Step& step) {
  using Spokes = VertexSplit::Spokes;
  const auto& [left, right, spokes] = step.where;
  if (step.call != Call::split) return step.call <= Call::flip && mesh.alive(left);
  if (spokes != Spokes::right_only && !mesh.alive(left)) return false;
  if (spokes != Spokes::left_only && !mesh.alive(right)) return false;
  return spokes != Spokes::both || mesh.from(left) == mesh.from(right);
}

Outcome operate(LiveMesh& live, const Step& step) {
  const Halfedge h = step.where.left;
  if (step.by_vertices && has_vertices(live.mesh(), step)) return of(by_vertices(live, step));
  switch (step.call) {
    case Call::split:
      return of(live.split(step.where, step.name));
    case Call::collapse:
      return of(live.collapse(h));
    case Call::flip:
      return of(live.flip(h));
    case Call::split_face:
      return of(live.split_face(h));
    case Call::join_faces:
      return of(live.join_faces(h));
    case Call::bisect:
      return of(live.bisect(h));
    case Call::merge:
      return of(live.merge(h));
    case Call::apply:
      return of(live.apply(operations()[step.number % operations().size()], h));
    default:
      return of(live.replace(step.out, step.in));
  }
}

}  // namespace

std::span<const OperationView> operations() {
  static const std::vector<OperationView> all = [] {
    std::vector<OperationView> found;
    tables::for_each_operation([&](const char* /*name*/, const auto& table) {
      if (!table.matching) found.emplace_back(table);
    });
    return found;
  }();
  return all;
}

Outcome LiveSubject::perform(const Step& step) {
  Outcome outcome;
  try {
    if (is_operation(step.call)) return operate(live_, step);
    switch (step.call) {
      case Call::improve:
        outcome.number = live_.improve(step.number);
        break;
      case Call::recolor:
        outcome.number = live_.recolor(Effort::fast, step.cost);
        break;
      case Call::keep:
        live_.keep(step.policy, step.cost);
        if (step.number != 0) live_.keeper().set_search({.states = static_cast<std::uint32_t>(step.number)});
        break;
      case Call::move_to_level:
        outcome.number = live_.move_to_level(step.number % (live_.baked()->splits.size() + 1), step.number % 41);
        break;
      case Call::pack:
        outcome.numbers = live_.pack();
        break;
      case Call::reload:
        live_ = LiveMesh::load(live_.save(), history_);
        break;
      case Call::update:
        outcome.upload = live_.update(step.ranges);
        if (step.lost) live_.keep_upload();
        break;
      default:
        outcome.moved = step.call == Call::undo ? live_.undo() : live_.redo();
    }
  } catch (const std::bad_alloc&) {
    outcome.end = Outcome::End::out_of_memory;
  } catch (const std::length_error&) {
    outcome.end = Outcome::End::too_wide;
  }
  return outcome;
}

Halfedge LiveSubject::opposite(Halfedge h) const {
  return live_.mesh().alive(h) ? live_.mesh().opposite(h) : Halfedge{};
}

std::vector<std::uint32_t> LiveSubject::look() const {
  std::vector<std::uint32_t> look = look_at(live_.mesh());
  look.push_back(live_.level() ? static_cast<std::uint32_t>(*live_.level()) : none);
  return look;
}

BufferView LiveSubject::buffer() {
  live_.buffer().draws(draws_);
  return {live_.bytes(), live_.index_bytes(), live_.room(), live_.buffer().format().form, draws_};
}

}  // namespace restrip::drive
