// The subcommands of `restrip`, free of any command line: what each wants to know, and what it does. Each returns the
// exit code: 0, or 1 when a check failed; bad input is thrown (BadInput). `json` is the argument of --json
// (report_output.hpp): a file, - for standard output, or empty.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "lod/bake.hpp"
#include "lod/simplify.hpp"
#include "meshes/made_mesh.hpp"
#include "meshes/mend.hpp"
#include "meshes/strip_file.hpp"
#include "paper/paper.hpp"
#include "pictures/scene.hpp"
#include "replay/replay.hpp"
#include "restrip/search/stripify.hpp"

namespace restrip::tools {

struct StatsCommand {
  std::filesystem::path mesh;
  MendingOptions mending;
  std::string json;
};
int run(const StatsCommand& command);

struct ReplayCommand {
  std::filesystem::path mesh;  ///< may be a progressive mesh (.pm, .baked): then it is replayed as it is
  bool built_in = false;       ///< make a mesh instead
  std::size_t built_in_triangles = default_made_triangles;
  SimplifyOptions simplify;
  bool simplify_given = false;  ///< by the caller, not by default: refused where nothing is simplified
  ReplayOptions replay;
  std::string way;                    ///< its name; empty: the usual one (ways.hpp)
  std::uint32_t states = 0;           ///< of each search of a way that searches; 0: its own
  Cost cost = Cost::strips();         ///< what is kept low
  bool handles_along_strips = false;  ///< else in the order of the splits (Plan::Given)
  std::uint64_t walk_steps = 0;
  std::uint64_t seed = 1;
  std::filesystem::path out;      ///< where a level is written, with its strips; empty: nowhere
  std::size_t out_triangles = 0;  ///< of that level, at least; 0: the finest one
  GltfPrimitives gltf = GltfPrimitives::strips;
  MendingOptions mending;
  std::string json;
};
int run(const ReplayCommand& command);

struct SimplifyCommand {
  std::filesystem::path mesh;
  std::filesystem::path out;  ///< .pm: a progressive mesh; else its base, with strips from scratch
  GltfPrimitives gltf = GltfPrimitives::strips;
  SimplifyOptions simplify;
  bool size_given = false;  ///< by the caller, not by default: then it is a failure to stop short of it
  ReadAttributes attributes = ReadAttributes::no;  ///< kept: vertices that differ in them are several
  MendingOptions mending;
  std::string json;
};
int run(const SimplifyCommand& command);

/// A mesh in another format. Strips of the file stay where the new format has strips; a baked mesh stays one.
struct ConvertCommand {
  std::filesystem::path mesh;
  std::filesystem::path out;
  GltfPrimitives gltf = GltfPrimitives::strips;
  bool gltf_given = false;  ///< then a mesh without strips is refused but for a list
  ReadAttributes attributes = ReadAttributes::yes;
  MendingOptions mending;
  std::string json;
};
int run(const ConvertCommand& command);
[[nodiscard]] std::vector<std::string> converted_extensions();

struct BakeCommand {
  std::filesystem::path mesh;
  std::filesystem::path out;
  SimplifyOptions simplify;
  bool simplify_given = false;
  BakeOptions bake;
  GltfPrimitives gltf = GltfPrimitives::strips;
  MendingOptions mending;
  std::string json;
};
int run(const BakeCommand& command);
/// In which baked meshes are written.
[[nodiscard]] std::vector<std::string> baked_extensions();

struct MakeMeshCommand {
  std::filesystem::path out;
  std::size_t triangles = default_made_triangles;
  std::uint64_t seed = 1;
  std::string json;
};
int run(const MakeMeshCommand& command);

struct StripifyCommand {
  std::filesystem::path mesh;
  std::filesystem::path out;  ///< empty: the strips are counted and not written
  GltfPrimitives gltf = GltfPrimitives::strips;
  bool as_in_file = false;  ///< the strips that the file has, in place of the next four
  Effort effort = Effort::fast;
  Cost cost = Cost::strips();
  std::uint64_t limit = 0;  ///< of stripify(), for each triangle; 0: its own
  std::uint64_t seed = 1;
  bool order_for_cache = false;  ///< strips are written in an order for a vertex cache, not in that of the triangles
  ReadAttributes attributes = ReadAttributes::yes;
  MendingOptions mending;
  std::string json;
};
int run(const StripifyCommand& command);

/// A mesh and its strips at one level as a picture (.svg, .png); or what scripts/pictures.py needs to draw the picture
/// of the README (.json): the same, and the rule of one split. A file that has strips is drawn with them, unless the
/// level, the policy, the cost or the base is named.
struct DrawCommand {
  std::filesystem::path mesh;  ///< may be a progressive mesh; empty: the built-in mesh
  std::filesystem::path out;
  SimplifyOptions simplify;
  bool simplify_given = false;
  std::string way;             ///< its name; empty: the usual one (ways.hpp)
  Cost cost = Cost::strips();  ///< what is kept low
  std::size_t triangles = 0;   ///< of the level, at least; 0: the finest one
  Camera camera;
  PictureSize size;
  StripStyle style = StripStyle::faces;
  MendingOptions mending;
  std::string json;
};
int run(const DrawCommand& command);
[[nodiscard]] std::vector<std::string> drawn_extensions();

/// The paper's figures and experiments, as CSV files and a report in JSON (paper_report.hpp). Files are written whole,
/// the report last.
struct PaperCommand {
  std::filesystem::path out;  ///< a folder; made when it is not there
  std::vector<std::filesystem::path> meshes;
  MendingOptions mending;
  PaperOptions options;
  std::string json;
};
int run(const PaperCommand& command);

}  // namespace restrip::tools
