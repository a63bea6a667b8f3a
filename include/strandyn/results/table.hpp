#pragma once
/// \file Named columns of numbers: written, read back, compared.
///
/// A column's name carries its unit (`friction_dissipation_J`). Columns have equal lengths. A CSV file has one header
/// line; numbers are written with the fewest digits that read back to the same bits.

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace strandyn::results {

class Table {
 public:
  /// Names must be unique, not empty, and free of commas, quotes and line breaks: std::invalid_argument otherwise.
  explicit Table(std::vector<std::string> names);

  /// One value per column, in the order of the names: std::invalid_argument otherwise.
  void append(std::span<const double> row);

  const std::vector<std::string>& names() const { return names_; }
  std::size_t rows() const { return columns_.empty() ? 0 : columns_.front().size(); }
  bool has(std::string_view name) const;
  /// std::out_of_range, naming the columns there are, where the name is unknown.
  const std::vector<double>& column(std::string_view name) const;
  const std::vector<double>& column(std::size_t index) const { return columns_.at(index); }

 private:
  std::vector<std::string> names_;
  std::vector<std::vector<double>> columns_;  ///< one vector per name
};

/// At most `most` indices of 0 ... count-1: the first, the last, and evenly spaced ones between.
std::vector<std::size_t> evenly_spaced(std::size_t count, std::size_t most);

/// Rows of a table by the values of some of its columns, in ascending order.
using Groups = std::map<std::vector<double>, std::vector<std::size_t>>;

Groups groups_of(const Table& table, const std::vector<std::string>& columns, const std::vector<std::size_t>& rows);

/// Replaces the file in one step: a reader sees the old table or the new one. A value that is not finite is refused,
/// with its column and row named, and the old file stays. Throws FileError.
void write_csv(const std::filesystem::path& path, const Table& table);

/// Blank lines are skipped, spaces around values ignored. Throws FileError where the file cannot be read, InputError
/// with the line number where its contents are no table of finite numbers.
Table read_csv(const std::filesystem::path& path);

/// How far a value may be from the expected one: |got - expected| <= absolute + relative |expected|.
struct Tolerance {
  double relative = 0;
  double absolute = 0;  ///< in the unit of the column
};

/// One tolerance for all columns, and others for those named.
struct Tolerances {
  Tolerance all = {};
  std::map<std::string, Tolerance, std::less<>> columns = {};
};

/// The first difference in words (names, then number of rows, then values row by row), or nothing.
std::optional<std::string> compare(const Table& got, const Table& expected, const Tolerances& tolerances = {});

}  // namespace strandyn::results
