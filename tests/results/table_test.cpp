#include "strandyn/results/table.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include "results/scratch_folder.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/results/folder.hpp"

using strandyn::FileError;
using strandyn::InputError;
using strandyn::results::compare;
using strandyn::results::evenly_spaced;
using strandyn::results::groups_of;
using strandyn::results::read_csv;
using strandyn::results::Table;
using strandyn::results::write_csv;
using strandyn::results::write_file;
using strandyn::test::message_of;
using strandyn::test::ScratchFolder;

namespace {

Table two_rows() {
  Table table({"t_s", "friction_dissipation_J"});
  table.append(std::vector{0.1, 2.5e-7});
  table.append(std::vector{0.2, 3.0});
  return table;
}

}  // namespace

TEST_CASE("table: a file read back has the same bits, for any finite double") {
  const ScratchFolder folder;
  Table table({"x_m", "y_m"});
  std::mt19937_64 random(7);
  std::vector<double> values = {0.0,
                                -0.0,
                                0.1,
                                1.0 / 3.0,
                                std::numeric_limits<double>::max(),
                                std::numeric_limits<double>::lowest(),
                                std::numeric_limits<double>::min(),
                                std::numeric_limits<double>::denorm_min(),
                                9007199254740993.0,
                                -5e-324};
  while (values.size() < 2000) {
    const auto value = std::bit_cast<double>(random());
    if (std::isfinite(value)) values.push_back(value);
  }
  for (std::size_t i = 0; i + 1 < values.size(); i += 2) table.append(std::vector{values[i], values[i + 1]});
  write_csv(folder / "a.csv", table);
  const Table back = read_csv(folder / "a.csv");
  REQUIRE(back.rows() == table.rows());
  CHECK(back.names() == table.names());
  int differing = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
      const auto bits = [row, i](const Table& t) { return std::bit_cast<std::uint64_t>(t.column(i)[row]); };
      differing += bits(back) != bits(table);
    }
  }
  CHECK(differing == 0);
}

TEST_CASE("table: the file has one header line and the shortest digits") {
  const ScratchFolder folder;
  write_csv(folder / "a.csv", two_rows());
  CHECK(strandyn::results::read_file(folder / "a.csv") == "t_s,friction_dissipation_J\n0.1,2.5e-07\n0.2,3\n");
  CHECK(folder.entries() == 1);  // the temporary file is gone
}

TEST_CASE("table: a value that is not finite is refused with its column and row, and the old file stays") {
  const ScratchFolder folder;
  write_csv(folder / "a.csv", two_rows());
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    Table table = two_rows();
    table.append(std::vector{0.3, bad});
    const auto message = message_of<FileError>([&] { write_csv(folder / "a.csv", table); });
    CHECK(message == "refused to write " + (folder / "a.csv").string() +
                         ": column friction_dissipation_J, row 3 is not a finite number");
  }
  CHECK_FALSE(compare(read_csv(folder / "a.csv"), two_rows()).has_value());
}

TEST_CASE("table: names are unique and plain, rows are as wide as the names") {
  CHECK_THROWS_AS(Table({}), std::invalid_argument);
  CHECK_THROWS_AS(Table({"a_m", ""}), std::invalid_argument);
  CHECK_THROWS_AS(Table({"a_m", "a_m"}), std::invalid_argument);
  CHECK_THROWS_AS(Table({"a,b"}), std::invalid_argument);
  Table table = two_rows();
  CHECK_THROWS_AS(table.append(std::vector{1.0}), std::invalid_argument);
  CHECK(table.rows() == 2);
}

TEST_CASE("table: a column is found by name, a missing one is named beside those there are") {
  const Table table = two_rows();
  CHECK(table.has("t_s"));
  CHECK_FALSE(table.has("x_m"));
  CHECK(table.column("t_s") == std::vector{0.1, 0.2});
  CHECK(message_of<std::out_of_range>([&] { table.column("x_m"); }) ==
        "there is no column 'x_m', only t_s, friction_dissipation_J");
}

TEST_CASE("table: reading forgives blanks, blank lines, carriage returns and a byte order mark") {
  const ScratchFolder folder;
  write_file(folder / "a.csv", "\xEF\xBB\xBF t_s , friction_dissipation_J\r\n\r\n 0.1,\t2.5e-07 \r\n0.2,3");
  CHECK_FALSE(compare(read_csv(folder / "a.csv"), two_rows()).has_value());
}

TEST_CASE("table: a broken file is an input error that quotes its line") {
  const ScratchFolder folder;
  const auto path = folder / "a.csv";
  const auto message = [&](std::string_view content) {
    write_file(path, content);
    return message_of<InputError>([&] { read_csv(path); });
  };
  const std::string at = path.string() + ", line ";
  CHECK(message("") == at + "1: the file is empty; expected a line with the names of the columns");
  CHECK(message("a_m,b_m\n1,2\n\n3\n") == at + "4: 1 values, but the first line names 2 columns");
  CHECK(message("a_m,b_m\n1,2,3\n") == at + "2: 3 values, but the first line names 2 columns");
  CHECK(message("a_m,b_m\n1,two\n") == at + "2: column b_m: 'two' is not a finite number");
  CHECK(message("a_m,b_m\n1,\n") == at + "2: column b_m: '' is not a finite number");
  CHECK(message("a_m,b_m\n1,2.5x\n") == at + "2: column b_m: '2.5x' is not a finite number");
  CHECK(message("a_m,b_m\nnan,2\n") == at + "2: column a_m: 'nan' is not a finite number");
  CHECK(message("a_m,b_m\n1,1e999\n") == at + "2: column b_m: '1e999' is not a finite number");
  CHECK(message("a_m,a_m\n1,2\n") == at + "1: there are two columns 'a_m'");
  CHECK(message("a_m,\n1,2\n") == at + "1: column 2 has no name");
}

TEST_CASE("table: a file that is not there is a file error with path and cause") {
  const ScratchFolder folder;
  const auto path = folder / "none.csv";
  CHECK(message_of<FileError>([&] { read_csv(path); }) ==
        "cannot read " + path.string() + ": No such file or directory");
  CHECK(message_of<FileError>([&] { read_csv(folder.path()); }) ==
        "cannot read " + folder.path().string() + ": Is a directory");
}

TEST_CASE("table: comparison finds the first difference and says how far it is") {
  const Table expected = two_rows();
  CHECK_FALSE(compare(two_rows(), expected).has_value());

  Table other({"t_s", "friction_dissipation_J"});
  other.append(std::vector{0.1, 2.5e-7});
  CHECK(compare(other, expected) == "rows: got 1, expected 2");
  other.append(std::vector{0.2, 3.03});
  CHECK(compare(other, expected) ==
        "column friction_dissipation_J, row 2: got 3.03, expected 3, off by 0.03, allowed 0");

  CHECK_FALSE(compare(other, expected, {.all = {.relative = 0.0101}}).has_value());
  CHECK(compare(other, expected, {.all = {.relative = 0.0099}}).has_value());
  CHECK_FALSE(compare(other, expected, {.columns = {{"friction_dissipation_J", {.absolute = 0.0301}}}}).has_value());
  CHECK(compare(other, expected, {.columns = {{"t_s", {.absolute = 1}}}}).has_value());

  CHECK(compare(Table({"t_s"}), Table({"x_m"})) == "columns: got t_s, expected x_m");
}

TEST_CASE("table: comparison never takes a NaN for equal") {
  Table table({"a_m"});
  table.append(std::vector{std::nan("")});
  CHECK(compare(table, table, {.all = {.absolute = 1e300}}).has_value());
}

TEST_CASE("table: of many rows the first, the last and evenly spaced ones are chosen") {
  CHECK(evenly_spaced(3, 20) == std::vector<std::size_t>{0, 1, 2});
  CHECK(evenly_spaced(100, 1) == std::vector<std::size_t>{99});
  CHECK(evenly_spaced(0, 20).empty());
  const auto chosen = evenly_spaced(1000, 20);
  REQUIRE(chosen.size() == 20);
  CHECK(chosen.front() == 0);
  CHECK(chosen.back() == 999);
  for (std::size_t i = 1; i < chosen.size(); ++i) {
    CHECK(chosen[i] - chosen[i - 1] >= 52);  // 999/19 = 52.6
    CHECK(chosen[i] - chosen[i - 1] <= 53);
  }
}

TEST_CASE("table: rows fall into groups by their values, in ascending order, and keep their own order") {
  Table table({"a", "b"});
  for (const auto& row : {std::vector{2.0, 1.0}, {1.0, 5.0}, {2.0, 0.0}, {1.0, 5.0}}) table.append(row);
  const auto groups = groups_of(table, {"a"}, {0, 1, 2, 3});
  REQUIRE(groups.size() == 2);
  CHECK(groups.at({1}) == std::vector<std::size_t>{1, 3});
  CHECK(groups.at({2}) == std::vector<std::size_t>{0, 2});
  CHECK(groups_of(table, {"a", "b"}, {0, 1, 2}).begin()->first == std::vector{1.0, 5.0});
  CHECK(groups_of(table, {}, {0, 1}).size() == 1);
}
