// Plots as inline SVG: lines over two axes, and bars with their values. No scripts and no fixed colours: the page's
// style sheet names them (plot_style), light and dark. Series differ in colour by family and in marker and dashes
// within one, so that nobody depends on hue. The same bytes on every machine.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace restrip::tools {

/// A kind of series, with a colour of its own.
enum class Family { ours, paper, scratch };

struct XY {
  double x = 0;
  double y = 0;
};

struct Series {
  std::string name;
  Family family = Family::ours;
  std::size_t member = 0;     ///< of the family: chooses marker and dashes
  std::vector<XY> points;     ///< ascending x; on a logarithmic axis those that are not positive are left out
  bool markers_only = false;  ///< rings, around what another series marks
};

struct Axis {
  std::string label;  ///< with its unit
  bool logarithmic = false;
};

/// Lines with their names beside their ends; each marker tells its values when pointed at. Empty without a point.
[[nodiscard]] std::string line_plot(const Axis& x, const Axis& y, const std::vector<Series>& series,
                                    const std::string& description);

struct Bar {
  std::string name;
  Family family = Family::ours;
  double value = 0;  ///< 0 … top
  std::string text;  ///< the value as written beside the bar
};

/// Horizontal bars from 0 to `top`; `reference`, where positive, is a line across all bars.
struct BarPlot {
  std::string label;  ///< of the values, with their unit
  double top = 100;
  std::vector<Bar> bars;
  double reference = 0;
  std::string reference_text;
};
[[nodiscard]] std::string bar_plot(const BarPlot& plot, const std::string& description);

/// The style that the plots need, to be put into the page's <style>: --ink, --faint, --surface and a colour for each
/// family.
[[nodiscard]] std::string plot_style();

/// Text that is safe between tags and inside quoted attributes.
[[nodiscard]] std::string escaped(const std::string& text);

/// 69451 as 69,451.
[[nodiscard]] std::string grouped(std::size_t number);

}  // namespace restrip::tools
