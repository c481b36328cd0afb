#include "rig/lab/lab_plot.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace mirada::rig {
namespace {

constexpr double kPanelWide = 430;
constexpr double kPanelHigh = 250;
constexpr double kLeft = 44;
constexpr double kTop = 34;
constexpr double kPlotWide = 374;
constexpr double kPlotHigh = 168;
constexpr double kLegendHigh = 26;
constexpr int kLines = 5;
constexpr const char* kOurs = "#2f6fde";
constexpr const char* kPaper = "#e6a000";

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '&')
      out += "&amp;";
    else
      out += c;
  }
  return out;
}

std::string text(double x, double y, const char* anchor, const std::string& words) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                     escaped(words));
}

std::string bar(double x, double y, double wide, double high, const char* colour) {
  return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\"/>\n", x,
                     y, wide, high, colour);
}

std::string line(double x1, double y1, double x2, double y2, const char* colour) {
  return fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"{}\"/>\n", x1, y1, x2, y2, colour);
}

/// The top of the scale in percent: a round number above everything drawn.
double top_percent(const LabTable& table) {
  double most = 1;
  for (const LabScore& row : table.rows) {
    for (const double share : {row.p90_error, row.paper_median, row.median_error}) {
      if (std::isfinite(share)) most = std::max(most, 100 * share);
    }
  }
  for (const double top : {2.0, 5.0, 10.0, 20.0, 50.0}) {
    if (most <= top) return top;
  }
  return 100;
}

std::string panel(const LabTable& table, double left, double up) {
  std::vector<const LabScore*> rows;
  for (const LabScore& row : table.rows) {
    if (row.errors > 0) rows.push_back(&row);
  }
  const double top = top_percent(table);
  const double floor = up + kTop + kPlotHigh;
  const auto y_of = [&](double share) { return floor - std::min(100 * share / top, 1.0) * kPlotHigh; };
  std::string out = text(left + kLeft, up + 20, "start", "error, %, by " + table.title);
  for (int i = 0; i <= kLines; ++i) {
    const double y = floor - i * kPlotHigh / kLines;
    out += line(left + kLeft, y, left + kLeft + kPlotWide, y, "#dddddd");
    out += text(left + kLeft - 6, y + 4, "end", fmt::format("{:g}", i * top / kLines));
  }
  const double step = rows.empty() ? 0 : kPlotWide / static_cast<double>(rows.size());
  const double wide = std::min(step * 0.28, 26.0);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const LabScore& row = *rows[i];
    const double middle = left + kLeft + (static_cast<double>(i) + 0.5) * step;
    out += bar(middle - wide, y_of(row.median_error), wide, floor - y_of(row.median_error), kOurs);
    out += line(middle - wide / 2, y_of(row.p90_error), middle - wide / 2, floor, kOurs);
    out += line(middle - wide, y_of(row.p90_error), middle, y_of(row.p90_error), kOurs);
    if (std::isfinite(row.paper_median))
      out += bar(middle + 2, y_of(row.paper_median), wide, floor - y_of(row.paper_median), kPaper);
    out += text(middle, floor + 16, "middle", row.name);
  }
  return out;
}

}  // namespace

std::string svg_plot(const std::vector<LabTable>& tables) {
  const std::size_t panels = tables.size() > 1 ? tables.size() - 1 : 0;
  const double wide = 2 * kPanelWide;
  const double high = kLegendHigh + kPanelHigh * static_cast<double>((panels + 1) / 2);
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" font-family=\"sans-serif\" "
      "font-size=\"10\" fill=\"#333333\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
      wide, high);
  out += bar(kLeft, 8, 12, 12, kOurs) +
         text(kLeft + 18, 18, "start", "Mirada: median, whisker to the 90th percentile");
  out += bar(kLeft + 290, 8, 12, 12, kPaper) +
         text(kLeft + 308, 18, "start", "the paper's published geometry on the same boundaries: median");
  for (std::size_t i = 0; i < panels; ++i) {
    out += panel(tables[i + 1], kPanelWide * static_cast<double>(i % 2),
                 kLegendHigh + kPanelHigh * static_cast<double>(i / 2));
  }
  return out + "</svg>\n";
}

}  // namespace mirada::rig
