// Options that several subcommands have, and how help shows them.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/named_file.hpp"
#include "lod/simplify.hpp"
#include "meshes/mend.hpp"
#include "meshes/mesh_file.hpp"
#include "meshes/strip_file.hpp"
#include "replay/ways.hpp"

namespace restrip::tools {

/// CLI11 takes -1 for the largest number there is, and a number that is too large as well.
[[nodiscard]] const CLI::Validator& whole_number();

/// ".obj, .off and .ply"; `last_word` is "and" or "or".
[[nodiscard]] std::string list_in_words(const std::vector<std::string>& words, const std::string& last_word);
/// Help of a mesh that is read: its formats (mesh_formats.hpp), and what becomes of one that has levels.
[[nodiscard]] std::string help_of_mesh(const std::string& of_levels = "the finest level");
inline const std::string levels_kept = "all levels as they are";
/// The formats in which strips are written.
[[nodiscard]] std::string strip_formats();

/// A mesh that is read, and --from. Returns the first.
CLI::Option* add_mesh_option(CLI::App& app, NamedFile& mesh, const std::string& help);
/// -o, and --to with these formats, given by their extensions. Returns the first.
CLI::Option* add_output_option(CLI::App& app, NamedFile& out, const std::vector<std::string>& extensions,
                               const std::string& help);

/// For outputs that may carry them.
void add_attributes_option(CLI::App& app, ReadAttributes& attributes);
void add_mending_options(CLI::App& app, MendingOptions& options);
void add_simplify_options(CLI::App& app, SimplifyOptions& options);
[[nodiscard]] bool simplify_options_given(const CLI::App& app);
void add_json_option(CLI::App& app, std::string& json);
/// `otherwise`: the cost where none is given, which help tells.
void add_cost_option(CLI::App& app, std::optional<Cost>& cost, const Cost& otherwise = default_cost);
/// --policy, by the names of ways.hpp.
void add_policy_option(CLI::App& app, std::string& way);
/// The ways of which that holds, by name.
[[nodiscard]] std::vector<std::string> names_of_ways(bool (Way::*holds)() const noexcept);
/// Throws CLI::ValidationError where the way, if one is named, knows no such cost.
void refuse_cost_elsewhere(const std::optional<Cost>& cost, const std::string& way);
/// --gltf for .glb, --form for .bin, and for both --index, --batch-vertices and --batch-indices. They need the option
/// `output`, if there is one. Where `progressive` is not null, --gltf progressive sets it: all levels, as
/// MANYFOLD_mesh_progressive. refuse_strip_options_elsewhere() throws CLI::ValidationError for another output.
void add_strip_options(CLI::App& app, StripOptions& options, CLI::Option* output = nullptr,
                       bool* progressive = nullptr);
void refuse_strip_options_elsewhere(const CLI::App& app, const NamedFile& out);

/// Values of options in words for people: "a|b", "from 2 to 1000".
class PlainFormatter : public CLI::Formatter {
 public:
  [[nodiscard]] std::string make_option_opts(const CLI::Option* option) const override;
};

/// A sentence about a first argument that is not a subcommand, with the one whose name is nearest, if any is near;
/// empty when it is one, or an option.
[[nodiscard]] std::string wrong_subcommand(const CLI::App& app, const std::string& argument);

}  // namespace restrip::tools
