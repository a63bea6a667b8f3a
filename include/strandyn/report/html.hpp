#pragma once
/// \file Values as pieces of HTML: tables, and lists of names and values; the style sheet.

#include <string>
#include <string_view>
#include <vector>

#include "strandyn/results/value.hpp"

namespace strandyn::report {

/// A table of ready cells; all but the left ones are aligned as numbers.
struct HtmlTable {
  struct Column {
    std::string header;
    std::string unit = {};
    bool words = false;  ///< aligned left
  };
  std::vector<Column> columns;
  std::vector<std::vector<std::string>> rows;  ///< plain text, escaped on writing
};

std::string html(const HtmlTable& table);

/// How values are written.
struct Wording {
  bool as_in_file = false;    ///< or else: keys are labels with units, numbers are rounded and share a column's prefix
                              ///< (energies one for all)
  bool for_terminal = false;  ///< in plain letters: 1.5e-06 and a dash
  std::string path = {};      ///< of the object in the summary, with a dot at its end
  const std::vector<std::string>* left_out = nullptr;  ///< paths of numbers that are shown elsewhere
};

/// One row per object, one column per key that any of them has ("a.b" for objects inside); at most `most_rows` rows,
/// evenly spaced.
HtmlTable table_of_objects(const results::Value& objects, const Wording& wording, std::size_t most_rows);

/// Name, value, unit of every entry, objects inside flattened ("a.b"); lists of objects follow as tables. Empty where
/// there is nothing to show.
std::string html_of_object(const results::Value& object, const Wording& wording);

/// `name` stands for entry `i`, counted from 1, of a list of numbers or words: a table with two columns.
std::string html_of_list(std::string_view name, const results::Value& list, std::size_t most_rows);

/// CSS for light, dark and paper.
std::string_view page_style();

bool is_list_of_objects(const results::Value& value);

}  // namespace strandyn::report
