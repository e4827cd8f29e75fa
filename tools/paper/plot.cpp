#include "paper/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace restrip::tools {
namespace {

const char* class_of(Family family) {
  switch (family) {
    case Family::ours:
      return "ours";
    case Family::paper:
      return "paper";
    case Family::scratch:
      break;
  }
  return "scratch";
}

/// Where the lines are drawn, inside the margins.
struct Frame {
  double left = 72;
  double right = 560;
  double top = 14;
  double bottom = 330;
};

/// From values to places along one axis.
class Scale {
 public:
  Scale(const Axis& axis, double low, double high, double from, double to)
      : logarithmic_(axis.logarithmic), from_(from), to_(to) {
    logarithmic_ ? find_log_ticks(low, high) : find_even_ticks(low, high);
  }
  [[nodiscard]] double place(double value) const {
    const double low = along(ticks_.front());
    const double high = along(ticks_.back());
    return from_ + (to_ - from_) * (along(value) - low) / (high - low);
  }
  [[nodiscard]] const std::vector<double>& ticks() const noexcept { return ticks_; }

 private:
  [[nodiscard]] double along(double value) const { return logarithmic_ ? std::log10(value) : value; }
  void find_log_ticks(double low, double high) {
    const int first = static_cast<int>(std::floor(std::log10(low) + 1e-9));
    const bool few = std::log10(high / low) < 2.5;
    for (int decade = first; ticks_.size() < 2 || ticks_.back() < high; ++decade)
      for (const double step : {1.0, 2.0, 5.0}) {
        if (!few && step > 1) continue;
        if (ticks_.size() > 1 && ticks_.back() >= high) break;
        ticks_.push_back(step * std::pow(10.0, decade));
      }
    // Steps wholly below the lowest value go.
    while (ticks_.size() > 2 && ticks_[1] <= low) ticks_.erase(ticks_.begin());
  }
  void find_even_ticks(double low, double high) {
    // The smallest of 1, 2, 5, 10, 20, … that makes at most eight steps.
    double step = 1;
    for (int n = 0; (high - low) / step > 8; ++n) step *= n % 3 == 1 ? 2.5 : 2;
    const double first = std::floor(low / step);
    for (double n = first; ticks_.size() < 2 || ticks_.back() < high; ++n) ticks_.push_back(n * step);
  }

  bool logarithmic_;
  double from_;
  double to_;
  std::vector<double> ticks_;
};

std::string label_of(double value) {
  return value >= 1 && value == std::floor(value) ? grouped(static_cast<std::size_t>(value))
                                                  : fmt::format("{:g}", value);
}

/// A ring around the place, where another series may have its marker.
std::string ring(double x, double y) {
  return fmt::format("<circle class=\"ring\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"7\"/>", x, y);
}

std::string marker(const Series& series, double x, double y) {
  if (series.markers_only) return ring(x, y);
  switch (series.member % 4) {
    case 0:
      return fmt::format("<circle class=\"mark\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\"/>", x, y);
    case 1:
      return fmt::format("<rect class=\"mark\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"7\" height=\"7\"/>", x - 3.5, y - 3.5);
    case 2:
      return fmt::format("<path class=\"mark\" d=\"M{:.1f},{:.1f}l5,5l-5,5l-5,-5z\"/>", x, y - 5);
    default:
      return fmt::format("<path class=\"mark\" d=\"M{:.1f},{:.1f}l5,8.5h-10z\"/>", x, y - 5.5);
  }
}

std::string text(const char* style, double x, double y, const char* anchor, const std::string& words) {
  return fmt::format("<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", style, x, y, anchor,
                     escaped(words));
}

std::string line(const char* style, double x1, double y1, double x2, double y2) {
  return fmt::format("<line class=\"{}\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n", style, x1, y1,
                     x2, y2);
}

std::string opening(double width, double height, const std::string& description) {
  return fmt::format("<svg class=\"plot\" viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"{}\">\n", width,
                     height, escaped(description));
}

/// Moves labels apart that would be written over each other, as little as a pass from above and one from below can.
std::vector<double> spread_out(std::vector<double> places, double gap, double lowest) {
  std::vector<std::size_t> order(places.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return places[i] < places[j]; });
  double last = -1e9;
  for (const std::size_t i : order) last = places[i] = std::max(places[i], last + gap);
  double next = lowest + gap;
  for (auto i = order.rbegin(); i != order.rend(); ++i) next = places[*i] = std::min(places[*i], next - gap);
  return places;
}

}  // namespace

std::string line_plot(const Axis& x, const Axis& y, const std::vector<Series>& series, const std::string& description) {
  const auto shown = [&](const XY& p) { return (!x.logarithmic || p.x > 0) && (!y.logarithmic || p.y > 0); };
  constexpr double far = std::numeric_limits<double>::infinity();
  std::array<double, 4> box{far, -far, y.logarithmic ? far : 0.0, -far};
  for (const Series& s : series)
    for (const XY& p : s.points)
      if (shown(p)) box = {std::min(box[0], p.x), std::max(box[1], p.x), std::min(box[2], p.y), std::max(box[3], p.y)};
  if (box[0] > box[1]) return {};

  const Frame frame;
  const Scale across(x, box[0], box[1], frame.left, frame.right);
  const Scale up(y, box[2], box[3], frame.bottom, frame.top);
  std::string svg = opening(760, 385, description);
  for (const double tick : up.ticks())
    svg += line("grid", frame.left, up.place(tick), frame.right, up.place(tick)) +
           text("tick", frame.left - 8, up.place(tick) + 4, "end", label_of(tick));
  for (const double tick : across.ticks())
    svg += line("grid", across.place(tick), frame.top, across.place(tick), frame.bottom) +
           text("tick", across.place(tick), frame.bottom + 18, "middle", label_of(tick));
  svg += text("axis", (frame.left + frame.right) / 2, frame.bottom + 42, "middle", x.label);
  const double half_way = (frame.top + frame.bottom) / 2;
  svg += fmt::format(
      "<text class=\"axis\" transform=\"translate(14 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
      half_way, escaped(y.label));

  std::vector<double> ends;
  for (const Series& s : series) {
    svg += fmt::format("<g class=\"{} member{}\">", class_of(s.family), s.member);
    std::string path;
    std::string marks;
    XY end{frame.right, frame.bottom};
    for (const XY& p : s.points) {
      if (!shown(p)) continue;
      end = {across.place(p.x), up.place(p.y)};
      path += fmt::format("{}{:.1f},{:.1f}", path.empty() ? "M" : "L", end.x, end.y);
      marks += fmt::format("<g>{}<title>{}: {} {}, {} {}</title></g>", marker(s, end.x, end.y), escaped(s.name),
                           label_of(p.x), escaped(x.label), label_of(p.y), escaped(y.label));
    }
    if (!s.markers_only) svg += fmt::format("<path class=\"line\" d=\"{}\"/>", path);
    svg += marks + "</g>\n";
    ends.push_back(end.y);
  }
  const std::vector<double> places = spread_out(ends, 17, frame.bottom);
  for (std::size_t i = 0; i < series.size(); ++i) {
    const double at = places[i];
    svg += fmt::format("<g class=\"{} member{}\">", class_of(series[i].family), series[i].member);
    if (!series[i].markers_only)
      svg += fmt::format("<path class=\"line\" d=\"M{:.1f},{:.1f}h26\"/>", frame.right + 16, at);
    svg += marker(series[i], frame.right + 29, at) + "</g>" +
           text("name", frame.right + 48, at + 4, "start", series[i].name);
  }
  return svg + "</svg>\n";
}

std::string bar_plot(const BarPlot& plot, const std::string& description) {
  constexpr double left = 160;
  constexpr double right = 660;
  constexpr double row = 28;
  constexpr double above = 26;
  const double bottom = above + row * static_cast<double>(plot.bars.size());
  const Scale across({plot.label, false}, 0, plot.top, left, right);
  std::string svg = opening(760, bottom + 52, description);
  for (const double tick : across.ticks())
    svg += line("grid", across.place(tick), above, across.place(tick), bottom) +
           text("tick", across.place(tick), bottom + 18, "middle", label_of(tick));
  for (std::size_t i = 0; i < plot.bars.size(); ++i) {
    const Bar& bar = plot.bars[i];
    const double y = above + row * static_cast<double>(i) + 5;
    svg += fmt::format(
        "<g class=\"{}\"><rect class=\"bar\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.0f}\"/>"
        "<title>{}: {}</title></g>\n",
        class_of(bar.family), left, y, std::max(across.place(bar.value) - left, 1.0), row - 10, escaped(bar.name),
        escaped(bar.text));
    svg += text("name", left - 8, y + 14, "end", bar.name) + text("value", 742, y + 14, "end", bar.text);
  }
  if (plot.reference > 0) {
    const double at = across.place(plot.reference);
    svg += line("reference", at, above - 6, at, bottom) + text("value", at, above - 12, "middle", plot.reference_text);
  }
  return svg + text("axis", (left + right) / 2, bottom + 42, "middle", plot.label) + "</svg>\n";
}

std::string plot_style() {
  // Vermilion, blue and grey differ for every kind of colour vision, and in lightness.
  return R"(:root { --surface: #ffffff; --ink: #1c1e21; --faint: #d9dce1; --soft: #5a6068;
  --ours: #0b5cad; --paper: #c2410c; --scratch: #6b7280; }
@media (prefers-color-scheme: dark) { :root { --surface: #16181c; --ink: #e8eaed; --faint: #363b43; --soft: #a4abb5;
  --ours: #6cb6ff; --paper: #ff9e64; --scratch: #9aa3af; } }
svg.plot { width: 100%; max-width: 760px; min-width: 540px; height: auto; font: 13px system-ui, sans-serif; overflow: visible; }
.plot text { fill: var(--ink); } .plot .tick { fill: var(--soft); font-size: 12px; }
.plot .grid { stroke: var(--faint); stroke-width: 1; }
.plot .line { fill: none; stroke: var(--series); stroke-width: 2; }
.plot .mark { fill: var(--series); stroke: var(--surface); stroke-width: 1; }
.plot .ring { fill: none; stroke: var(--series); stroke-width: 2; }
.plot .bar { fill: var(--series); }
.plot .reference { stroke: var(--ink); stroke-width: 1.5; stroke-dasharray: 5 3; }
.ours { --series: var(--ours); } .paper { --series: var(--paper); } .scratch { --series: var(--scratch); }
.member1 .line { stroke-dasharray: 8 3; } .member2 .line { stroke-dasharray: 3 3; }
.member3 .line { stroke-dasharray: 10 3 2 3; } .member4 .line { stroke-dasharray: 14 4; }
)";
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string grouped(std::size_t number) {
  std::string digits = fmt::format("{}", number);
  for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, 1, ',');
  return digits;
}

}  // namespace restrip::tools
