#include <fmt/format.h>

#include <array>
#include <cmath>

#include "svg_parts.hpp"

namespace strandyn::report {
namespace {

/// By Colour; the ink comes from the style sheet.
constexpr std::array<std::string_view, 8> hex_colours = {"",        "#2f7fd1", "#e0762b", "#2b9d6c",
                                                         "#d64550", "#8b66d6", "#1f9aa8", "#8b949e"};

}  // namespace

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

std::string_view colour_of(const Series& series) {
  const std::string_view own = series.custom_colour;
  return own.empty() ? hex_colours[static_cast<std::size_t>(series.colour)] : own;
}

std::string painted(const Series& series, std::string_view attribute) {
  const std::string_view colour = colour_of(series);
  if (!colour.empty()) return fmt::format("{}=\"{}\"", attribute, colour);
  return attribute == "fill" ? "class=\"ink-fill\"" : "class=\"ink\"";
}

std::string text_at(Point at, std::string_view style, std::string_view anchor, std::string_view text) {
  return fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}</text>\n", style, px(at.x), px(at.y),
                     anchor, escaped(text));
}

std::string line_between(Point a, Point b, std::string_view style) {
  return fmt::format("<line class=\"{}\" x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/>\n", style, px(a.x), px(a.y), px(b.x),
                     px(b.y));
}

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

std::string escaped(std::string_view text) {
  constexpr std::string_view special = "&<>\"'";
  constexpr std::array<std::string_view, 5> harmless = {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"};
  std::string out;
  for (const char c : text) {
    const auto found = special.find(c);
    if (found == std::string_view::npos) {
      out += c;
    } else {
      out += harmless[found];
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

}  // namespace strandyn::report
