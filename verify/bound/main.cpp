// restrip-verify-bound: proves that no index buffer of a mesh has fewer indices than a certificate says, from
// docs/bound.md alone.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "bound/bound_check.hpp"
#include "bound/triangle_list.hpp"
#include "files/report_output.hpp"
#include "judge/report.hpp"
#include "model/program.hpp"
#include "model/quantity.hpp"

namespace {

using namespace restrip::verify;

int run(const std::string& mesh, const std::string& certificate, const std::string& json) {
  const restrip::files::ReportOutput out(json, {mesh, certificate});
  const TriangleList list = read_obj(mesh);
  if (list.left_out != 0 && !out.replaces_text())
    fmt::print("{}: left out {} with a corner twice\n", mesh, quantity(list.left_out, "triangle"));
  nlohmann::ordered_json report{{"triangles", list.triangles.size()}, {"left_out", list.left_out}};
  std::string text;
  try {
    const ProvenBound bound = check_bound(certificate, list);
    text = fmt::format(
        "verified: no index buffer of {} has fewer than {} indices, {:.4f} per triangle; read: {} and {} of {}\n",
        quantity_grouped(list.triangles.size(), "triangle"), grouped(bound.indices),
        static_cast<double>(bound.indices) / static_cast<double>(list.triangles.size()), mesh,
        quantity_grouped(bound.cuts, "cut"), certificate);
    report.update({{"indices", bound.indices}, {"cuts", bound.cuts}, {"verified", true}});
  } catch (const FalseBound& error) {
    text = fmt::format("NOT verified: {}\n", error.what());
    report.update({{"fault", error.what()}, {"verified", false}});
  }
  out.print(text, text_of(report));
  return report["verified"] ? all_claims_hold : some_claim_fails;
}

}  // namespace

int main(int argc, char** argv) {
  std::string mesh;
  std::string certificate;
  std::string json;
  CLI::App app("Proves that no index buffer of a mesh has fewer indices than a certificate says.");
  app.name("restrip-verify-bound");
  app.footer(
      "Exit code: 0 the bound holds, 1 it is not proven, 2 bad input.\n\n"
      "Example:\n"
      "  restrip stripify bunny.obj --bound-certificate bunny.bound\n"
      "  restrip-verify-bound bunny.obj bunny.bound");
  app.add_option("mesh", mesh, "An OBJ file of triangles")->required();
  app.add_option("certificate", certificate, "What `restrip stripify --bound-certificate` wrote")->required();
  add_json_option(app, json);
  return exit_code_of(app, argc, argv, [&] { return run(mesh, certificate, json); });
}
