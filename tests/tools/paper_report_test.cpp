// Claims: `restrip paper` writes CSV files and a report, from which scripts/paper_page.py makes one page of
// well-formed, self-contained HTML with every figure and the numbers of the CSV files. Every run produces the same
// bytes. Bad input produces no files. (pictures_test.py tests the script's pictures.)
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "run_program.hpp"
#include "scratch_folder.hpp"
#include "support/sanitizers.hpp"

namespace restrip::tools {
namespace {

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

/// Empty, or the first place where tags are not properly nested.
std::string tag_fault(const std::string& html) {
  std::vector<std::string> open;
  for (std::size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at + 1)) {
    const std::size_t end = html.find('>', at);
    if (end == std::string::npos) return "a tag without end";
    const std::string tag = html.substr(at + 1, end - at - 1);
    if (tag.find('<') != std::string::npos) return "a bare < in " + tag;
    if (tag.starts_with("!DOCTYPE") || tag.ends_with("/")) continue;
    if (tag.starts_with("/")) {
      if (open.empty() || open.back() != tag.substr(1)) return "unexpected <" + tag + ">";
      open.pop_back();
    } else {
      open.push_back(tag.substr(0, tag.find_first_of(" \n")));
    }
  }
  return open.empty() ? "" : "never closed: " + open.back();
}

/// The rows of a table on the page, by its id; cells without their marks, thousands without commas.
std::vector<std::vector<std::string>> table(const std::string& html, const std::string& id) {
  const std::size_t start = html.find("<table id=\"" + id + "\"");
  if (start == std::string::npos) return {};
  const std::string text = html.substr(start, html.find("</table>", start) - start);
  std::vector<std::vector<std::string>> rows;
  for (std::size_t row = text.find("<tr>"); row != std::string::npos; row = text.find("<tr>", row + 1)) {
    rows.emplace_back();
    const std::size_t end = text.find("</tr>", row);
    for (std::size_t cell = text.find("<t", row + 4); cell < end; cell = text.find("<t", cell + 1)) {
      const std::size_t from = text.find('>', cell) + 1;
      std::string words = text.substr(from, text.find("</t", from) - from);
      words.erase(std::remove(words.begin(), words.end(), ','), words.end());
      rows.back().push_back(words);
    }
  }
  return rows;
}

/// The rows of a CSV file below its header, without the mesh's name, whose quotes are not parsed.
std::vector<std::vector<std::string>> csv_rows(const std::string& bytes, const std::string& mesh) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(bytes);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    EXPECT_TRUE(line.starts_with(mesh)) << line;
    rows.emplace_back();
    std::istringstream fields(line.substr(mesh.size()) + ",");
    std::string field;
    std::getline(fields, field, ',');
    while (std::getline(fields, field, ',')) rows.back().push_back(field);
  }
  return rows;
}

using PaperReport = ScratchFolder;

Outcome make_page(const std::string& folder) {
  return run_command(fmt::format("{} '{}' 2>&1", RESTRIP_PAGE_COMMAND, folder));
}

TEST_F(PaperReport, PageAndFiguresAgree) {
  const std::string mesh = file("a<b>&\"c\",d.ply");  // as awkward as a name can be
  const std::string in_csv = "\"a<b>&\"\"c\"\",d.ply\"";
  ASSERT_EQ(run_program(fmt::format("make-mesh --triangles {} -o '{}'", test::large(3000), mesh)).code, 0);
  const Outcome paper = run_program(fmt::format("paper --out '{}' --base 0.05 --json - '{}'", file("one"), mesh));
  ASSERT_EQ(paper.code, 0);
  const auto json = nlohmann::json::parse(paper.out);
  EXPECT_EQ(bytes_of(folder_ / "one" / "report.json"), paper.out);
  const Outcome made = make_page(file("one"));
  ASSERT_EQ(made.code, 0) << made.out;
  const std::string html = bytes_of(folder_ / "one" / "index.html");
  EXPECT_EQ(tag_fault(html), "");
  for (const char* outside : {"http", "<script", "<img", "<link", "url("})
    EXPECT_EQ(html.find(outside), std::string::npos) << outside;
  EXPECT_NE(html.find("prefers-color-scheme: dark"), std::string::npos);

  // Figures 6, 7 and 8.
  EXPECT_EQ(count(html, "<figure class=\"position\">"), 19U);
  EXPECT_EQ(count(html, "stands for"), 9U + 8U + 88U + 55U);
  const std::string lonely = bytes_of(folder_ / "one" / "lonely.csv");
  EXPECT_EQ(count(html, "<figure class=\"lonely\">"), count(lonely, "\n6,"));
  EXPECT_EQ(count(bytes_of(folder_ / "one" / "positions.csv"), "\n"), 20U);
  EXPECT_EQ(count(bytes_of(folder_ / "one" / "rules-4.csv"), "\n"), 1U + 88U + 55U);
  const auto counts = table(html, "lonely-counts");
  ASSERT_EQ(counts.size(), 16U);
  for (std::size_t i = 0; i < 15; ++i)
    EXPECT_EQ(counts[i + 1][2], fmt::format("{}", json.at("lonely").at(i).at("lonely").get<int>()));

  // One plot of each kind, with points in it.
  for (const char* kind : {"valence", "isolating", "strips"}) {
    const std::size_t at = html.find(fmt::format("<figure class=\"{}\">", kind));
    ASSERT_NE(at, std::string::npos) << kind;
    const std::string plot = html.substr(at, html.find("</figure>", at) - at);
    EXPECT_GT(count(plot, "<title>"), 5U) << kind;
    EXPECT_EQ(plot.find("nan"), std::string::npos) << kind;
    EXPECT_EQ(plot.find("inf"), std::string::npos) << kind;
  }

  const auto valence = table(html, "valence-1");
  const auto valence_csv = csv_rows(bytes_of(folder_ / "one" / "valence.csv"), in_csv);
  ASSERT_EQ(valence.size(), valence_csv.size() + 1);
  for (std::size_t i = 0; i < valence_csv.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(valence[i + 1][c], valence_csv[i][c]) << i;

  const auto isolating = table(html, "isolating-1");
  const auto isolating_csv = csv_rows(bytes_of(folder_ / "one" / "isolating.csv"), in_csv);
  ASSERT_EQ(isolating.size(), isolating_csv.size() + 1);
  ASSERT_EQ(isolating_csv.size(), json.at("meshes").at(0).at("policies").size());
  for (std::size_t i = 0; i < isolating_csv.size(); ++i) {
    for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(isolating[i + 1][c], isolating_csv[i][c]) << i;
    EXPECT_EQ(isolating_csv[i][2],
              fmt::format("{}", json.at("meshes").at(0).at("policies").at(i).at("isolating").get<int>()));
  }

  // The page has a column for each policy, the file a line for each policy and level.
  const auto strips = table(html, "strips-1");
  const auto strips_csv = csv_rows(bytes_of(folder_ / "one" / "strips.csv"), in_csv);
  ASSERT_EQ(strips.size(), 13U);
  std::map<std::pair<std::string, std::string>, std::string> on_page;
  for (std::size_t row = 1; row < strips.size(); ++row)
    for (std::size_t column = 1; column < strips[row].size(); ++column)
      on_page[{strips[0][column], strips[row][0]}] = strips[row][column];
  EXPECT_EQ(on_page.size(), strips_csv.size());
  for (const auto& line : strips_csv) EXPECT_EQ(on_page.at({line[0], line[1]}), line[2]) << line[0] << ' ' << line[1];

  // Again, into the same folder and into another: the same bytes, and nothing else there.
  ASSERT_EQ(run_program(fmt::format("paper --out '{}' --base 0.05 '{}'", file("one"), mesh)).code, 0);
  ASSERT_EQ(run_program(fmt::format("paper --out '{}' --base 0.05 '{}'", file("two"), mesh)).code, 0);
  ASSERT_EQ(make_page(file("one")).code, 0);
  ASSERT_EQ(make_page(file("two")).code, 0);
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "two")) {
    names.insert(entry.path().filename().string());
    EXPECT_EQ(bytes_of(entry.path()), bytes_of(folder_ / "one" / entry.path().filename())) << entry.path();
  }
  EXPECT_EQ(names, (std::set<std::string>{"index.html", "isolating.csv", "lonely-counts.csv", "lonely.csv",
                                          "positions.csv", "report.json", "rules-4.csv", "strips.csv", "valence.csv"}));
  EXPECT_EQ(bytes_of(folder_ / "one" / "index.html"), html);
}

TEST_F(PaperReport, BadInputLeavesNoReport) {
  ASSERT_EQ(run_program(fmt::format("make-mesh --triangles 200 -o '{}'", file("a.off"))).code, 0);
  EXPECT_EQ(run_program(fmt::format("paper --out '{}' '{}' /no/such/mesh.obj", file("out"), file("a.off"))).code, 2);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out" / "report.json"));
  EXPECT_EQ(run_program(fmt::format("paper --out '{}' '{}'", file("a.off"), file("a.off"))).code, 2);
  EXPECT_EQ(run_program(fmt::format("paper --out '{}'", file("out"))).code, 2);
  EXPECT_EQ(run_program(fmt::format("paper '{}'", file("a.off"))).code, 2);
  EXPECT_EQ(run_program(fmt::format("paper --levels 1 --out '{}' '{}'", file("out"), file("a.off"))).code, 2);
}

TEST_F(PaperReport, AFileThatIsNotAReportGetsNoPage) {
  std::filesystem::create_directory(file("empty"));
  std::filesystem::create_directory(file("broken"));
  std::ofstream(folder_ / "broken" / "report.json") << R"({"meshes": []})";
  for (const auto& [folder, complaint] : {std::pair{"empty", "name a folder that restrip paper wrote"},
                                          {"none", "name a folder that restrip paper wrote"},
                                          {"broken", "is not a report of restrip paper"}}) {
    const Outcome refused = make_page(file(folder));
    EXPECT_NE(refused.code, 0) << folder;
    EXPECT_NE(refused.out.find(complaint), std::string::npos) << refused.out;
    EXPECT_FALSE(std::filesystem::exists(folder_ / folder / "index.html")) << folder;
  }
}

TEST_F(PaperReport, AProgressiveMeshIsReplayedAsItIs) {
  ASSERT_EQ(run_program(fmt::format("make-mesh --triangles 1000 -o '{}'", file("a.off"))).code, 0);
  ASSERT_EQ(run_program(fmt::format("simplify '{}' --base 0.3 -o '{}'", file("a.off"), file("a.pm"))).code, 0);
  const Outcome paper = run_program(fmt::format("paper --json - --out '{}' '{}'", file("out"), file("a.pm")));
  ASSERT_EQ(paper.code, 0);
  const auto mesh = nlohmann::json::parse(paper.out).at("meshes").at(0);
  EXPECT_GT(mesh.at("base_triangles").get<int>(), 250);
  EXPECT_EQ(mesh.at("policies").at(0).at("levels").back().at("triangles"), mesh.at("triangles"));
}

}  // namespace
}  // namespace restrip::tools
