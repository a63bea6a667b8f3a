#pragma once
/// \file What `strandyn run` left in a folder, read back for whoever shows it. The only place that looks up the parts
/// of summary.json by their names.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "strandyn/results/figure.hpp"
#include "strandyn/results/table.hpp"
#include "strandyn/results/value.hpp"

namespace strandyn::results {

class RunFolder {
 public:
  std::filesystem::path path;
  std::string title;               ///< empty where there is none, as the other words
  std::string status;              ///< "done"
  std::string message;             ///< why it ended, where it ended early
  std::string analysis;            ///< its type: "forced"
  std::vector<std::string> facts;  ///< of the case, in words: "conductor curlew", "30 m span"
  std::vector<std::string> findings, warnings;
  std::vector<Highlight> highlights;
  std::vector<Figure> figures;
  std::vector<ShownTable> shown;
  Value the_case;  ///< this and the next three: an object, or nothing
  Value section;
  Value cost;
  Value program;
  Value rest = Value::object();  ///< whatever else the summary has

  /// A CSV file that a figure or a shown table names, read at first use. Throws InputError where it is not there or is
  /// no table.
  const Table& table(const std::string& file);

 private:
  std::map<std::string, Table> read_ = {};
};

/// Throws FileError where there is no summary.json, InputError where it is broken or has a figure, a number or a table
/// to be shown that is incomplete. Other parts that are of an unexpected kind are left empty.
RunFolder read_run_folder(const std::filesystem::path& path);

}  // namespace strandyn::results
