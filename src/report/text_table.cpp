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

std::vector<std::string> lines_from_below(std::string_view text) {
  std::vector<std::string> lines;
  for (auto end = text.rfind('\n'); end != std::string_view::npos; end = text.rfind('\n')) {
    lines.emplace_back(text.substr(end + 1));
    text = text.substr(0, end);
  }
  lines.emplace_back(text);
  return lines;
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
  std::vector<std::vector<std::string>> headers;  // from the last line up
  std::vector<std::string> units;
  std::vector<std::string> rules;
  std::vector<int> widths;
  bool has_units = false;
  std::size_t header_lines = 1;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    headers.push_back(lines_from_below(columns_[i].header));
    header_lines = std::max(header_lines, headers.back().size());
    int width = shown_width(columns_[i].unit);
    for (const std::string& line : headers.back()) width = std::max(width, shown_width(line));
    for (const auto& row : rows_) width = std::max(width, shown_width(row[i]));
    widths.push_back(width);
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
  for (std::size_t above = header_lines; above-- > 0;) {
    std::vector<std::string> line;
    for (const auto& header : headers) line.push_back(above < header.size() ? header[above] : "");
    add_line(line);
  }
  if (has_units) add_line(units);
  add_line(rules);
  for (const auto& row : rows_) add_line(row);
  return text;
}

}  // namespace strandyn::report
