#include "strandyn/results/vtkhdf.hpp"

#include <fmt/format.h>

#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "strandyn/core/error.hpp"

#ifdef STRANDYN_HDF5
#include <hdf5.h>
#endif

namespace strandyn::results {

#ifdef STRANDYN_HDF5

namespace {

/// An identifier of HDF5, closed when it goes.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle(hid_t id, Close close, const char* what) : id_(id), close_(close) {
    if (id < 0) throw FileError(fmt::format("HDF5 fails: {}", what));
  }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  Handle& operator=(Handle&&) = delete;
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  Close close_;
};

void check(herr_t status, const char* what) {
  if (status < 0) throw FileError(fmt::format("HDF5 fails: {}", what));
}

Handle space_of(const std::vector<hsize_t>& size, bool grows) {
  std::vector<hsize_t> most = size;
  if (grows) most[0] = H5S_UNLIMITED;
  return {H5Screate_simple(static_cast<int>(size.size()), size.data(), most.data()), H5Sclose, "a data space"};
}

void set_attribute(hid_t at, const char* name, const std::vector<long long>& values) {
  const Handle space =
      values.size() == 1 ? Handle(H5Screate(H5S_SCALAR), H5Sclose, "a data space") : space_of({values.size()}, false);
  const Handle attribute(H5Acreate2(at, name, H5T_NATIVE_LLONG, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, name);
  check(H5Awrite(attribute, H5T_NATIVE_LLONG, values.data()), name);
}

void set_attribute(hid_t at, const char* name, const std::string& words) {
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, name);
  check(H5Tset_size(type, words.size()), name);
  check(H5Tset_strpad(type, H5T_STR_NULLPAD), name);
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, name);
  const Handle attribute(H5Acreate2(at, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, name);
  check(H5Awrite(attribute, type, words.data()), name);
}

template <class T>
hid_t type_of() {
  if constexpr (std::is_same_v<T, double>) return H5T_NATIVE_DOUBLE;
  if constexpr (std::is_same_v<T, long long>) return H5T_NATIVE_LLONG;
  return H5T_NATIVE_UCHAR;
}

/// Rows that stay as they are.
template <class T>
void write_fixed(hid_t at, const char* name, const std::vector<T>& values, hsize_t columns = 1) {
  const std::vector<hsize_t> size =
      columns == 1 ? std::vector<hsize_t>{values.size()} : std::vector<hsize_t>{values.size() / columns, columns};
  const Handle space = space_of(size, false);
  const Handle set(H5Dcreate2(at, name, type_of<T>(), space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose, name);
  check(H5Dwrite(set, type_of<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), name);
}

/// Rows to which others are added; `chunk` rows lie together.
template <class T>
class Growing {
 public:
  Growing(hid_t at, const std::string& name, hsize_t columns, bool has_columns, hsize_t chunk)
      : name_(name), set_(open(at, name, columns, has_columns, chunk)), has_columns_(has_columns), columns_(columns) {}

  void resize(hsize_t rows) {
    rows_ = rows;
    const hsize_t size[] = {rows, columns_};
    check(H5Dset_extent(set_, size), name_.c_str());
  }
  hsize_t rows() const { return rows_; }
  void append(const std::vector<T>& values) {
    const hsize_t from[] = {rows_, 0}, count[] = {values.size() / columns_, columns_};
    resize(rows_ + count[0]);
    const Handle file_space(H5Dget_space(set_), H5Sclose, name_.c_str());
    check(H5Sselect_hyperslab(file_space, H5S_SELECT_SET, from, nullptr, count, nullptr), name_.c_str());
    const Handle memory = has_columns_ ? space_of({count[0], columns_}, false) : space_of({count[0]}, false);
    check(H5Dwrite(set_, type_of<T>(), memory, file_space, H5P_DEFAULT, values.data()), name_.c_str());
  }

 private:
  static Handle open(hid_t at, const std::string& name, hsize_t columns, bool has_columns, hsize_t chunk) {
    if (H5Lexists(at, name.c_str(), H5P_DEFAULT) > 0) {
      return {H5Dopen2(at, name.c_str(), H5P_DEFAULT), H5Dclose, name.c_str()};
    }
    const Handle space = has_columns ? space_of({0, columns}, true) : space_of({0}, true);
    const Handle how(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, name.c_str());
    const hsize_t block[] = {std::max<hsize_t>(chunk, 1), columns};
    check(H5Pset_chunk(how, has_columns ? 2 : 1, block), name.c_str());
    check(H5Pset_shuffle(how), name.c_str());
    check(H5Pset_deflate(how, 4), name.c_str());
    return {H5Dcreate2(at, name.c_str(), type_of<T>(), space, H5P_DEFAULT, how, H5P_DEFAULT), H5Dclose, name.c_str()};
  }

  std::string name_;
  Handle set_;
  bool has_columns_;
  hsize_t columns_, rows_ = 0;
};

constexpr hsize_t moments_together = 256;  // of what is one number a moment

}  // namespace

class VtkHdfFile::File {
 public:
  File(const std::filesystem::path& path, const std::vector<std::array<double, 3>>& points, std::size_t kept)
      : points_(points.size()),
        file_(quietly(path, kept)),
        root_(kept == 0 ? make(points) : Handle(H5Gopen2(file_, "VTKHDF", H5P_DEFAULT), H5Gclose, "the group VTKHDF")),
        steps_(group(root_, "Steps")),
        of_points_(group(steps_, "PointDataOffsets")),
        of_cells_(group(steps_, "CellDataOffsets")),
        point_data_(group(root_, "PointData")),
        cell_data_(group(root_, "CellData")),
        values_(steps_, "Values", 1, false, moments_together) {
    if (kept == 0) set_attribute(steps_, "NSteps", std::vector<long long>{0});
    for (const char* name : {"PartOffsets", "NumberOfParts", "PointOffsets"}) {
      numbers_.emplace(name, Growing<long long>(steps_, name, 1, false, moments_together));
    }
    for (const char* name : {"CellOffsets", "ConnectivityIdOffsets"}) {
      numbers_.emplace(name, Growing<long long>(steps_, name, 1, true, moments_together));
    }
    if (kept == 0) return;
    if (told_count() < static_cast<long long>(kept)) {
      throw FileError(
          fmt::format("{} holds fewer moments than the run has written; run without --resume", path.string()));
    }
    count_ = kept;
    values_.resize(kept);
    for (auto& [name, set] : numbers_) set.resize(kept);
    tell_count();
  }

  void add(const Moment& moment) {
    for (const FieldArray& array : moment.at_points) add(array, point_data_, of_points_, points_);
    for (const FieldArray& array : moment.in_cells) add(array, cell_data_, of_cells_, points_ - 1);
    values_.append({moment.time});
    for (auto& [name, set] : numbers_) set.append({name == "NumberOfParts" ? 1 : 0});
    ++count_;
  }

  void flush() {
    tell_count();
    check(H5Fflush(file_, H5F_SCOPE_GLOBAL), "writing to disk");
  }
  std::size_t count() const { return count_; }

 private:
  /// What HDF5 has to say on a failure is said here.
  static Handle quietly(const std::filesystem::path& path, std::size_t kept) {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    const hid_t id = kept == 0 ? H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)
                               : H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    if (id < 0) {
      throw FileError(fmt::format("cannot {} {}; run without --resume, or in a folder that can be written",
                                  kept == 0 ? "write" : "go on with", path.string()));
    }
    return {id, H5Fclose, "the file"};
  }

  Handle make(const std::vector<std::array<double, 3>>& points) {
    Handle root(H5Gcreate2(file_, "VTKHDF", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, "the group VTKHDF");
    set_attribute(root, "Version", std::vector<long long>{2, 0});
    set_attribute(root, "Type", std::string("UnstructuredGrid"));
    const std::size_t lines = points.size() - 1;
    std::vector<double> places;
    for (const auto& point : points) places.insert(places.end(), point.begin(), point.end());
    write_fixed(root, "Points", places, 3);
    const auto number = [](std::size_t n) { return static_cast<long long>(n); };
    write_fixed<long long>(root, "NumberOfPoints", {number(points.size())});
    write_fixed<long long>(root, "NumberOfCells", {number(lines)});
    write_fixed<long long>(root, "NumberOfConnectivityIds", {number(2 * lines)});
    std::vector<long long> ends, offsets = {0};
    for (std::size_t line = 0; line < lines; ++line) {
      ends.insert(ends.end(), {number(line), number(line + 1)});
      offsets.push_back(number(2 * line + 2));
    }
    write_fixed(root, "Connectivity", ends);
    write_fixed(root, "Offsets", offsets);
    constexpr unsigned char is_a_line = 3;
    write_fixed(root, "Types", std::vector<unsigned char>(lines, is_a_line));
    return root;
  }

  static Handle group(hid_t at, const char* name) {
    if (H5Lexists(at, name, H5P_DEFAULT) > 0) return {H5Gopen2(at, name, H5P_DEFAULT), H5Gclose, name};
    return {H5Gcreate2(at, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, name};
  }

  void add(const FieldArray& array, hid_t data, hid_t offsets, std::size_t entries) {
    const auto components = static_cast<hsize_t>(array.components);
    if (array.values.size() != entries * components) throw std::invalid_argument("a field of another chain");
    const std::string key = fmt::format("{}/{}", data == point_data_ ? "point" : "cell", array.name);
    if (!fields_.contains(key)) {
      fields_.emplace(key, Growing<double>(data, array.name, components, components > 1, entries));
      offsets_.emplace(key, Growing<long long>(offsets, array.name, 1, false, moments_together));
      fields_.at(key).resize(count_ * entries);
      offsets_.at(key).resize(count_);
    }
    Growing<double>& field = fields_.at(key);
    offsets_.at(key).append({static_cast<long long>(field.rows())});
    field.append(array.values);
  }

  long long told_count() const {
    const Handle attribute(H5Aopen(steps_, "NSteps", H5P_DEFAULT), H5Aclose, "NSteps");
    long long count = 0;
    check(H5Aread(attribute, H5T_NATIVE_LLONG, &count), "NSteps");
    return count;
  }
  void tell_count() {
    const Handle attribute(H5Aopen(steps_, "NSteps", H5P_DEFAULT), H5Aclose, "NSteps");
    const auto count = static_cast<long long>(count_);
    check(H5Awrite(attribute, H5T_NATIVE_LLONG, &count), "NSteps");
  }

  std::size_t points_, count_ = 0;
  Handle file_, root_, steps_, of_points_, of_cells_, point_data_, cell_data_;
  Growing<double> values_;
  std::map<std::string, Growing<long long>> numbers_, offsets_;
  std::map<std::string, Growing<double>> fields_;
};

bool VtkHdfFile::is_available() {
  return true;
}

VtkHdfFile::VtkHdfFile(const std::filesystem::path& path, const std::vector<std::array<double, 3>>& points,
                       std::size_t kept)
    : file_(std::make_unique<File>(path, points, kept)) {}

void VtkHdfFile::add(const Moment& moment) {
  file_->add(moment);
}
void VtkHdfFile::flush() {
  file_->flush();
}
std::size_t VtkHdfFile::moments() const {
  return file_->count();
}

#else

class VtkHdfFile::File {};

bool VtkHdfFile::is_available() {
  return false;
}
VtkHdfFile::VtkHdfFile(const std::filesystem::path&, const std::vector<std::array<double, 3>>&, std::size_t) {
  throw FileError("this program was built without HDF5");
}
void VtkHdfFile::add(const Moment&) {}
void VtkHdfFile::flush() {}
std::size_t VtkHdfFile::moments() const {
  return 0;
}

#endif

VtkHdfFile::~VtkHdfFile() = default;

}  // namespace strandyn::results
