#include "strandyn/report/svg_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "svg_parts.hpp"

namespace strandyn::report {
namespace {

// Sizes in pixels of the drawing.
constexpr double title_size = 15;
constexpr double label_size = 12.5;
constexpr double tick_size = 12;
constexpr double swatch = 18;
constexpr double legend_gap = 20;
constexpr double row_height = 22;

/// Text and grid read on white and on black; the page overrides them with its own (class names below).
constexpr std::string_view standalone_style =
    "<style>"
    ".plot text{font-family:system-ui,-apple-system,'Segoe UI','Helvetica Neue',Arial,'Liberation Sans',sans-serif;"
    "fill:#737c87}"
    ".plot .title{font-size:15px;font-weight:600}"
    ".plot .label{font-size:12.5px}"
    ".plot .tick{font-size:12px;font-variant-numeric:tabular-nums}"
    ".plot .grid{stroke:#8b949e;stroke-opacity:.22}"
    ".plot .axis{stroke:#8b949e;stroke-opacity:.75}"
    ".plot .ink{stroke:#737c87}"
    ".plot .ink-fill{fill:#737c87}"
    "</style>";

std::vector<Point> pixels_of(const std::vector<Point>& points, const Scale& x, const Scale& y) {
  std::vector<Point> pixels;
  for (const Point& point : points) pixels.push_back({x(point.x), y(point.y)});
  return pixels;
}

std::string drawn_band(const Series& series, const std::vector<Point>& high, std::vector<Point> low) {
  if (high.empty() || low.empty()) return {};
  std::string out;
  for (const std::vector<Point>* edge : std::initializer_list<const std::vector<Point>*>{&high, &low}) {
    out += fmt::format("<path {} fill=\"none\" stroke-width=\"1\" d=\"{}\"/>\n", painted(series, "stroke"),
                       path_data(*edge));
  }
  std::reverse(low.begin(), low.end());
  std::string back = path_data(low);
  back.front() = 'L';
  return fmt::format("<path {} fill-opacity=\".3\" d=\"{}{}Z\"/>\n", painted(series, "fill"), path_data(high), back) +
         out;
}

std::string drawn(const Series& series, const std::vector<Point>& points, const Scale& x, const Scale& y) {
  if (points.empty()) return {};
  const std::vector<Point> pixels = pixels_of(points, x, y);
  std::string out;
  if (series.filled) {
    out += fmt::format("<path {} fill-opacity=\".16\" d=\"{}L{} {}L{} {}Z\"/>\n", painted(series, "fill"),
                       path_data(pixels), px(pixels.back().x), px(y.base()), px(pixels.front().x), px(y.base()));
  }
  if (series.line) {
    out += fmt::format("<path {} fill=\"none\" stroke-width=\"{}\"{} d=\"{}\"/>\n", painted(series, "stroke"),
                       px(series.width), series.dashed ? " stroke-dasharray=\"5 4\"" : "", path_data(pixels));
  }
  if (series.markers) {
    for (const Point& pixel : pixels) {
      out +=
          fmt::format("<circle {} cx=\"{}\" cy=\"{}\" r=\"3\"/>\n", painted(series, "fill"), px(pixel.x), px(pixel.y));
    }
  }
  return out;
}

struct LegendEntry {
  const Series* series;
  double width;  ///< [px] swatch and text
};

/// The entries broken into rows that fit.
std::vector<std::vector<LegendEntry>> legend_rows(const std::vector<Series>& all, double room) {
  std::vector<std::vector<LegendEntry>> rows;
  double used = 0;
  for (const Series& series : all) {
    if (series.name.empty()) continue;
    const double width = swatch + 7 + text_width(series.name, label_size);
    if (rows.empty() || used + legend_gap + width > room) {
      rows.emplace_back();
      used = -legend_gap;
    }
    rows.back().push_back({&series, width});
    used += legend_gap + width;
  }
  return rows;
}

double width_of(const std::vector<LegendEntry>& row) {
  double width = -legend_gap;
  for (const LegendEntry& entry : row) width += legend_gap + entry.width;
  return width;
}

std::string drawn(const std::vector<LegendEntry>& row, Point at) {
  std::string out;
  for (const LegendEntry& entry : row) {
    const Series& series = *entry.series;
    const double middle = at.y - 4;
    if (series.line) {
      out += fmt::format("<path {} fill=\"none\" stroke-width=\"{}\"{} d=\"M{} {}H{}\"/>\n", painted(series, "stroke"),
                         px(std::max(series.width, 2.0)), series.dashed ? " stroke-dasharray=\"5 4\"" : "", px(at.x),
                         px(middle), px(at.x + swatch));
    }
    if (series.markers) {
      out += fmt::format("<circle {} cx=\"{}\" cy=\"{}\" r=\"3\"/>\n", painted(series, "fill"), px(at.x + swatch / 2),
                         px(middle));
    }
    out += text_at({at.x + swatch + 7, at.y}, "label", "start", series.name);
    at.x += entry.width + legend_gap;
  }
  return out;
}

std::string beginning(const Plot& plot, SvgUse use) {
  const bool alone = use == SvgUse::standalone;
  std::string out = fmt::format("<svg{} class=\"plot\" viewBox=\"0 0 {} {}\"{} role=\"img\" aria-label=\"{}\">\n",
                                alone ? " xmlns=\"http://www.w3.org/2000/svg\"" : "", plot.width, plot.height,
                                alone ? fmt::format(" width=\"{}\" height=\"{}\"", plot.width, plot.height) : "",
                                escaped(plot.title));
  if (alone) out += std::string(standalone_style) + "\n";
  return out;
}

std::string svg_of_wires(const Plot& plot, SvgUse use) {
  constexpr double side = 4;
  std::string out = beginning(plot, use);
  double top = 4;
  if (use == SvgUse::standalone && !plot.title.empty()) {
    out += text_at({side, title_size + 3}, "title", "start", plot.title);
    top = title_size + 16;
  }
  const double bottom = plot.height - row_height;
  out += drawn(*plot.wires, {side, top}, {plot.width - side, bottom});
  Cells key;
  key.label = plot.wires->label;
  key.value = {0, 1};
  return out + colour_key(key, {plot.width - side, plot.height - 6.0}) + "</svg>\n";
}

}  // namespace

std::string svg(const Plot& plot, SvgUse use) {
  std::vector<std::vector<Point>> points;
  for (const Series& series : plot.series) points.push_back(shown_points(series.x, series.y, plot));
  std::vector<std::vector<Point>> all = points;
  for (const Series& series : plot.series) all.push_back(shown_points(series.x, series.low, plot));
  if (plot.cells) all.push_back(shown_points(plot.cells->x, plot.cells->y, plot));
  if (plot.wires) return svg_of_wires(plot, use);

  Scale x(plot.x, data_range(all, plot.x, &Point::x), plot.width / 85);
  Scale y(plot.y, data_range(all, plot.y, &Point::y), plot.height / 55);

  // Margins follow what has to stand in them.
  double label_room = 0;
  for (const std::string& label : y.ticks.labels) label_room = std::max(label_room, text_width(label, tick_size));
  const double side = 4;
  const double left = side + label_room + 9;
  const double right = plot.width - side -
                       std::max(12.0, text_width(x.ticks.labels.empty() ? "" : x.ticks.labels.back(), tick_size) / 2);
  const bool titled = use == SvgUse::standalone && !plot.title.empty();
  auto legend = legend_rows(plot.series, right - side);
  const bool beside =
      legend.size() == 1 && text_width(y.title, label_size) + 2 * legend_gap + width_of(legend[0]) < right - side;
  double top = titled ? title_size + 16 : 4;

  std::string out = beginning(plot, use);
  if (titled) out += text_at({side, title_size + 3}, "title", "start", plot.title);
  if (!beside) {
    for (const auto& row : legend) {
      top += row_height;
      out += drawn(row, {side, top - 6});
    }
  }
  top += row_height;
  out += text_at({side, top - 6}, "label", "start", y.title);
  if (beside) out += drawn(legend[0], {right - width_of(legend[0]), top - 6});
  if (plot.cells) out += colour_key(*plot.cells, {right, top - 6});
  top += 8;
  const double bottom = plot.height - (x.title.empty() ? 28.0 : 48.0);
  x.place(left, right);
  y.place(bottom, top);

  for (std::size_t i = 0; i < x.ticks.at.size(); ++i) {
    const double at = x.of_shown(x.ticks.at[i]);
    if (!x.ticks.labels[i].empty()) out += line_between({at, top}, {at, bottom}, "grid");
    out += line_between({at, bottom}, {at, bottom + (x.ticks.labels[i].empty() ? 3 : 5)}, "axis");
    if (!x.ticks.labels[i].empty()) out += text_at({at, bottom + 19}, "tick", "middle", x.ticks.labels[i]);
  }
  for (std::size_t i = 0; i < y.ticks.at.size(); ++i) {
    const double at = y.of_shown(y.ticks.at[i]);
    if (y.ticks.labels[i].empty()) {
      out += line_between({left - 3, at}, {left, at}, "axis");
      continue;
    }
    out += line_between({left, at}, {right, at}, "grid");
    out += text_at({left - 9, at + 4}, "tick", "end", y.ticks.labels[i]);
  }
  if (plot.cells) out += drawn(*plot.cells, plot, x, y, {left, top}, {right, bottom});
  out += line_between({left, bottom}, {right, bottom}, "axis");
  if (y.zero_inside()) out += line_between({left, y.of_shown(0)}, {right, y.of_shown(0)}, "axis");
  if (x.zero_inside()) out += line_between({x.of_shown(0), top}, {x.of_shown(0), bottom}, "axis");
  if (!x.title.empty()) out += text_at({(left + right) / 2, plot.height - 8.0}, "label", "middle", x.title);

  out += "<g stroke-linejoin=\"round\" stroke-linecap=\"round\">\n";
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const Series& series = plot.series[i];
    out += series.low.empty()
               ? drawn(series, points[i], x, y)
               : drawn_band(series, pixels_of(points[i], x, y), pixels_of(all[plot.series.size() + i], x, y));
  }
  out += "</g>\n</svg>\n";
  return out;
}

}  // namespace strandyn::report
