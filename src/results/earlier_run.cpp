#include "strandyn/results/earlier_run.hpp"

#include <algorithm>

#include "strandyn/results/figure.hpp"
#include "strandyn/results/folder.hpp"
#include "strandyn/results/json.hpp"

namespace strandyn::results {

namespace {

struct Left {
  std::vector<std::string> files{};
  std::vector<Figure> figures{};
};
template <class V>
void members(V& v, Left& l) {
  v.value("files", l.files, {.what = "the tables of the run"});
  v.list("figures", l.figures, {.what = "its figures"});
}

}  // namespace

std::vector<std::string> files_of_earlier_run(const std::filesystem::path& folder) {
  const std::filesystem::path summary = folder / "summary.json";
  std::error_code error;
  if (!std::filesystem::exists(summary, error)) return {};
  Left left;
  if (const auto value = from_line(read_file(summary))) RecordReader::fill(left, *value);
  std::vector<std::string> files = left.files;
  for (const Figure& figure : left.figures) files.push_back(figure.name + ".svg");
  files.emplace_back("report.html");
  // A name that climbs out of the folder is none of a run.
  std::erase_if(files, [](const std::string& file) { return file.empty() || file.find('/') != std::string::npos; });
  return files;
}

void take_away(const std::filesystem::path& folder, const std::vector<std::string>& earlier,
               const std::vector<std::string>& written) {
  for (const std::string& file : earlier) {
    if (std::ranges::find(written, file) != written.end()) continue;
    std::error_code ignored;  // what is gone already does no harm
    std::filesystem::remove(folder / file, ignored);
  }
}

}  // namespace strandyn::results
