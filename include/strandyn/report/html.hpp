#pragma once
/// \file JSON values as pieces of HTML: tables, and lists of names and values.

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

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

/// Keys are labels with units, numbers are rounded and share the prefix of their column (a result), or everything
/// stands as in the file (the case).
enum class Wording { result, as_written };

/// One row per object, one column per key that any of them has; at most `most_rows` rows, evenly spaced.
HtmlTable table_of_objects(const nlohmann::ordered_json& objects, Wording wording, std::size_t most_rows);

/// Name, value, unit of every entry that is no table of its own; objects inside are flattened ("a.b").
std::string html_list(const nlohmann::ordered_json& object, Wording wording);

bool is_list_of_objects(const nlohmann::ordered_json& json);

}  // namespace strandyn::report
