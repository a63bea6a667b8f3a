#pragma once
/// \file The numbers and tables that a run asks to show, for the terminal and for the page.

#include <string>
#include <vector>

#include "strandyn/report/format.hpp"
#include "strandyn/report/html.hpp"
#include "strandyn/results/figure.hpp"
#include "strandyn/results/table.hpp"

namespace strandyn::report {

/// Of long tables some rows are shown: the first, the last, and evenly spaced ones between.
struct Showing {
  std::size_t most_rows = 20;
  bool for_terminal = false;
};

/// The number with the unit that its path ends with; a share in per cent.
Quantity quantity_of(const results::Highlight& highlight);

/// A line each, aligned. Empty text for none.
std::string text_of(const std::vector<results::Highlight>& highlights);

/// The columns as the page and as the terminal show them; energies share one prefix, so that the parts of a ledger can
/// be read side by side. Empty where the table has no rows. Throw InputError where a column is missing.
HtmlTable html_of(const results::ShownTable& shown, const results::Table& table, const Showing& how = {});
std::string text_of(const results::ShownTable& shown, const results::Table& table);

}  // namespace strandyn::report
