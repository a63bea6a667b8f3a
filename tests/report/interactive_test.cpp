#include "strandyn/report/interactive.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "strandyn/results/json.hpp"

using namespace strandyn;
using report::PagePlot;
using report::Plot;
using report::Series;

namespace {

Series wave(int points) {
  Series series;
  for (int i = 0; i < points; ++i) {
    series.x.push_back(0.001 * i);
    series.y.push_back(std::sin(0.37 * i) * std::exp(-1e-5 * i));
  }
  return series;
}

}  // namespace

TEST_CASE("interactive: a long line keeps its ends and its extremes and its order") {
  const Series all = wave(100000);
  const Series few = report::thinned(all, 1000);
  CHECK(few.x.size() <= 1000);
  CHECK(few.x.size() > 900);
  CHECK(few.x.front() == all.x.front());
  CHECK(few.x.back() == all.x.back());
  CHECK(std::ranges::is_sorted(few.x));
  CHECK(std::ranges::max(few.y) == std::ranges::max(all.y));
  CHECK(std::ranges::min(few.y) == std::ranges::min(all.y));
  const Series same = report::thinned(wave(900), 1000);
  CHECK(same.x == wave(900).x);
}

TEST_CASE("interactive: the page holds the numbers of its plots, to the bit, and nothing that ends its scripts") {
  Plot plot{.title = "a </script> title", .series = {wave(50)}};
  plot.series[0].name = "a </script> name";
  plot.y = {.label = "energy", .unit = "J"};
  const std::string text = report::interactive({PagePlot{.name = "wave", .plot = &plot}});
  if (report::page_scripts().library.empty()) {
    CHECK(text.empty());
    return;
  }
  const std::string begin = "<script type=\"application/json\" id=\"plots\">";
  REQUIRE(text.starts_with(begin));
  const std::string data = text.substr(begin.size(), text.find("</script>") - begin.size());
  const results::Value plots = results::from_text(data, "plots");
  const results::Value& line = plots.entries().at(0).find("lines")->entries().at(0);
  for (std::size_t i = 0; i < 50; ++i) {
    CHECK(line.find("x")->entries()[i].number() == plot.series[0].x[i]);
    CHECK(line.find("y")->entries()[i].number() == plot.series[0].y[i]);
  }
  CHECK(*line.find("name")->words() == "a </script> name");
  CHECK(report::interactive({}).empty());
}
