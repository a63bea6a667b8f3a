#pragma once
/// \file A moving chain as a file that ParaView and h5py read: VTKHDF 2.0, an unstructured grid of lines whose arrays
/// have a value at each of several times. The points stay where they are in the file; `displacement` moves them (Warp
/// By Vector).
///
/// Arrays grow by one block a moment, in compressed chunks; the file is whole after every `flush`, so that it can be
/// read while a run goes on, and after one that was killed. Format: VTK, "VTKHDF File Format", UnstructuredGrid and
/// Temporal Data.

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace strandyn::results {

/// One array of a moment.
struct FieldArray {
  std::string name;
  int components = 1;
  std::vector<double> values = {};  ///< point by point or cell by cell, components side by side
};

/// What a file holds at a time: the same arrays at every moment.
struct Moment {
  double time = 0;  ///< [s]
  std::vector<FieldArray> at_points, in_cells;
};

class VtkHdfFile {
 public:
  /// Whether the program was built with HDF5.
  static bool is_available();

  /// A new file of a chain of lines through these points [m], or one that is there and goes on after its first `kept`
  /// moments. Throws FileError where it cannot be written, or is not of this chain.
  VtkHdfFile(const std::filesystem::path& path, const std::vector<std::array<double, 3>>& points, std::size_t kept = 0);
  ~VtkHdfFile();

  void add(const Moment& moment);
  void flush();
  std::size_t moments() const;

 private:
  class File;
  std::unique_ptr<File> file_;
};

}  // namespace strandyn::results
