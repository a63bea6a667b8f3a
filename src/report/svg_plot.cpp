#include "strandyn/report/svg_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <string_view>

#include "strandyn/report/format.hpp"

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

/// Width of a text in the wider ones of the common sans-serif faces: what is laid out with it never overlaps.
double text_width(std::string_view text, double size) {
  double em = 0;
  for (const char c : text) {
    if ((c & 0xC0) == 0x80) continue;
    if (std::string_view("iljft.,:;'|()[]/ ").find(c) != std::string_view::npos) {
      em += 0.36;
    } else if (std::string_view("mwMW").find(c) != std::string_view::npos) {
      em += 0.92;
    } else {
      const bool wide = (c >= 'A' && c <= 'Z') || (c & 0x80) != 0;  // a minus sign, a superscript, a Greek letter
      em += wide ? 0.74 : 0.62;
    }
  }
  return em * size;
}

std::string px(double value) {
  std::string text = fmt::format("{:.2f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string hex(Colour colour) {
  switch (colour) {
    case Colour::blue:
      return "#2f7fd1";
    case Colour::orange:
      return "#e0762b";
    case Colour::green:
      return "#2b9d6c";
    case Colour::red:
      return "#d64550";
    case Colour::violet:
      return "#8b66d6";
    case Colour::teal:
      return "#1f9aa8";
    case Colour::grey:
      return "#8b949e";
    case Colour::ink:
      break;
  }
  return {};
}

/// Attributes that paint a line or a shape in the colour of the series.
std::string painted(const Series& series, std::string_view attribute) {
  const std::string colour = series.custom_colour.empty() ? hex(series.colour) : series.custom_colour;
  if (!colour.empty()) return fmt::format("{}=\"{}\"", attribute, colour);
  return attribute == "fill" ? "class=\"ink-fill\"" : "class=\"ink\"";
}

struct Point {
  double x = 0;
  double y = 0;
};

/// One axis of the drawing: from values to pixels, and its ticks.
class Scale {
 public:
  Scale(const Axis& axis, Range data, int most_ticks) : log_(axis.log) {
    const double largest = std::max(std::abs(data.low), std::abs(data.high));
    if (takes_prefix(axis.unit)) prefix_ = prefix_for(largest);
    const std::string unit = axis.unit.empty() ? "" : fmt::format("{}{}", prefix_.symbol, axis.unit);
    title = axis.label + (unit.empty() ? "" : " (" + unit + ")");
    range_ = {data.low / prefix_.factor, data.high / prefix_.factor};
    if (log_) {
      if (!axis.tight) range_ = {widened_down(range_.low), 1 / widened_down(1 / range_.high)};
      ticks = log_ticks(range_);
      if (std::count(ticks.labels.begin(), ticks.labels.end(), "") + 1 >= std::ssize(ticks.labels)) {
        ticks = linear_ticks(range_, most_ticks);
      }
    } else {
      if (!axis.tight) range_ = widened_to_steps(range_, most_ticks);
      ticks = linear_ticks(range_, most_ticks);
    }
  }

  void place(double from_px, double to_px) { from_ = from_px, to_ = to_px; }

  /// Pixel of a value in the unit of the data.
  double operator()(double value) const { return of_shown(value / prefix_.factor); }
  /// Pixel of a value in the unit of the ticks.
  double of_shown(double value) const {
    const double share = log_
                             ? (std::log(value) - std::log(range_.low)) / (std::log(range_.high) - std::log(range_.low))
                             : (value - range_.low) / range_.width();
    return from_ + share * (to_ - from_);
  }
  /// Pixel of zero, or of the end nearest to it.
  double base() const { return log_ ? from_ : of_shown(std::clamp(0.0, range_.low, range_.high)); }
  bool zero_inside() const { return !log_ && range_.low < 0 && range_.high > 0; }

  std::string title;
  Ticks ticks;

 private:
  /// The next 1, 2 or 5 times a power of ten at or below the value.
  static double widened_down(double value) {
    const double power = std::pow(10, std::floor(std::log10(value) + 1e-9));
    for (const double factor : {5.0, 2.0}) {
      if (value >= factor * power * (1 - 1e-9)) return factor * power;
    }
    return power;
  }

  bool log_;
  Prefix prefix_{1, ""};
  Range range_;
  double from_ = 0;
  double to_ = 1;
};

bool is_shown(double value, const Axis& axis) {
  return std::isfinite(value) && (!axis.log || value > 0);
}

/// Points of the series that the axes can show.
std::vector<Point> shown_points(const Series& series, const Plot& plot) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    if (is_shown(series.x[i], plot.x) && is_shown(series.y[i], plot.y)) points.push_back({series.x[i], series.y[i]});
  }
  return points;
}

/// What the axis has to hold; never empty, never of no width.
Range data_range(const std::vector<std::vector<Point>>& all, const Axis& axis, double Point::*coordinate) {
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const auto& points : all) {
    for (const Point& point : points) {
      range.low = std::min(range.low, point.*coordinate);
      range.high = std::max(range.high, point.*coordinate);
    }
  }
  if (range.low > range.high) range = axis.log ? Range{1, 10} : Range{0, 1};
  if (axis.from_zero && !axis.log) range = {std::min(range.low, 0.0), std::max(range.high, 0.0)};
  const double largest = std::max(std::abs(range.low), std::abs(range.high));
  if (range.width() <= 1e-9 * largest || largest == 0) {
    if (axis.log) return {range.low / 2, range.high * 2};
    const double half = largest == 0 ? 1 : 0.1 * largest;
    return {range.low - half, range.high + half};
  }
  return range;
}

std::string text_at(Point at, std::string_view style, std::string_view anchor, std::string_view text) {
  return fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}</text>\n", style, px(at.x), px(at.y),
                     anchor, escaped(text));
}

std::string line_between(Point a, Point b, std::string_view style) {
  return fmt::format("<line class=\"{}\" x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/>\n", style, px(a.x), px(a.y), px(b.x),
                     px(b.y));
}

/// Path data through the points; those that fall on the same spot of the screen are drawn once.
std::string path_data(const std::vector<Point>& pixels) {
  constexpr double same_spot = 0.3;
  std::string data;
  Point last;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const bool ends = i == 0 || i + 1 == pixels.size();
    if (!ends && std::hypot(pixels[i].x - last.x, pixels[i].y - last.y) < same_spot) continue;
    last = pixels[i];
    data += fmt::format("{}{} {}", i == 0 ? "M" : "L", px(last.x), px(last.y));
  }
  return data;
}

std::string drawn(const Series& series, const std::vector<Point>& points, const Scale& x, const Scale& y) {
  if (points.empty()) return {};
  std::vector<Point> pixels;
  for (const Point& point : points) pixels.push_back({x(point.x), y(point.y)});
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

}  // namespace

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::vector<std::string> ramp(std::size_t count) {
  static constexpr std::array<std::array<double, 3>, 5> stops = {
      {{47, 127, 209}, {124, 100, 214}, {190, 82, 170}, {217, 84, 100}, {224, 126, 43}}};
  std::vector<std::string> colours;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = count == 1 ? 0 : 4.0 * static_cast<double>(i) / static_cast<double>(count - 1);
    const auto stop = std::min<std::size_t>(static_cast<std::size_t>(at), 3);
    std::array<int, 3> rgb{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double part = at - static_cast<double>(stop);
      rgb[k] = static_cast<int>(std::lround(stops[stop][k] + part * (stops[stop + 1][k] - stops[stop][k])));
    }
    colours.push_back(fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]));
  }
  return colours;
}

std::string svg(const Plot& plot, SvgUse use) {
  std::vector<std::vector<Point>> points;
  for (const Series& series : plot.series) points.push_back(shown_points(series, plot));

  Scale x(plot.x, data_range(points, plot.x, &Point::x), plot.width / 85);
  Scale y(plot.y, data_range(points, plot.y, &Point::y), plot.height / 55);

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

  std::string out;
  const std::string_view name_space = use == SvgUse::standalone ? " xmlns=\"http://www.w3.org/2000/svg\"" : "";
  out += fmt::format(
      "<svg{} class=\"plot\" viewBox=\"0 0 {} {}\"{} role=\"img\" aria-label=\"{}\">\n", name_space, plot.width,
      plot.height, use == SvgUse::standalone ? fmt::format(" width=\"{}\" height=\"{}\"", plot.width, plot.height) : "",
      escaped(plot.title));
  if (use == SvgUse::standalone) out += std::string(standalone_style) + "\n";
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
  out += line_between({left, bottom}, {right, bottom}, "axis");
  if (y.zero_inside()) out += line_between({left, y.of_shown(0)}, {right, y.of_shown(0)}, "axis");
  if (x.zero_inside()) out += line_between({x.of_shown(0), top}, {x.of_shown(0), bottom}, "axis");
  if (!x.title.empty()) out += text_at({(left + right) / 2, plot.height - 8.0}, "label", "middle", x.title);

  out += "<g stroke-linejoin=\"round\" stroke-linecap=\"round\">\n";
  for (std::size_t i = 0; i < plot.series.size(); ++i) out += drawn(plot.series[i], points[i], x, y);
  out += "</g>\n</svg>\n";
  return out;
}

}  // namespace strandyn::report
