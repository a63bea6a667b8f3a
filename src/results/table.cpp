#include "strandyn/results/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "strandyn/core/error.hpp"
#include "strandyn/results/folder.hpp"
#include "strandyn/results/writing.hpp"

namespace strandyn::results {
namespace {

/// What is wrong with the names of the columns, in words, or nothing.
std::optional<std::string> find_fault(const std::vector<std::string>& names) {
  if (names.empty()) return "there are no columns";
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].empty()) return fmt::format("column {} has no name", i + 1);
    if (names[i].find_first_of(",\"\r\n") != std::string::npos) {
      return fmt::format("the column name '{}' has a comma, a quote or a line break in it", names[i]);
    }
    if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]) !=
        names.begin() + static_cast<std::ptrdiff_t>(i)) {
      return fmt::format("there are two columns '{}'", names[i]);
    }
  }
  return std::nullopt;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r";
  const auto first = text.find_first_not_of(blank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> parts;
  for (std::size_t comma = 0; comma != std::string_view::npos;) {
    comma = line.find(',');
    parts.push_back(trimmed(line.substr(0, comma)));
    if (comma != std::string_view::npos) line.remove_prefix(comma + 1);
  }
  return parts;
}

std::optional<double> parse_finite(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// Hands out the lines of a text that are not blank, and counts all of them.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (rest_.starts_with(byte_order_mark)) rest_.remove_prefix(byte_order_mark.size());
  }
  bool next(std::string_view& line) {
    while (!rest_.empty()) {
      const auto end = std::min(rest_.find('\n'), rest_.size());
      line = trimmed(rest_.substr(0, end));
      rest_.remove_prefix(std::min(end + 1, rest_.size()));
      ++number_;
      if (!line.empty()) return true;
    }
    return false;
  }
  int number() const { return number_; }

 private:
  std::string_view rest_;
  int number_ = 0;
};

}  // namespace

Table::Table(std::vector<std::string> names) : names_(std::move(names)), columns_(names_.size()) {
  if (const auto fault = find_fault(names_)) throw std::invalid_argument("table: " + *fault);
}

void Table::append(std::span<const double> row) {
  if (row.size() != columns_.size()) {
    throw std::invalid_argument(fmt::format("table: {} values for {} columns", row.size(), columns_.size()));
  }
  for (std::size_t i = 0; i < row.size(); ++i) columns_[i].push_back(row[i]);
}

bool Table::has(std::string_view name) const {
  return std::find(names_.begin(), names_.end(), name) != names_.end();
}

const std::vector<double>& Table::column(std::string_view name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end()) {
    throw std::out_of_range(fmt::format("there is no column '{}', only {}", name, fmt::join(names_, ", ")));
  }
  return columns_[static_cast<std::size_t>(found - names_.begin())];
}

std::vector<std::size_t> evenly_spaced(std::size_t count, std::size_t most) {
  std::vector<std::size_t> chosen;
  const std::size_t n = std::min(count, most);
  for (std::size_t i = 0; i < n; ++i) chosen.push_back(n == 1 ? count - 1 : (i * (count - 1) + (n - 1) / 2) / (n - 1));
  return chosen;
}

Groups groups_of(const Table& table, const std::vector<std::string>& columns, const std::vector<std::size_t>& rows) {
  Groups groups;
  for (const std::size_t row : rows) {
    std::vector<double> values;
    for (const std::string& name : columns) values.push_back(table.column(name)[row]);
    groups[values].push_back(row);
  }
  return groups;
}

void write_csv(const std::filesystem::path& path, const Table& table) {
  const Writing writing;
  std::string text = fmt::format("{}\n", fmt::join(table.names(), ","));
  auto out = std::back_inserter(text);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t i = 0; i < table.names().size(); ++i) {
      const double value = table.column(i)[row];
      if (!std::isfinite(value)) {
        throw FileError(fmt::format("refused to write {}: column {}, row {} is not a finite number", path.string(),
                                    table.names()[i], row + 1));
      }
      fmt::format_to(out, "{}{}", i == 0 ? "" : ",", value);
    }
    text += '\n';
  }
  write_file(path, text);
}

Table read_csv(const std::filesystem::path& path) {
  const std::string text = read_file(path);
  Lines lines(text);
  const auto fail = [&](const std::string& fault) {
    return InputError(fmt::format("{}, line {}: {}", path.string(), std::max(lines.number(), 1), fault));
  };
  std::string_view line;
  if (!lines.next(line)) throw fail("the file is empty; expected a line with the names of the columns");
  std::vector<std::string> names;
  for (const std::string_view name : split(line)) names.emplace_back(name);
  if (const auto fault = find_fault(names)) throw fail(*fault);

  Table table(std::move(names));
  std::vector<double> row(table.names().size());
  while (lines.next(line)) {
    const auto values = split(line);
    if (values.size() != row.size()) {
      throw fail(fmt::format("{} values, but the first line names {} columns", values.size(), row.size()));
    }
    for (std::size_t i = 0; i < row.size(); ++i) {
      const auto value = parse_finite(values[i]);
      if (!value) throw fail(fmt::format("column {}: '{}' is not a finite number", table.names()[i], values[i]));
      row[i] = *value;
    }
    table.append(row);
  }
  return table;
}

std::optional<std::string> compare(const Table& got, const Table& expected, const Tolerances& tolerances) {
  if (got.names() != expected.names()) {
    return fmt::format("columns: got {}, expected {}", fmt::join(got.names(), ","), fmt::join(expected.names(), ","));
  }
  if (got.rows() != expected.rows()) return fmt::format("rows: got {}, expected {}", got.rows(), expected.rows());
  for (std::size_t row = 0; row < got.rows(); ++row) {
    for (std::size_t i = 0; i < got.names().size(); ++i) {
      const auto own = tolerances.columns.find(got.names()[i]);
      const Tolerance within = own != tolerances.columns.end() ? own->second : tolerances.all;
      const double a = got.column(i)[row];
      const double b = expected.column(i)[row];
      const double allowed = within.absolute + within.relative * std::abs(b);
      if (std::abs(a - b) <= allowed) continue;
      return fmt::format("column {}, row {}: got {}, expected {}, off by {:.3g}, allowed {:.3g}", got.names()[i],
                         row + 1, a, b, std::abs(a - b), allowed);
    }
  }
  return std::nullopt;
}

}  // namespace strandyn::results
