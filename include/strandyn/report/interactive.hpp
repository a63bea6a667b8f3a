#pragma once
/// \file Plots that a reader can ask, zoom and take apart, by scripts inside the page: nothing is fetched when it is
/// read.
///
/// The library that draws them (Plotly) is put into the program when it is built, where it could be fetched then.
/// Without it, and where no script runs, the page shows its SVG figures, which are also what is printed.

#include <string>
#include <string_view>
#include <vector>

#include "strandyn/report/svg_plot.hpp"

namespace strandyn::report {

/// Made by the build; empty where it has no library.
struct PageScripts {
  std::string_view library;
  std::string_view plots;  ///< draws what `interactive` hands over
};
PageScripts page_scripts();

struct PagePlot {
  std::string name;
  const Plot* plot = nullptr;
  bool moves = false;  ///< its lines are moments of a motion, one after the other
};

/// The numbers of the plots and the scripts that draw them: the end of a page whose figure i has data-plot="i". Empty
/// without the library, or without plots.
std::string interactive(const std::vector<PagePlot>& plots);

/// A long line by the lowest and the highest point of each of so many parts: looks the same. `points` at least 4.
Series thinned(const Series& series, std::size_t points);

}  // namespace strandyn::report
