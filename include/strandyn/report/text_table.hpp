#pragma once
/// \file Aligned plain-text tables for a terminal.
///
///      cycle     t  amplitude
///                s         mm
///      -----  ----  ---------
///          1  0.10      1.250

#include <concepts>
#include <optional>
#include <string>
#include <vector>

namespace strandyn::report {

enum class Align { left, right };

struct TextColumn {
  std::string header;     ///< its lines stand above each other
  std::string unit = {};  ///< last line of the header, left out where no column has one
  int digits = 4;         ///< significant digits of numbers
  Align align = Align::right;
};

/// What stands in a row: words, a count, a number for the column's digits, or nothing ("-").
class Cell {
 public:
  Cell(std::string text) : text_(std::move(text)) {}
  Cell(const char* text) : text_(text) {}
  Cell(std::integral auto count) : text_(std::to_string(count)) {}
  Cell(double number) : number_(number) {}
  Cell(std::optional<double> number) : text_("-"), number_(number) {}

  std::string shown(int digits) const;

 private:
  std::string text_;
  std::optional<double> number_;
};

class TextTable {
 public:
  explicit TextTable(std::vector<TextColumn> columns) : columns_(std::move(columns)) {}

  /// One cell per column: std::invalid_argument otherwise.
  void add_row(const std::vector<Cell>& row);

  /// All lines, each ended by a line break, without blanks at their ends.
  std::string str() const;

 private:
  std::vector<TextColumn> columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// Characters on the screen: code points of UTF-8 text.
int shown_width(std::string_view text);

}  // namespace strandyn::report
