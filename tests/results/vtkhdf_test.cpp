#include "strandyn/results/vtkhdf.hpp"

#include <doctest/doctest.h>

#include "results/scratch_folder.hpp"
#include "strandyn/core/error.hpp"

#ifdef STRANDYN_HDF5
#include <hdf5.h>

using namespace strandyn;
using results::Moment;
using results::VtkHdfFile;

namespace {

const std::vector<std::array<double, 3>> points = {{0, 0, 0}, {1, 0, 0}, {2.5, 0, 0}};

Moment moment(int number) {
  const double t = number;
  return {.time = 0.1 * t,
          .at_points = {{.name = "displacement", .components = 3, .values = {0, 0, 0, 0, t, 0.5, 0, -t, 1e-300}}},
          .in_cells = {{.name = "tension", .values = {1000 + t, 2000 + t}}}};
}

/// Every number of a data set, of a file that somebody else may have open.
template <class T>
std::vector<T> read(const std::filesystem::path& path, const char* name, hid_t type) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  REQUIRE(file >= 0);
  const hid_t set = H5Dopen2(file, name, H5P_DEFAULT);
  REQUIRE(set >= 0);
  const hid_t space = H5Dget_space(set);
  std::vector<T> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  CHECK(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0);
  H5Sclose(space);
  H5Dclose(set);
  H5Fclose(file);
  return values;
}
std::vector<double> numbers(const std::filesystem::path& path, const char* name) {
  return read<double>(path, name, H5T_NATIVE_DOUBLE);
}
std::vector<long long> counts(const std::filesystem::path& path, const char* name) {
  return read<long long>(path, name, H5T_NATIVE_LLONG);
}

}  // namespace

TEST_CASE("fields: a file holds its grid, and every moment at its offset") {
  const test::ScratchFolder folder;
  const auto path = folder / "fields.vtkhdf";
  {
    VtkHdfFile file(path, points);
    for (int i = 0; i < 4; ++i) file.add(moment(i));
    file.flush();
    CHECK(file.moments() == 4);
  }
  CHECK(numbers(path, "/VTKHDF/Points") == std::vector<double>{0, 0, 0, 1, 0, 0, 2.5, 0, 0});
  CHECK(counts(path, "/VTKHDF/Connectivity") == std::vector<long long>{0, 1, 1, 2});
  CHECK(counts(path, "/VTKHDF/Offsets") == std::vector<long long>{0, 2, 4});
  CHECK(read<unsigned char>(path, "/VTKHDF/Types", H5T_NATIVE_UCHAR) == std::vector<unsigned char>{3, 3});
  CHECK(counts(path, "/VTKHDF/NumberOfCells") == std::vector<long long>{2});
  CHECK(numbers(path, "/VTKHDF/Steps/Values") == std::vector<double>{0, 0.1, 0.2, 0.1 * 3});
  CHECK(counts(path, "/VTKHDF/Steps/NumberOfParts") == std::vector<long long>{1, 1, 1, 1});
  CHECK(counts(path, "/VTKHDF/Steps/CellOffsets") == std::vector<long long>{0, 0, 0, 0});
  CHECK(counts(path, "/VTKHDF/Steps/PointDataOffsets/displacement") == std::vector<long long>{0, 3, 6, 9});
  CHECK(counts(path, "/VTKHDF/Steps/CellDataOffsets/tension") == std::vector<long long>{0, 2, 4, 6});
  const std::vector<double> u = numbers(path, "/VTKHDF/PointData/displacement");
  REQUIRE(u.size() == 36);
  CHECK(std::vector<double>(u.begin() + 27, u.end()) == moment(3).at_points[0].values);
  CHECK(numbers(path, "/VTKHDF/CellData/tension") ==
        std::vector<double>{1000, 2000, 1001, 2001, 1002, 2002, 1003, 2003});
}

TEST_CASE("fields: a file goes on after the moments that are kept, as if it had never stopped") {
  const test::ScratchFolder folder;
  const auto whole = folder / "whole.vtkhdf", parted = folder / "parted.vtkhdf";
  {
    VtkHdfFile file(whole, points);
    for (int i = 0; i < 6; ++i) file.add(moment(i));
    file.flush();
  }
  {
    VtkHdfFile file(parted, points);
    for (int i = 0; i < 5; ++i) file.add(moment(i));
    file.flush();
  }
  {
    VtkHdfFile file(parted, points, 3);
    CHECK(file.moments() == 3);
    for (int i = 3; i < 6; ++i) file.add(moment(i));
    file.flush();
  }
  for (const char* name : {"/VTKHDF/Steps/Values", "/VTKHDF/PointData/displacement", "/VTKHDF/CellData/tension"}) {
    CHECK(numbers(whole, name) == numbers(parted, name));
  }
  for (const char* name : {"/VTKHDF/Steps/PointDataOffsets/displacement", "/VTKHDF/Steps/PointOffsets"}) {
    CHECK(counts(whole, name) == counts(parted, name));
  }
  CHECK_THROWS_WITH_AS(VtkHdfFile(parted, points, 7), doctest::Contains("without --resume"), FileError);
  CHECK_THROWS_AS(VtkHdfFile(folder / "nowhere/x.vtkhdf", points), FileError);
}

#endif
