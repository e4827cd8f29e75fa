// `restrip replay`: simplifies a mesh and replays every vertex split while its strips are kept.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/options.hpp"
#include "common/counted.hpp"
#include "common/output.hpp"
#include "lod/mesh_files.hpp"
#include "meshes/made_mesh.hpp"
#include "meshes/soup_builder.hpp"
#include "meshes/strip_file.hpp"
#include "replay/methods.hpp"
#include "replay/replay.hpp"
#include "replay/source.hpp"
#include "replay/walk.hpp"
#include "restrip/search/stripify.hpp"

namespace restrip::tools {
namespace {

struct ReplayCommand {
  NamedFile mesh;         ///< may be a progressive mesh (.pm, .baked), which is replayed as it is
  bool built_in = false;  ///< make a mesh instead of reading one
  std::size_t built_in_triangles = default_made_triangles;
  SimplifyOptions simplify;
  bool simplify_given = false;  ///< set by the caller; refused if nothing is simplified
  ReplayOptions replay;
  std::string policy;        ///< its name; empty: the default (methods.hpp)
  std::uint32_t states = 0;  ///< budget of each search; 0: the default of the method
  std::optional<Cost> cost;  ///< the cost to minimise; by default what the policy supports
  std::uint64_t walk_steps = 0;
  std::uint64_t seed = 1;
  NamedFile out;                  ///< where a level is written, with its strips; empty: not written
  std::size_t out_triangles = 0;  ///< minimum size of that level; 0: the finest level
  StripOptions strips;
  std::filesystem::path trace;  ///< where operations are recorded for restrip-check; empty: not recorded
  MendingOptions mending;
  std::string json;
};

/// Walks by the method. Baked strips continue by the rules once the mesh leaves its records. `trace` may be null.
WalkReport take_walk(const Source& source, const ReplayCommand& command, const PreparedMethod& prepared,
                     std::optional<Trace>* trace) {
  StripMesh mesh;
  if (source.original.empty()) {
    mesh = StripMesh::build(source.mesh.base, source.mesh.points.size());
    for (const Record& record : source.mesh.splits) mesh.insert_vertex(spokes_of(mesh, record), record.v_t);
  } else {
    mesh = StripMesh::build(source.original, source.mesh.points.size());
  }
  stripify(mesh, default_effort, prepared.cost());
  // Buffers are measured on copies, which are not traced.
  WalkOptions options{command.walk_steps, command.seed};
  options.buffer = command.replay.buffer;
  return walk(mesh, options, [&](StripMesh& on) {
    return trace != nullptr && &on == &mesh ? traced(on, prepared.begin(on), claim_of(prepared), *trace)
                                            : prepared.begin(on);
  });
}

/// Refuses a mesh whose trace no checker could read: an edge has at most one triangle on either side there. Operations
/// do not change the edges in question, so the base has all of them.
void expect_traceable(const Source& source) {
  BuildReport report;
  (void)StripMesh::build(source.mesh.base, source.mesh.points.size(), &report);
  const std::size_t edges = report.non_manifold_edges + report.inconsistent_edges;
  if (edges != 0)
    throw BadInput(fmt::format(
        "{}: {} of more than two triangles, or between triangles that disagree in orientation, which a trace cannot "
        "record; leave out --trace, or try --orient",
        source.subject.name, counted(edges, "edge")));
}

int run(const ReplayCommand& command) {
  std::optional<files::Output> level;
  if (!command.out.empty()) level = open_output(command.out, extensions_of(writes_strips));
  std::optional<files::Output> trace;
  if (!command.trace.empty()) trace.emplace(command.trace, files::OutputRules{{".trace"}});
  Report out(command.json);
  const MeshFormat* format = level ? &format_to_write(command.out, writes_strips) : nullptr;
  Source source = command.built_in
                      ? simplified("built-in torus", make_mesh(command.built_in_triangles), command.simplify)
                      : source_of(read_mesh_file(command.mesh), command.mesh, command.mending, command.simplify,
                                  command.simplify_given);
  if (trace) expect_traceable(source);
  if (format != nullptr && format->rounds) source.subject.mended.rounding = rounding_of(source.mesh.points);
  const Method& method =
      command.policy.empty() ? default_method(source.baked.has_value()) : method_named(command.policy);
  PreparedMethod::Given given;
  given.cost = command.cost;
  if (command.states != 0) given.search = {command.states, 0};
  if (source.baked) given.baked = &*source.baked;
  const PreparedMethod prepared(method, source.mesh, given);
  source.subject.policy = method.name;
  source.subject.search = prepared.search();
  source.subject.cost = prepared.cost();
  if (prepared.baked() != nullptr) source.subject.baked = costs_of(*prepared.baked(), prepared.seconds_to_bake());
  std::string text_of_trace;
  ReplayOptions options = command.replay;
  if (trace && command.walk_steps == 0) options.trace = &text_of_trace;
  const ReplayReport report = replay(prepared, source.original, options);
  std::optional<WalkReport> walk;
  std::optional<Trace> trace_of_walk;
  if (command.walk_steps != 0 && report.operations_without_rule == 0)
    walk = take_walk(source, command, prepared, trace ? &trace_of_walk : nullptr);

  out.text = as_text(report, source.subject) + (walk ? as_text(*walk) : "");
  if (level && report.valid()) {
    const std::size_t triangles = command.out_triangles == 0 ? report.triangles : command.out_triangles;
    const LevelFile file = level_file(level_mesh(prepared, triangles), source.mesh.points, *format, command.strips);
    level->write(file.written.bytes);
    out.text += fmt::format("\n  {}: {} in {}\n", command.out.string(), counted(file.triangles, "triangle"),
                            counted(file.strips, "strip")) +
                as_text(file.written, command.out.string());
  }
  if (trace_of_walk) {
    trace_of_walk->end();
    text_of_trace = std::move(trace_of_walk->text());
  }
  const bool valid = report.valid() && (!walk || walk->fault.empty());
  if (trace && valid) {
    trace->write(text_of_trace);
    out.text += fmt::format("\n  {}: to be checked by restrip-check\n", command.trace.string());
  }
  out.json = as_json(report, source.subject, walk);
  out.print();
  return valid ? 0 : 1;
}

}  // namespace

Subcommand add_replay(CLI::App& app) {
  const auto kept = std::make_shared<ReplayCommand>();
  ReplayCommand& command = *kept;
  CLI::App* sub =
      app.add_subcommand("replay", "Simplify a mesh, then replay every vertex split while maintaining its strips");
  CLI::Option* mesh = add_mesh_option(*sub, command.mesh, help_of_mesh(levels_kept));
  CLI::Option* built_in =
      sub->add_flag("--built-in", command.built_in, "a torus made by the program, instead of a file");
  mesh->excludes(built_in);
  CLI::Option* triangles =
      sub->add_option("--triangles", command.out_triangles,
                      "with --built-in the size of that mesh (default: 100000); with -o the least number of triangles "
                      "of the level that is written (default: the finest level)")
          ->check(whole_number_from(1, max_triangles));
  CLI::Option* output =
      add_output_option(*sub, command.out, extensions_of(writes_strips),
                        "writes a level with its strips, maintained under the policy: " + strip_formats())
          ->excludes(built_in);
  add_strip_options(*sub, command.strips, output);
  add_simplify_options(*sub, command.simplify);
  sub->add_option("--levels", command.replay.levels, "levels of detail to report")
      ->check(whole_number_from(2, 1000))
      ->capture_default_str();
  sub->add_option_function<std::size_t>(
         "--repeats",
         [&command](std::size_t repeats) {
           command.replay.repeats = repeats;
           command.replay.enough_operations = 0;
         },
         "timed runs; their median is reported; 0: no timing")
      ->check(whole_number_from(0, 1000))
      ->default_str(fmt::format("{}, more on small meshes", ReplayOptions().repeats));
  sub->add_option_function<std::string>(
         "--buffer",
         [&command](const std::string& word) {
           command.replay.buffer.form = word == "list" ? StripForm::list : StripForm::restart;
         },
         "the index buffer that is updated: strips, or a triangle list for comparison")
      ->check(one_of({"strips", "list"}))
      ->default_str("strips");
  sub->add_option("--operations-per-update", command.replay.buffer.operations_per_update,
                  "operations after which the index buffer is updated; several numbers: one run for each")
      ->delimiter(',')
      ->check(whole_number_from(1, 1'000'000'000))
      ->capture_default_str();
  sub->add_option("--cycles", command.replay.cycles, "times down to the base and up again")
      ->check(whole_number())
      ->capture_default_str();
  add_policy_option(*sub, command.policy);
  sub->add_option(
         "--states", command.states,
         "fixed number of states per search for quick and full; more leave fewer strips and take longer "
         "(default: the policy's, reduced if strips are long enough); with --cost indices: strip ends looked at after "
         "each operation")
      ->check(whole_number_from(1, 1'000'000));
  add_cost_option(*sub, command.cost);
  CLI::Option* walk =
      sub->add_option("--walk", command.walk_steps,
                      "then that many random splits, collapses and flips on the full mesh, under the policy")
          ->check(whole_number());
  sub->add_option("--seed", command.seed, "of the walk")->needs(walk)->check(whole_number())->capture_default_str();
  sub->add_option(
      "--trace", command.trace,
      "records the first refinement and coarsening for restrip-check, or with --walk the walk: each operation, the "
      "colours that it changed and the changes that it reported");
  add_mending_options(*sub, command.mending);
  add_json_option(*sub, command.json);
  sub->callback([=, &command] {
    if (mesh->empty() && built_in->empty()) throw CLI::RequiredError("mesh or --built-in");
    command.simplify_given = simplify_options_given(*sub);
    check_strip_options(*sub, command.out, command.strips);
    if (!triangles->empty() && built_in->empty() && output->empty())
      throw CLI::ValidationError("--triangles", "needs --built-in or -o");
    if (!triangles->empty() && !built_in->empty()) {
      if (command.out_triangles < least_made_triangles || command.out_triangles > most_made_triangles)
        throw CLI::ValidationError(
            "--triangles", fmt::format("of a built-in mesh are {} to {}", least_made_triangles, most_made_triangles));
      command.built_in_triangles = command.out_triangles;
    }
    if (sub->count("--states") != 0 && (command.policy.empty() || !method_named(command.policy).searches()))
      throw CLI::ValidationError(
          "--states",
          fmt::format("only --policy {} search", fmt::join(names_of_methods(&Method::searches), " and --policy ")));
    refuse_cost_elsewhere(command.cost, command.policy);
  });
  sub->footer("Example: restrip replay bunny.obj --base 0.02 --cycles 10 --json bunny.json");
  return {sub, [kept] { return run(*kept); }};
}

}  // namespace restrip::tools
