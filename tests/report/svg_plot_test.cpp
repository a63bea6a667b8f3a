#include "strandyn/report/svg_plot.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <regex>

#include "report/markup.hpp"

using strandyn::report::escaped;
using strandyn::report::linear_ticks;
using strandyn::report::log_ticks;
using strandyn::report::nice_step;
using strandyn::report::Plot;
using strandyn::report::ramp;
using strandyn::report::svg;
using strandyn::report::SvgUse;
using strandyn::report::widened_to_steps;
using strandyn::test::contains;
using strandyn::test::count_of;
using strandyn::test::find_markup_fault;

namespace {

using Labels = std::vector<std::string>;

Plot sample() {
  return {.title = "A <plot> & more",
          .x = {.label = "time", .unit = "s", .tight = true},
          .y = {.label = "energy", .unit = "J", .from_zero = true},
          .series = {{.name = "friction", .x = {0, 1, 2, 3}, .y = {0, 1e-3, 2e-3, 1.5e-3}, .filled = true},
                     {.name = "numerical", .x = {0, 3}, .y = {0, 1e-5}, .dashed = true, .markers = true}}};
}

/// No number of the drawing is broken, and all of it lies on the canvas.
void check_sound(const Plot& plot) {
  for (const auto use : {SvgUse::standalone, SvgUse::inside_page}) {
    const std::string text = svg(plot, use);
    CHECK(find_markup_fault(text) == "");
    CHECK_FALSE(contains(text, "nan"));
    CHECK_FALSE(contains(text, "inf"));
    const std::regex coordinates("[ML](-?[0-9.]+) (-?[0-9.]+)");
    int outside = 0;
    for (std::sregex_iterator it(text.begin(), text.end(), coordinates), end; it != end; ++it) {
      const double x = std::stod((*it)[1]);
      const double y = std::stod((*it)[2]);
      outside += x < 0 || x > plot.width || y < 0 || y > plot.height;
    }
    CHECK(outside == 0);
  }
}

}  // namespace

TEST_CASE("ticks: steps are 1, 2 or 5 times a power of ten and cover the range") {
  CHECK(nice_step({0, 1}, 5) == 0.2);
  CHECK(nice_step({0, 1}, 10) == 0.1);
  CHECK(nice_step({0, 99}, 4) == 50);
  CHECK(nice_step({0, 101}, 5) == 50);
  for (double width = 1e-6; width < 1e6; width *= 1.37) {
    for (const int most : {3, 5, 8}) {
      const double step = nice_step({0, width}, most);
      CHECK(step * most >= width * (1 - 1e-8));
      CHECK(step * most <= width * 2.51);  // the next smaller step would not do; 2 -> 5 is the widest gap
    }
  }
}

TEST_CASE("ticks: an axis is widened to whole steps, and stays where it already is") {
  const auto range = widened_to_steps({-0.093, 0.087}, 5);
  CHECK(range.low == -0.1);
  CHECK(range.high == 0.1);
  const auto kept = widened_to_steps({0, 1.5}, 3);
  CHECK(kept.low == 0);
  CHECK(kept.high == 1.5);
}

TEST_CASE("ticks: labels share their decimals, and zero is plain") {
  CHECK(linear_ticks({-0.1, 0.1}, 4).labels == Labels{"−0.10", "−0.05", "0", "0.05", "0.10"});
  CHECK(linear_ticks({0, 1.5}, 3).labels == Labels{"0", "0.5", "1.0", "1.5"});
  CHECK(linear_ticks({1, 200}, 5).labels == Labels{"50", "100", "150", "200"});
  CHECK(linear_ticks({0, 2e-7}, 2).labels == Labels{"0", "1×10⁻⁷", "2×10⁻⁷"});
  CHECK(linear_ticks({0, 4e6}, 4).labels == Labels{"0", "1×10⁶", "2×10⁶", "3×10⁶", "4×10⁶"});
}

TEST_CASE("ticks: a log axis labels decades, and 2 and 5 between few of them") {
  const auto labelled = [](const strandyn::report::Ticks& ticks) {
    Labels labels;
    for (const auto& label : ticks.labels) {
      if (!label.empty()) labels.push_back(label);
    }
    return labels;
  };
  CHECK(labelled(log_ticks({5, 50})) == Labels{"5", "10", "20", "50"});
  CHECK(labelled(log_ticks({0.01, 100})) == Labels{"0.01", "0.1", "1", "10", "100"});
  CHECK(labelled(log_ticks({1e-7, 1e-4})) == Labels{"10⁻⁷", "10⁻⁶", "10⁻⁵", "0.0001"});
  CHECK(log_ticks({1, 100}).at.size() == 19);
  CHECK(labelled(log_ticks({1e-12, 1e12})) ==
        Labels{"10⁻¹²", "10⁻⁹", "10⁻⁶", "0.001", "1", "1000", "10⁶", "10⁹", "10¹²"});
}

TEST_CASE("svg: a plot is well-formed, on its canvas, with its names made harmless") {
  check_sound(sample());
  const auto text = svg(sample());
  CHECK(contains(text, "xmlns=\"http://www.w3.org/2000/svg\""));
  CHECK(contains(text, ">A &lt;plot&gt; &amp; more</text>"));
  CHECK(contains(text, ">friction</text>"));
  CHECK(contains(text, ">numerical</text>"));
  CHECK(contains(text, "stroke-dasharray"));
  CHECK(contains(text, ">time (s)</text>"));
  CHECK(contains(text, ">energy (mJ)</text>"));  // 2e-3 J
  CHECK(contains(text, ">1.5</text>"));
  CHECK_FALSE(contains(text, "href"));
  CHECK(escaped("<a b='c' d=\"e\">&") == "&lt;a b=&#39;c&#39; d=&quot;e&quot;&gt;&amp;");
}

TEST_CASE("svg: inside the page there is no style, no title and no fixed size") {
  const auto text = svg(sample(), SvgUse::inside_page);
  CHECK_FALSE(contains(text, "<style>"));
  CHECK_FALSE(contains(text, "class=\"title\""));
  CHECK_FALSE(contains(text, " width=\"720\""));
  CHECK(contains(text, "viewBox=\"0 0 720 400\""));
}

TEST_CASE("svg: points that are not finite, and not positive on a log axis, are left out") {
  Plot plot = sample();
  plot.series[0].y[1] = std::nan("");
  plot.series[0].x[2] = HUGE_VAL;
  check_sound(plot);

  Plot log = sample();
  log.y.log = true;
  log.x.log = true;
  log.series[0].filled = false;
  check_sound(log);
  CHECK(count_of(svg(log), "<circle") == 2);  // the legend's and the point at 3 s: the one at zero is gone
}

TEST_CASE("svg: empty, constant, single and huge data still give sound axes") {
  check_sound({.title = "none", .series = {}});
  check_sound({.title = "empty", .series = {{.x = {}, .y = {}}}});
  check_sound({.title = "zero", .y = {.from_zero = true}, .series = {{.x = {1, 2}, .y = {0, 0}, .filled = true}}});
  check_sound({.title = "constant", .series = {{.x = {1, 2}, .y = {5, 5}}}});
  check_sound(
      {.title = "constant, log", .x = {.log = true}, .y = {.log = true}, .series = {{.x = {3, 3}, .y = {5, 5}}}});
  check_sound({.title = "single", .series = {{.x = {1e-12}, .y = {-1e15}, .markers = true}}});
  check_sound({.title = "wide", .y = {.log = true}, .series = {{.x = {0, 1}, .y = {1e-300, 1e300}}}});
  check_sound({.title = "uneven", .series = {{.x = {0, 1, 2}, .y = {1, 2}}}});
}

TEST_CASE("svg: points on the same spot are drawn once, the last one always") {
  Plot plot{.title = "dense", .series = {{.x = {}, .y = {}}}};
  for (int i = 0; i <= 100000; ++i) {
    plot.series[0].x.push_back(i);
    plot.series[0].y.push_back(i);
  }
  const auto text = svg(plot);
  CHECK(text.size() < 60000);  // at most a point per 0.3 px of a line of some 750 px
  check_sound(plot);
}

TEST_CASE("svg: a ramp runs from blue to orange in distinct colours") {
  CHECK(ramp(0).empty());
  CHECK(ramp(1) == Labels{"#2f7fd1"});
  const auto colours = ramp(5);
  CHECK(colours.front() == "#2f7fd1");
  CHECK(colours.back() == "#e07e2b");
  for (std::size_t i = 1; i < colours.size(); ++i) CHECK(colours[i] != colours[i - 1]);
}
