#include "app/options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "lod/mesh_formats.hpp"
#include "meshes/text_cursor.hpp"

namespace restrip::tools {
namespace {

const CLI::Validator share(
    [](std::string& word) {
      const auto number = parse<double>(word);
      return number && *number > 0 && *number <= 1
                 ? std::string()
                 : fmt::format("{} is not a share of the triangles; give a number above 0 and at most 1", word);
    },
    "X above 0 and at most 1", "share");

/// The values of an option: the description of its check, if it has one, which follows CLI11's name of the type.
std::string values_in_words(const std::string& type) {
  if (const std::size_t colon = type.find(':'); colon != std::string::npos) return type.substr(colon + 1);
  return type.starts_with("TEXT") ? "FILE" : "N";
}

std::vector<std::string> without_points(std::vector<std::string> extensions) {
  for (std::string& extension : extensions) extension.erase(0, 1);
  return extensions;
}

constexpr std::array strip_options{"--gltf",           "--form",          "--index",
                                   "--batch-vertices", "--batch-indices", "--keep-strips"};

std::string names_of(const std::set<CLI::Option*>& options) {
  std::vector<std::string> names;
  names.reserve(options.size());
  for (const CLI::Option* option : options) names.push_back(option->get_name());
  return list_in_words(names, "and");
}

}  // namespace

const CLI::Validator& whole_number() {
  static const CLI::Validator validator(
      [](std::string& word) {
        return parse<std::uint64_t>(word) ? std::string() : fmt::format("{} is not a whole number below 2^64", word);
      },
      "", "whole number");
  return validator;
}

CLI::Validator whole_number_from(std::uint64_t least, std::uint64_t most) {
  return {[least, most](std::string& word) {
            const auto number = parse<std::uint64_t>(word);
            return number && *number >= least && *number <= most
                       ? std::string()
                       : fmt::format("{} is not a whole number from {} to {}", word, least, most);
          },
          fmt::format("N from {} to {}", least, most), "whole number in a range"};
}

CLI::Validator one_of(const std::vector<std::string>& words) {
  return {[words](std::string& word) {
            return std::find(words.begin(), words.end(), word) != words.end()
                       ? std::string()
                       : fmt::format("{} is not a value; there are {}", word.substr(0, 40),
                                     list_in_words(words, "and"));
          },
          fmt::format("{}", fmt::join(words, "|")), "one of several words"};
}

std::string list_in_words(const std::vector<std::string>& words, const std::string& last_word) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i != 0) text += i + 1 == words.size() ? " " + last_word + " " : ", ";
    text += words[i];
  }
  return text;
}

std::string help_of_mesh(const std::string& of_levels) {
  return fmt::format("{}; of a progressive or a baked mesh {}", list_in_words(extensions_of(reads), "or"), of_levels);
}

std::string strip_formats() {
  std::vector<std::string> words;
  for (const MeshFormat& format : mesh_formats())
    if (writes_strips(format))
      words.push_back(std::string(format.extension) +
                      (format.strips_as.empty() ? "" : fmt::format(" ({})", format.strips_as)));
  return list_in_words(words, "or");
}

CLI::Option* add_mesh_option(CLI::App& app, NamedFile& mesh, const std::string& help) {
  CLI::Option* option = app.add_option("mesh", mesh.path, help + "; - for standard input");
  app.add_option("--from", mesh.format,
                 "the format of the mesh; by default detected from its name, or from its first bytes")
      ->check(one_of(without_points(extensions_of(reads))));
  return option;
}

CLI::Option* add_output_option(CLI::App& app, NamedFile& out, const std::vector<std::string>& extensions,
                               const std::string& help) {
  CLI::Option* option =
      app.add_option("-o,--output", out.path, help + "; - for standard output, text then goes to standard error");
  app.add_option("--to", out.format, "the format of the output; by default from its name")
      ->check(one_of(without_points(extensions)))
      ->needs(option);
  return option;
}

void add_attributes_option(CLI::App& app, ReadAttributes& attributes) {
  app.add_flag_callback(
      "--no-attributes", [&attributes] { attributes = ReadAttributes::no; },
      "read only positions; --weld then merges vertices that differ in normals, texture coordinates or colours");
}

void add_mending_options(CLI::App& app, MendingOptions& options) {
  app.add_flag("--weld", options.weld, "merge vertices at the same place; strips end at seams that remain");
  app.add_flag("--orient", options.orient,
               "reverse triangles until neighbours agree; strips end at edges at which they do not");
}

void add_simplify_options(CLI::App& app, SimplifyOptions& options) {
  app.add_option("--base", options.base, "share of the triangles that the coarsest level keeps")
      ->check(share)
      ->capture_default_str();
  app.add_option_function<std::string>(
         "--boundary",
         [&options](const std::string& word) {
           options.boundary = word == "lock" ? BoundaryPolicy::lock : BoundaryPolicy::move;
         },
         "lock: only edges between interior vertices collapse\nmove: boundary edges too")
      ->check(one_of({"lock", "move"}))
      ->default_str(options.boundary == BoundaryPolicy::lock ? "lock" : "move");
}

bool simplify_options_given(const CLI::App& app) { return app.count("--base") + app.count("--boundary") != 0; }

void add_json_option(CLI::App& app, std::string& json) {
  app.add_option("--json", json, "write the report as JSON to this file; - for standard output, in place of the text");
}

void add_cost_option(CLI::App& app, std::optional<Cost>& cost, const Cost& otherwise) {
  app.add_option_function<std::string>(
         "--cost", [&cost](const std::string& word) { cost = word == "indices" ? Cost::indices() : Cost::strips(); },
         "what is minimised: strips, or the indices of plain triangle strips with primitive restart")
      ->check(one_of({"strips", "indices"}))
      ->default_str(otherwise == Cost::strips() ? "strips" : "indices");
}

std::vector<std::string> names_of_methods(bool (Method::*holds)() const noexcept) {
  std::vector<std::string> names;
  for (const Method& method : methods())
    if (method.kind != Method::Kind::mesh && (method.*holds)()) names.push_back(method.name);
  return names;
}

void add_policy_option(CLI::App& app, std::string& method) {
  std::vector<std::string> names;
  std::string about;
  for (const Method& each : methods()) {
    if (each.kind == Method::Kind::mesh) continue;
    names.push_back(each.name);
    about += fmt::format("{}: {}\n", each.name, each.description);
  }
  app.add_option(
         "--policy", method,
         about + fmt::format("default: {}, for a baked mesh {}", default_method(false).name, default_method(true).name))
      ->check(one_of(names));
}

void refuse_cost_elsewhere(const std::optional<Cost>& cost, const std::string& method) {
  if (cost && !(*cost == Cost::strips()) && !method.empty() && !method_named(method).weighs())
    throw CLI::ValidationError("--cost", fmt::format("policy {} supports only --cost strips; {} support --cost indices",
                                                     method, fmt::join(names_of_methods(&Method::weighs), ", ")));
}

void add_strip_options(CLI::App& app, StripOptions& options, CLI::Option* output, bool* progressive) {
  const auto set_form = [&options, progressive](const std::string& word) {
    if (word == "progressive") *progressive = true;
    if (word == "auto") return options.form.reset();
    options.form = word == "stitched"  ? StripForm::stitched
                   : word == "restart" ? StripForm::restart
                   : word == "list"    ? StripForm::list
                                       : StripForm::lengths;
  };
  std::vector<std::string> words{"auto", "stitched", "strips", "list", "restart"};
  if (progressive != nullptr) words.emplace_back("progressive");
  app.add_option_function<std::string>(
         "--gltf", set_form,
         std::string("contents of a .glb; a list is written instead if it has fewer indices, without --keep-strips\n"
                     "auto: stitched\n"
                     "stitched: one strip, in which repeated indices join the strips\n"
                     "strips: a primitive for each\n"
                     "list: a triangle list\n"
                     "restart: one primitive, for the few viewers that know KHR_mesh_primitive_restart") +
             (progressive == nullptr ? "" : "\nprogressive: the base, and all splits in MANYFOLD_mesh_progressive"))
      ->check(one_of(words))
      ->default_str("auto");
  app.add_option_function<std::string>(
         "--form", set_form,
         "contents of a .bin; a list is written instead if it has fewer indices, without --keep-strips\n"
         "restart: strips with the index with all bits set between them\n"
         "stitched: one strip, in which repeated indices join the strips\n"
         "lengths: a table of lengths, then the strips\n"
         "list: triangles")
      ->check(one_of({"restart", "stitched", "lengths", "list"}))
      ->default_str("restart")
      ->excludes(app.get_option("--gltf"));
  app.add_option_function<std::string>(
         "--index",
         [&options](const std::string& word) {
           options.width = word == "16"   ? IndexWidth::bits16
                           : word == "32" ? IndexWidth::bits32
                                          : IndexWidth::automatic;
         },
         "bits of an index in .glb and .bin; auto: 16 if all are below 65535")
      ->check(one_of({"16", "32", "auto"}))
      ->default_str("auto");
  app.add_option("--batch-vertices", options.most_vertices,
                 "most vertices of a batch; each batch is drawn separately; indices still number the vertices of the "
                 "whole mesh")
      ->check(whole_number_from(3, 1'000'000'000));
  app.add_option("--batch-indices", options.most_indices, "most indices of a batch")
      ->check(whole_number_from(4, 1'000'000'000));
  app.add_flag("--keep-strips", options.keep_strips, "write strips even if a list has fewer indices");
  for (const char* name : strip_options)
    if (output != nullptr) app.get_option(name)->needs(output);
}

void check_strip_options(const CLI::App& app, const NamedFile& out, StripOptions& options) {
  options.file = out.string();
  const MeshFormat* format = format_named(out.extension());
  const bool forms = format != nullptr && format->forms;
  const bool may_be_list = format != nullptr && format->holds_strips;
  for (const std::string name : strip_options) {
    const bool fits = name == "--keep-strips" ? may_be_list
                                              : forms && (name != "--gltf" || writes_baked(*format)) &&
                                                    (name != "--form" || !writes_baked(*format));
    if (app.count(name) == 0 || fits) continue;
    if (name == "--gltf") throw CLI::ValidationError(name, "only an output that ends in .glb has primitives");
    if (name == "--keep-strips")
      throw CLI::ValidationError(name, "only an output that ends in .bin, .glb or .ply has strips");
    if (name == "--form" && forms) {
      const auto form = app.get_option(name)->as<std::string>();
      throw CLI::ValidationError(name, fmt::format("only an output that ends in .bin has it; for .glb use --gltf {}",
                                                   form == "lengths" ? "strips" : form));
    }
    throw CLI::ValidationError(
        name, fmt::format("only an output that ends in .bin{} has it", name == "--form" ? "" : " or .glb"));
  }
}

std::string PlainFormatter::make_option_opts(const CLI::Option* option) const {
  std::string text;
  if (!option->get_option_text().empty()) {
    text = " " + option->get_option_text();
  } else if (option->get_type_size() != 0) {
    const bool flag = option->get_type_name().empty();
    if (!flag && !option->get_positional()) text = " " + values_in_words(option->get_type_name());
    if (option->get_expected_max() == CLI::detail::expected_max_vector_size) text += " ...";
    if (!option->get_default_str().empty()) text += fmt::format(" (default: {})", option->get_default_str());
    if (option->get_required() && !option->get_positional()) text += " (required)";
  }
  if (!option->get_needs().empty()) text += fmt::format(" (with {})", names_of(option->get_needs()));
  if (!option->get_excludes().empty()) text += fmt::format(" (without {})", names_of(option->get_excludes()));
  return text;
}

std::string wrong_subcommand(const CLI::App& app, const std::string& argument) {
  if (argument.starts_with("-")) return "";
  std::vector<std::string> names;
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (sub->get_name() == argument) return "";
    names.push_back(sub->get_name());
  }
  return fmt::format("unknown subcommand '{}'; there are {}", argument.substr(0, 40), list_in_words(names, "and"));
}

}  // namespace restrip::tools
