#include "strandyn/report/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "strandyn/report/format.hpp"

namespace strandyn::report {
namespace {

constexpr std::string_view gap = "  ";

std::string padded(const std::string& text, int width, Align align) {
  const std::string blanks(static_cast<std::size_t>(std::max(0, width - shown_width(text))), ' ');
  return align == Align::right ? blanks + text : text + blanks;
}

}  // namespace

std::string Cell::shown(int digits) const {
  return number_ ? significant(*number_, digits) : text_;
}

int shown_width(std::string_view text) {
  return static_cast<int>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

void TextTable::add_row(const std::vector<Cell>& row) {
  if (row.size() != columns_.size()) {
    throw std::invalid_argument(fmt::format("text table: {} cells for {} columns", row.size(), columns_.size()));
  }
  auto& shown = rows_.emplace_back();
  for (std::size_t i = 0; i < row.size(); ++i) shown.push_back(row[i].shown(columns_[i].digits));
}

std::string TextTable::str() const {
  std::vector<std::string> headers;
  std::vector<std::string> units;
  std::vector<std::string> rules;
  std::vector<int> widths;
  bool has_units = false;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    int width = std::max(shown_width(columns_[i].header), shown_width(columns_[i].unit));
    for (const auto& row : rows_) width = std::max(width, shown_width(row[i]));
    widths.push_back(width);
    headers.push_back(columns_[i].header);
    units.push_back(columns_[i].unit);
    rules.emplace_back(static_cast<std::size_t>(width), '-');
    has_units = has_units || !columns_[i].unit.empty();
  }
  std::string text;
  const auto add_line = [&](const std::vector<std::string>& cells) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (i > 0) line += gap;
      line += padded(cells[i], widths[i], columns_[i].align);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  };
  add_line(headers);
  if (has_units) add_line(units);
  add_line(rules);
  for (const auto& row : rows_) add_line(row);
  return text;
}

}  // namespace strandyn::report
