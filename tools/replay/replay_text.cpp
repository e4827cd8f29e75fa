#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "common/counted.hpp"
#include "replay/replay.hpp"

namespace restrip::tools {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const std::vector<Level>& levels) {
  Json json = Json::array();
  for (const Level& level : levels)
    json.push_back({{"triangles", level.triangles},
                    {"strips", level.strips},
                    {"isolated", level.isolated},
                    {"swaps", level.swaps},
                    {"indices", level.indices},
                    {"buffer_indices", level.buffer_indices},
                    {"acmr", level.acmr},
                    {"acmr_32", level.acmr_32}});
  return json;
}

Json json_of(const std::vector<LiveBufferReport>& buffers) {
  Json json = Json::array();
  for (const LiveBufferReport& buffer : buffers) {
    Json states = Json::array();
    for (const BufferState& state : buffer.states)
      states.push_back({{"at", state.at},
                        {"triangles", state.triangles},
                        {"indices", state.indices},
                        {"strip_indices", state.strip_indices},
                        {"acmr", state.fifo_16},
                        {"acmr_32", state.fifo_32}});
    json.push_back({{"operations_per_update", buffer.operations_per_update},
                    {"bytes_per_operation", buffer.bytes_per_operation},
                    {"ns_per_update", buffer.ns_per_update},
                    {"ns_per_update_with_history", buffer.ns_per_update_with_history},
                    {"states", std::move(states)}});
  }
  return json;
}

double ratio(std::size_t a, std::size_t b) { return b == 0 ? 0.0 : static_cast<double>(a) / static_cast<double>(b); }
/// What was not measured is 0.
std::string measured(double value, int digits) { return value == 0 ? "–" : fmt::format("{:.{}f}", value, digits); }
double percent(std::size_t part, std::size_t whole) { return 100.0 * ratio(part, whole); }

std::string as_text(const std::vector<LiveBufferReport>& buffers) {
  std::string text;
  for (const LiveBufferReport& buffer : buffers) {
    text += fmt::format("\n  live buffer, {} an update: {:.0f} bytes an operation",
                        counted(buffer.operations_per_update, "operation"), buffer.bytes_per_operation);
    if (buffer.ns_per_update > 0)
      text += fmt::format("; {:.0f} ns an update, {:.0f} with a history", buffer.ns_per_update,
                          buffer.ns_per_update_with_history);
    text += fmt::format("\n  {:<14} {:>10} {:>12} {:>14} {:>22} {:>6}\n", "", "triangles", "indices", "of strips'",
                        "ACMR in a cache of 16", "of 32");
    for (const BufferState& state : buffer.states)
      text += fmt::format("  {:<14} {:>10} {:>12} {:>14.3f} {:>22.3f} {:>6.3f}\n", state.at, state.triangles,
                          state.indices, ratio(state.indices, state.strip_indices), state.fifo_16, state.fifo_32);
  }
  return text;
}

}  // namespace

std::string as_text(const ReplayReport& report, const Subject& subject) {
  std::string text = subject.name + "\n" + as_text(subject.mended);
  text += fmt::format("  {}, {}, {}\n", counted(report.base_triangles, "triangle"), counted(report.operations, "split"),
                      counted(report.triangles, "triangle"));
  if (subject.wanted_triangles != 0 && report.base_triangles > subject.wanted_triangles)
    text += fmt::format("  (a base of {} was wanted; {})\n", counted(subject.wanted_triangles, "triangle"),
                        why_no_coarser(subject.left_out));
  const LeftOut& left = subject.left_out;
  if (left.degenerate_triangles != 0)
    text += fmt::format("  left out: {}\n", counted(left.degenerate_triangles, "degenerate triangle"));
  if (left.non_manifold_vertices != 0)
    text += fmt::format("  left alone: {} where the mesh is not manifold\n",
                        counted(left.non_manifold_vertices, "vertex", "vertices"));

  text += fmt::format("\n  {:>10} {:>10} {:>14} {:>10} {:>17} {:>12} {:>6}   {}\n", "triangles", "strips", "per strip",
                      "isolated", "indices per tri.", "live buffer", "ACMR",
                      "on the way back: strips, per strip, live buffer");
  for (std::size_t i = 0; i < report.levels.size(); ++i) {
    const Level& level = report.levels[i];
    text += fmt::format("  {:>10} {:>10} {:>14.2f} {:>10} {:>17.3f} {:>12} {:>6}", level.triangles, level.strips,
                        ratio(level.triangles, level.strips), level.isolated, ratio(level.indices, level.triangles),
                        measured(ratio(level.buffer_indices, level.triangles), 3), measured(level.acmr, 2));
    if (i < report.levels_down.size())
      text += fmt::format(" {:>25} {:>10.2f} {:>12}", report.levels_down[i].strips,
                          ratio(report.levels_down[i].triangles, report.levels_down[i].strips),
                          measured(ratio(report.levels_down[i].buffer_indices, report.levels_down[i].triangles), 3));
    text += '\n';
  }

  text += "\n  splits by valence:";
  for (std::size_t k = 0; k < report.by_valence.size(); ++k)
    if (report.by_valence[k] != 0) text += fmt::format(" {}: {}", k, report.by_valence[k]);
  const auto share = [&](const char* what, std::size_t count) {
    text += fmt::format("\n  {:<41}{:>10}{:>8.2f} %", what, count, percent(count, report.operations));
  };
  share("splits that introduced an isolated one", report.operations_isolating);
  share("splits that added a strip", report.operations_adding_strip);
  share("splits without a rule", report.operations_without_rule);
  if (const RuleCounts& rules = report.rules; rules.asked != 0)
    text += fmt::format("\n  {:<41}{:>10}: {} taken, {} kept colours as good; {} improved afterwards", "rules asked",
                        rules.asked, rules.taken, rules.kept, rules.improved);
  const auto cost = [&](const char* what, double with, double bare) {
    if (bare > 0)
      text += fmt::format("\n  {:<41}{:>7.0f} ns, bare {:.0f} ns: {:.2f} times", what, with, bare, with / bare);
  };
  cost("a split with its strips", report.ns_per_operation, report.ns_per_operation_bare);
  cost("a collapse with its strips", report.ns_per_collapse, report.ns_per_collapse_bare);
  text += fmt::format("\n  {:<41}{:>10}", "most strips of all levels", report.most_strips);
  if (subject.baked) {
    text += fmt::format("\n  {:<41}{:>10.2f}, {:.1f} bytes", "flips of a record", subject.baked->flips_per_record,
                        subject.baked->bytes_per_record);
    if (subject.baked->seconds > 0)
      text += fmt::format("\n  {:<41}{:>10.1f}", "seconds to bake", subject.baked->seconds);
    text += fmt::format("\n  {:<41}{:>10}", "levels reached again, strips the same", report.levels_compared);
  }
  text += '\n' + as_text(report.live_buffers);

  if (!report.cycles.empty()) {
    text += fmt::format("\n  {:>6} {:>12} {:>12} {:>12} {:>10}\n", "cycle", "base strips", "top strips", "isolating",
                        "adding");
    // All cycles if there are few; otherwise the first three, about twenty others and the last one.
    for (std::size_t i = 0, each = report.cycles.size() / 20 + 1; i < report.cycles.size(); ++i) {
      const Cycle& cycle = report.cycles[i];
      if (i >= 3 && i % each != 0 && i + 1 != report.cycles.size()) continue;
      text += fmt::format("  {:>6} {:>12} {:>12} {:>12} {:>10}\n", cycle.number, cycle.base.strips, cycle.top.strips,
                          cycle.isolating, cycle.adding_strip);
    }
  }
  text += report.valid() ? "\n  checked: every triangle once, as it was, in strips without a fault\n" : "\n";
  for (const std::string& fault : report.faults) text += fmt::format("  FAULT: {}\n", fault);
  return text;
}

std::string as_text(const WalkReport& report) {
  std::string text = fmt::format(
      "\n  walk of {}, seed {}: {}, {}, {}, {} refused\n"
      "  isolated ones introduced: {} by splits and collapses, {} by flips\n",
      counted(report.options.steps, "step"), report.options.seed, counted(report.splits, "split"),
      counted(report.collapses, "collapse"), counted(report.flips, "flip"), report.refused, report.isolating,
      report.flips_isolating);
  if (report.fault.empty())
    return text + as_text(report.live_buffers) +
           fmt::format("  checked: no fault; {} in {} at the end, {} isolated\n", counted(report.triangles, "triangle"),
                       counted(report.strips, "strip"), report.isolated);
  return text + fmt::format("  FAULT at step {}: {}\n", report.fault_step, report.fault);
}

Json as_json(const ReplayReport& report, const Subject& subject, const std::optional<WalkReport>& walk) {
  Json by_valence = Json::object();
  for (std::size_t k = 0; k < report.by_valence.size(); ++k)
    if (report.by_valence[k] != 0) by_valence[std::to_string(k)] = report.by_valence[k];
  Json cycles = Json::array();
  for (const Cycle& cycle : report.cycles)
    cycles.push_back({{"cycle", cycle.number},
                      {"base_strips", cycle.base.strips},
                      {"base_isolated", cycle.base.isolated},
                      {"top_strips", cycle.top.strips},
                      {"top_isolated", cycle.top.isolated},
                      {"isolating", cycle.isolating},
                      {"adding_strip", cycle.adding_strip}});
  Json json{
      {"mesh", subject.name},
      {"triangles", report.triangles},
      {"base_triangles", report.base_triangles},
      {"wanted_base_triangles", subject.wanted_triangles != 0 ? subject.wanted_triangles : report.base_triangles},
      {"operations", report.operations},
      {"operations_without_rule", report.operations_without_rule},
      {"operations_isolating", report.operations_isolating},
      {"operations_adding_strip", report.operations_adding_strip},
      {"rules",
       {{"asked", report.rules.asked},
        {"taken", report.rules.taken},
        {"kept", report.rules.kept},
        {"improved", report.rules.improved}}},
      {"by_valence", std::move(by_valence)},
      {"levels", json_of(report.levels)},
      {"levels_down", json_of(report.levels_down)},
      {"triangles_per_strip",
       report.levels.empty() ? 0.0 : ratio(report.levels.back().triangles, report.levels.back().strips)},
      {"policy", subject.policy},
      {"states", subject.search.states},
      {"enough", subject.search.enough},
      {"cost", subject.cost == Cost::strips() ? "strips" : "indices"},
      {"most_strips", report.most_strips},
      {"cycles", std::move(cycles)},
      {"ns_per_operation", report.ns_per_operation},
      {"ns_per_operation_bare", report.ns_per_operation_bare},
      {"ns_per_collapse", report.ns_per_collapse},
      {"ns_per_collapse_bare", report.ns_per_collapse_bare},
      {"live_buffers", json_of(report.live_buffers)},
      {"left_out",
       {{"degenerate_triangles", subject.left_out.degenerate_triangles},
        {"non_manifold_vertices", subject.left_out.non_manifold_vertices},
        {"large_vertices", subject.left_out.large_vertices}}},
      {"valid", report.valid() && (!walk || walk->fault.empty())},
      {"faults", report.faults},
  };
  add_to(json, subject.mended);
  if (subject.baked)
    json["baked"] = {{"flips_per_record", subject.baked->flips_per_record},
                     {"bytes_per_record", subject.baked->bytes_per_record},
                     {"bake_seconds", subject.baked->seconds},
                     {"levels_compared", report.levels_compared}};
  if (walk)
    json["walk"] = {{"steps", walk->options.steps}, {"seed", walk->options.seed},
                    {"splits", walk->splits},       {"collapses", walk->collapses},
                    {"flips", walk->flips},         {"refused", walk->refused},
                    {"isolating", walk->isolating}, {"flips_isolating", walk->flips_isolating},
                    {"triangles", walk->triangles}, {"strips", walk->strips},
                    {"isolated", walk->isolated},   {"live_buffers", json_of(walk->live_buffers)},
                    {"fault", walk->fault},         {"fault_step", walk->fault_step}};
  return json;
}

}  // namespace restrip::tools
