// The subcommands of `restrip`, one file each: NAME_command.cpp has its options, its command line and what it does. And
// the options that several share, and how help shows them.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "common/output.hpp"
#include "lod/mesh_files.hpp"
#include "lod/simplify.hpp"
#include "meshes/mend.hpp"
#include "meshes/mesh_file.hpp"
#include "meshes/strip_file.hpp"
#include "replay/methods.hpp"

namespace restrip::tools {

/// The report of a command: text for people and the members of a JSON object, printed together at the end.
struct Report {
  /// `file`: the argument of --json. Throws BadInput before the work if it cannot be written.
  explicit Report(const std::string& file) : out(file) {}

  void add(const Mended& mended) {
    text += as_text(mended);
    add_to(json, mended);
  }
  /// `name`: of the file that was written.
  void add(const WrittenStrips& written, const std::string& name) {
    text += as_text(written, name);
    add_to(json, written);
  }
  /// Names may contain bytes that are not UTF-8.
  [[nodiscard]] std::string json_text() const {
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
  }
  void print() const { out.print(text, json_text()); }

  files::ReportOutput out;
  std::string text;
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
};

/// A subcommand of the command line. `run` executes it after parsing and returns the exit code: 0, or 1 if a check
/// failed or simplify stopped short. It throws BadInput on bad input.
struct Subcommand {
  CLI::App* line;
  std::function<int()> run;
};

Subcommand add_stats(CLI::App& app);
Subcommand add_replay(CLI::App& app);
Subcommand add_simplify(CLI::App& app);
Subcommand add_convert(CLI::App& app);
Subcommand add_stripify(CLI::App& app);
Subcommand add_draw(CLI::App& app);
Subcommand add_paper(CLI::App& app);
Subcommand add_bake(CLI::App& app);
Subcommand add_make_mesh(CLI::App& app);

/// CLI11 alone parses -1 and numbers that are too large as the largest value.
[[nodiscard]] const CLI::Validator& whole_number();
[[nodiscard]] CLI::Validator whole_number_from(std::uint64_t least, std::uint64_t most);

/// One of these words. An error lists them.
[[nodiscard]] CLI::Validator one_of(const std::vector<std::string>& words);

/// ".obj, .off and .ply"; `last_word` is "and" or "or".
[[nodiscard]] std::string list_in_words(const std::vector<std::string>& words, const std::string& last_word);
/// Help text for an input mesh: its formats (mesh_formats.hpp), and which level is used of a mesh that has levels.
[[nodiscard]] std::string help_of_mesh(const std::string& of_levels = "the finest level");
inline const std::string levels_kept = "all levels as they are";
/// The formats that can hold strips.
[[nodiscard]] std::string strip_formats();

/// Adds the input mesh and --from. Returns the first.
CLI::Option* add_mesh_option(CLI::App& app, NamedFile& mesh, const std::string& help);
/// Adds -o, and --to with these formats, given by their extensions. Returns the first.
CLI::Option* add_output_option(CLI::App& app, NamedFile& out, const std::vector<std::string>& extensions,
                               const std::string& help);

/// Adds the option for outputs that may have attributes.
void add_attributes_option(CLI::App& app, ReadAttributes& attributes);
void add_mending_options(CLI::App& app, MendingOptions& options);
void add_simplify_options(CLI::App& app, SimplifyOptions& options);
[[nodiscard]] bool simplify_options_given(const CLI::App& app);
void add_json_option(CLI::App& app, std::string& json);
/// Adds --cost. `otherwise` is the default, which help shows.
void add_cost_option(CLI::App& app, std::optional<Cost>& cost, const Cost& otherwise = default_cost);
/// Adds --policy, whose values are the names in methods.hpp.
void add_policy_option(CLI::App& app, std::string& method);
/// The names of the methods for which `holds` is true.
[[nodiscard]] std::vector<std::string> names_of_methods(bool (Method::*holds)() const noexcept);
/// Throws CLI::ValidationError if the method is named and does not support the cost.
void refuse_cost_elsewhere(const std::optional<Cost>& cost, const std::string& method);
/// Adds --gltf for .glb, --form for .bin, for both --index, --batch-vertices and --batch-indices, and --keep-strips,
/// which also works for .ply. They require the option `output`, if any. If `progressive` is not null, --gltf
/// progressive sets it: all levels, as MANYFOLD_mesh_progressive.
void add_strip_options(CLI::App& app, StripOptions& options, CLI::Option* output = nullptr,
                       bool* progressive = nullptr);
/// Throws CLI::ValidationError for an option that the output does not have; notes the output's name.
void check_strip_options(const CLI::App& app, const NamedFile& out, StripOptions& options);

/// Shows the values of options in words: "a|b", "from 2 to 1000".
class PlainFormatter : public CLI::Formatter {
 public:
  [[nodiscard]] std::string make_option_opts(const CLI::Option* option) const override;
};

/// An error message for a first argument that is neither a subcommand nor an option. Empty if the argument is valid.
[[nodiscard]] std::string wrong_subcommand(const CLI::App& app, const std::string& argument);

}  // namespace restrip::tools
