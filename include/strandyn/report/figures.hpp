#pragma once
/// \file From a figure that a run describes to a plot. Axes, units, names of lines and colours come from the names of
/// the columns; nothing here knows what was computed.

#include <optional>

#include "strandyn/report/svg_plot.hpp"
#include "strandyn/results/figure.hpp"
#include "strandyn/results/table.hpp"

namespace strandyn::report {

/// Nothing where less than two points can be drawn: a run that ended early. Throws InputError where the figure asks for
/// a column that the table does not have, or for a kind or a scale that there is not.
///
/// A `map` colours the plane of x and the first y by the second y; with another number of y, and as `section` and
/// `motion`, it is drawn as lines.
std::optional<Plot> plot_of(const results::Figure& figure, const results::Table& table);

}  // namespace strandyn::report
