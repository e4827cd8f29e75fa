// restrip: look at a mesh, simplify it, replay its levels of detail with their strips kept by the rules.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "app/options.hpp"
#include "common/bad_input.hpp"
#include "files/reading.hpp"
#include "files/system_calls.hpp"
#include "meshes/mesh_file.hpp"
#include "meshes/soup_builder.hpp"
#include "replay/ways.hpp"

namespace {

using namespace restrip::tools;

constexpr int exit_bad_input = 2;

CLI::App* add_stats(CLI::App& app, StatsCommand& command) {
  CLI::App* sub = app.add_subcommand("stats", "Count what a mesh has: triangles per vertex, boundary, faults");
  sub->add_option("mesh", command.mesh,
                  mesh_formats() + "; a progressive mesh (.pm) or a baked one (.baked, .glb): its base")
      ->required();
  add_mending_options(*sub, command.mending);
  add_json_option(*sub, command.json);
  sub->footer("Example: restrip stats bunny.obj");
  return sub;
}

CLI::App* add_replay(CLI::App& app, ReplayCommand& command) {
  CLI::App* sub = app.add_subcommand("replay", "Simplify a mesh, then replay every vertex split with its strips kept");
  CLI::Option* mesh = sub->add_option("mesh", command.mesh,
                                      mesh_formats() + "; a progressive mesh (.pm) or a baked one (.baked, .glb)");
  CLI::Option* built_in =
      sub->add_flag("--built-in", command.built_in, "a torus made by the program, instead of a file");
  mesh->excludes(built_in);
  CLI::Option* triangles =
      sub->add_option(
             "--triangles", command.out_triangles,
             "with --built-in the size of that mesh (default: 100000); with -o the least size of the level that "
             "is written (default: the finest)")
          ->check(CLI::Range(std::size_t{1}, max_triangles));
  CLI::Option* output = sub->add_option("-o,--output", command.out,
                                        "writes a level with its strips, kept under the policy: " + strip_formats())
                            ->excludes(built_in);
  CLI::Option* gltf = add_gltf_option(*sub, command.gltf)->needs(output);
  add_simplify_options(*sub, command.simplify);
  sub->add_option("--levels", command.replay.levels, "levels of detail to report")
      ->check(CLI::Range(2, 1000))
      ->capture_default_str();
  sub->add_option("--repeats", command.replay.repeats, "timed runs, of which the median counts; 0: no timing")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  sub->add_option_function<std::string>(
         "--buffer",
         [&command](const std::string& word) {
           command.replay.buffer = word == "list" ? ReplayOptions::Buffer::list : ReplayOptions::Buffer::strips;
         },
         "the index buffer that is kept in step: strips, or a plain list of triangles to compare with")
      ->check(CLI::IsMember({"strips", "list"}))
      ->default_str("strips");
  sub->add_option_function<std::string>(
         "--handles", [&command](const std::string& word) { command.handles_along_strips = word == "strips"; },
         "how triangles lie in memory: in the order of the splits, or along the strips of the finest level to compare "
         "with; baked strips know the former alone")
      ->check(CLI::IsMember({"splits", "strips"}))
      ->default_str("splits");
  sub->add_option("--cycles", command.replay.cycles, "ways down to the base and up again")
      ->check(whole_number())
      ->capture_default_str();
  add_policy_option(*sub, command.way);
  sub->add_option(
         "--states", command.states,
         "of each search of the policies quick and full: always so many; more keep fewer strips and take "
         "longer (default: "
         "the policy's own, fewer where strips are long enough); with --cost indices: strip ends looked at after each "
         "operation")
      ->check(CLI::Range(1, 1'000'000));
  add_cost_option(*sub, command.cost);
  CLI::Option* walk =
      sub->add_option("--walk", command.walk_steps,
                      "then that many random splits, collapses and flips on the full mesh, under the policy")
          ->check(whole_number());
  sub->add_option("--seed", command.seed, "of the walk")->needs(walk)->check(whole_number())->capture_default_str();
  add_mending_options(*sub, command.mending);
  add_json_option(*sub, command.json);
  sub->callback([=, &command] {
    if (mesh->empty() && built_in->empty()) throw CLI::RequiredError("mesh or --built-in");
    command.simplify_given = simplify_options_given(*sub);
    refuse_gltf_elsewhere(*gltf, command.out);
    if (!triangles->empty() && built_in->empty() && output->empty())
      throw CLI::ValidationError("--triangles", "wants --built-in or -o");
    if (!triangles->empty() && !built_in->empty()) {
      if (command.out_triangles < least_made_triangles || command.out_triangles > most_made_triangles)
        throw CLI::ValidationError(
            "--triangles", fmt::format("of a built-in mesh are {} to {}", least_made_triangles, most_made_triangles));
      command.built_in_triangles = command.out_triangles;
    }
    if (sub->count("--states") != 0 && (command.way.empty() || !way_named(command.way).searches()))
      throw CLI::ValidationError("--states", fmt::format("only --policy {} search",
                                                         fmt::join(names_of_ways(&Way::searches), " and --policy ")));
    refuse_cost_elsewhere(command.cost, command.way);
  });
  sub->footer("Example: restrip replay bunny.obj --base 0.02 --cycles 10 --json bunny.json");
  return sub;
}

CLI::App* add_simplify(CLI::App& app, SimplifyCommand& command) {
  CLI::App* sub = app.add_subcommand("simplify", "Simplify a mesh and write it, or the way back as a progressive mesh");
  sub->add_option("mesh", command.mesh, mesh_formats())->required();
  sub->add_option(
         "-o,--output", command.out,
         ".pm: a progressive mesh as OpenMesh writes it; or the coarsest level with strips: " + strip_formats())
      ->required();
  CLI::Option* triangles =
      sub->add_option("--triangles", command.simplify.triangles, "of the coarsest level, in place of --base")
          ->check(CLI::Range(std::size_t{1}, max_triangles));
  add_simplify_options(*sub, command.simplify);
  const CLI::Option* gltf = add_gltf_option(*sub, command.gltf);
  sub->add_flag_callback(
      "--attributes", [&command] { command.attributes = ReadAttributes::yes; },
      "keep normals, texture coordinates and colours: where they differ one place is several vertices, and such seams "
      "are boundaries, which stay unless --boundary move is given");
  add_mending_options(*sub, command.mending);
  add_json_option(*sub, command.json);
  sub->callback([sub, triangles, gltf, &command] {
    // Both sides of a seam would move on their own.
    if (command.attributes == ReadAttributes::yes && sub->count("--boundary") == 0)
      command.simplify.boundary = BoundaryPolicy::lock;
    refuse_gltf_elsewhere(*gltf, command.out);
    command.size_given = triangles->count() + sub->count("--base") != 0;
    if (!triangles->empty() && sub->count("--base") != 0)
      throw CLI::ValidationError("--triangles", "and --base say the same thing twice; leave one out");
  });
  sub->footer(
      "Where no edge that is left may collapse, the mesh is written as coarse as it got, and standard error and\n"
      "--json say why. The exit code is 1 then, if --base or --triangles asked for a coarser one.\n"
      "Example: restrip simplify bunny.obj --base 0.01 -o bunny.pm");
  return sub;
}

CLI::App* add_convert(CLI::App& app, ConvertCommand& command) {
  CLI::App* sub = app.add_subcommand("convert", "Write a mesh in another format; strips of the file stay strips");
  sub->add_option("mesh", command.mesh, mesh_formats() + "; or a baked mesh (.baked, .glb)")->required();
  sub->add_option("-o,--output", command.out,
                  list_in_words(converted_extensions(), "or") +
                      "; .bin, .ply and .glb with the strips of the file; .ply and .glb without, where it has none; "
                      ".baked and .glb from a baked mesh, with all its levels")
      ->required();
  const CLI::Option* gltf = add_gltf_option(*sub, command.gltf);
  add_attributes_option(*sub, command.attributes);
  add_mending_options(*sub, command.mending);
  add_json_option(*sub, command.json);
  sub->callback([gltf, &command] {
    refuse_gltf_elsewhere(*gltf, command.out);
    command.gltf_given = !gltf->empty();
  });
  sub->footer("Example: restrip convert scan.ply --weld -o scan.glb");
  return sub;
}

CLI::App* add_bake(CLI::App& app, BakeCommand& command) {
  CLI::App* sub =
      app.add_subcommand("bake", "Decide the strips of every level of detail and write them beside the mesh");
  sub->add_option("mesh", command.mesh, mesh_formats() + "; or a progressive mesh (.pm)")->required();
  sub->add_option("-o,--output", command.out,
                  ".baked; or .glb, whose mesh is the base, with all levels in an extension (RESTRIP_baked_strips)")
      ->required();
  add_simplify_options(*sub, command.simplify);
  sub->add_option("--effort", command.bake.effort,
                  "edges walked to save one strip, before search goes further away; with --cost indices 500 of them "
                  "are one look "
                  "at a strip end, of which each record has so many")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1'000'000'000'000}))
      ->capture_default_str();
  add_cost_option(*sub, command.bake.cost);
  add_mending_options(*sub, command.mending);
  add_json_option(*sub, command.json);
  const CLI::Option* gltf = add_gltf_option(*sub, command.gltf);
  sub->callback([sub, gltf, &command] {
    refuse_gltf_elsewhere(*gltf, command.out);
    command.simplify_given = simplify_options_given(*sub);
  });
  sub->footer("Example: restrip bake bunny.obj -o bunny.baked");
  return sub;
}

CLI::App* add_make_mesh(CLI::App& app, MakeMeshCommand& command) {
  CLI::App* sub =
      app.add_subcommand("make-mesh", "Make a closed mesh of irregular valences, the same on every machine");
  sub->add_option("-o,--output", command.out, "a file that ends in " + list_in_words(written_mesh_extensions(), "or"))
      ->required();
  sub->add_option("--triangles", command.triangles, "about how many")
      ->check(CLI::Range(least_made_triangles, most_made_triangles))
      ->capture_default_str();
  sub->add_option("--seed", command.seed, "of its irregularities")->check(whole_number())->capture_default_str();
  add_json_option(*sub, command.json);
  sub->footer("Example: restrip make-mesh --triangles 1000000 -o torus.ply");
  return sub;
}

CLI::App* add_stripify(CLI::App& app, StripifyCommand& command) {
  CLI::App* sub = app.add_subcommand("stripify", "Make the strips of a mesh from scratch, and write them");
  sub->add_option("mesh", command.mesh, mesh_formats())->required();
  sub->add_option("-o,--output", command.out, strip_formats());
  const auto* gltf = add_gltf_option(*sub, command.gltf);
  const auto* effort = sub->add_option_function<std::string>(
                              "--effort",
                              [&command](const std::string& word) {
                                command.as_in_file = word == "file";
                                command.effort = word == "full"   ? restrip::Effort::full
                                                 : word == "best" ? restrip::Effort::best
                                                                  : restrip::Effort::fast;
                              },
                              "fast: one pass; full: a search or annealing; best: ten times longer; file: the strips "
                              "that the file has")
                           ->check(CLI::IsMember({"fast", "full", "best", "file"}))
                           ->default_str("fast");
  add_cost_option(*sub, command.cost);
  const auto* limit =
      sub->add_option("--limit", command.limit,
                      "of --effort full and best, for each triangle: states of searches with --cost strips (default: "
                      "40, 1000), moves of annealing with --cost indices (100, 1000)")
          ->check(CLI::Range(1, 1'000'000));
  const auto* seed =
      sub->add_option("--seed", command.seed, "of annealing")->check(whole_number())->capture_default_str();
  sub->add_option_function<std::string>(
         "--order", [&command](const std::string& word) { command.order_for_cache = word == "cache"; },
         "of the strips: that of the triangles, or one that a vertex cache of 16 misses less often; as many indices")
      ->check(CLI::IsMember({"triangles", "cache"}))
      ->default_str("triangles");
  add_attributes_option(*sub, command.attributes);
  add_mending_options(*sub, command.mending);
  add_json_option(*sub, command.json);
  sub->callback([sub, gltf, effort, limit, seed, &command] {
    refuse_gltf_elsewhere(*gltf, command.out);
    if (command.as_in_file && sub->count("--cost") != 0)
      throw CLI::ValidationError("--cost", "--effort file takes the strips as they are");
    const bool anneals = command.effort != restrip::Effort::fast && !(command.cost == restrip::Cost::strips());
    if (*limit && command.effort == restrip::Effort::fast)
      throw CLI::ValidationError("--limit", fmt::format("only {} full and best have one", effort->get_name()));
    if (*seed && !anneals)
      throw CLI::ValidationError("--seed", "only --effort full and best with --cost indices draw at random");
  });
  sub->footer("Example: restrip stripify bunny.obj --effort full --cost indices -o bunny.glb");
  return sub;
}

CLI::App* add_draw(CLI::App& app, DrawCommand& command) {
  CLI::App* sub =
      app.add_subcommand("draw", "Draw a mesh at a level of detail, with its strips kept as replay keeps them");
  sub->add_option("mesh", command.mesh,
                  mesh_formats() + "; a progressive mesh (.pm) or a baked one (.baked, .glb); else a torus");
  sub->add_option("-o,--output", command.out,
                  ".svg, .png, or .json: the mesh, its strips and a rule, from which scripts/pictures.py draws")
      ->required();
  sub->add_option("--triangles", command.triangles, "the least size of the level (default: the finest)")
      ->check(CLI::Range(std::size_t{1}, max_triangles));
  add_simplify_options(*sub, command.simplify);
  add_policy_option(*sub, command.way);
  add_cost_option(*sub, command.cost);
  const std::vector<const CLI::Option*> only_pictures = add_picture_options(*sub, command);
  add_mending_options(*sub, command.mending);
  add_json_option(*sub, command.json);
  sub->callback([sub, only_pictures, &command] {
    command.simplify_given = simplify_options_given(*sub);
    refuse_cost_elsewhere(command.cost, command.way);
    for (const CLI::Option* option : only_pictures)
      if (!option->empty() && restrip::files::extension_of(command.out) == ".json")
        throw CLI::ValidationError(option->get_name(), "only pictures have one: .svg and .png");
  });
  sub->footer(
      "Triangles that face away from the camera are not drawn. A file that has strips is drawn with them, unless\n"
      "--triangles, --policy, --cost, --base or --boundary asks for others. --base 1 draws strips from scratch.\n"
      "Example: restrip draw bunny.obj --policy linked --triangles 5000 --camera 20,10 -o bunny.png");
  return sub;
}

CLI::App* add_paper(CLI::App& app, PaperCommand& command) {
  CLI::App* sub =
      app.add_subcommand("paper", "Do the paper's figures and experiments again, as CSV files and a report");
  sub->add_option("-o,--out", command.out, "the folder for report.json and CSV files")->required();
  sub->add_option("meshes", command.meshes, mesh_formats() + "; or progressive meshes (.pm)")->required();
  add_simplify_options(*sub, command.options.simplify);
  sub->add_option("--levels", command.options.levels, "levels of detail to count strips at")
      ->check(CLI::Range(2, 1000))
      ->capture_default_str();
  add_mending_options(*sub, command.mending);
  add_json_option(*sub, command.json);
  sub->footer("Example: restrip paper --out report bunny.obj\nscripts/paper_page.py makes a page of the folder.");
  return sub;
}

int run_command_line(int argc, char** argv) {
  CLI::App app{"Triangle strips kept while the mesh changes, by local repairs proven optimal", "restrip"};
  app.set_version_flag("--version", std::string("restrip ") + RESTRIP_VERSION);
  app.require_subcommand(1);
  app.formatter(std::make_shared<PlainFormatter>());
  constexpr restrip::files::ReadLimits limits;
  app.footer(fmt::format(
      "Exit codes: 0 all is well, 1 a check failed or simplify stopped short, 2 the input or the command line is at "
      "fault.\n"
      "Limits: files of {}, pipes and devices of {}, lines of text of {}.\n"
      "Outputs appear whole or not at all; they must not be inputs and must end as their format does.\n"
      "Example: restrip replay --built-in",
      restrip::files::size_in_words(limits.regular), restrip::files::size_in_words(limits.endless),
      restrip::files::size_in_words(longest_line)));
  StatsCommand stats;
  ReplayCommand replay;
  SimplifyCommand simplify;
  ConvertCommand convert;
  MakeMeshCommand make_mesh;
  DrawCommand draw;
  StripifyCommand stripify;
  PaperCommand paper;
  BakeCommand bake;
  const CLI::App* stats_sub = add_stats(app, stats);
  const CLI::App* replay_sub = add_replay(app, replay);
  const CLI::App* simplify_sub = add_simplify(app, simplify);
  const CLI::App* convert_sub = add_convert(app, convert);
  const CLI::App* stripify_sub = add_stripify(app, stripify);
  const CLI::App* draw_sub = add_draw(app, draw);
  const CLI::App* paper_sub = add_paper(app, paper);
  const CLI::App* bake_sub = add_bake(app, bake);
  add_make_mesh(app, make_mesh);
  if (const std::string wrong = argc < 2 ? "" : wrong_subcommand(app, argv[1]); !wrong.empty()) throw BadInput(wrong);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : exit_bad_input;
  }
  if (stats_sub->parsed()) return run(stats);
  if (replay_sub->parsed()) return run(replay);
  if (simplify_sub->parsed()) return run(simplify);
  if (convert_sub->parsed()) return run(convert);
  if (stripify_sub->parsed()) return run(stripify);
  if (draw_sub->parsed()) return run(draw);
  if (paper_sub->parsed()) return run(paper);
  if (bake_sub->parsed()) return run(bake);
  return run(make_mesh);
}

}  // namespace

int main(int argc, char** argv) {
  restrip::files::ignore_file_size_signal();
  try {
    const int code = run_command_line(argc, argv);
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
    fmt::print(stderr, "restrip: the output could not be written\n");
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "restrip: not enough memory for a mesh of this size\n");
  } catch (const std::exception& error) {
    fmt::print(stderr, "restrip: {}\n", error.what());
  }
  return exit_bad_input;
}
