// A folder of results, by those who read one: the page, and the next run that takes it away.
#include <fmt/format.h>

#include "answer.hpp"
#include "results/scratch_folder.hpp"
#include "results/small_run.hpp"
#include "strandyn/report/page.hpp"
#include "strandyn/results/earlier_run.hpp"
#include "target.hpp"

namespace strandyn::fuzz {
namespace {

constexpr std::size_t tables = 2;   // a.csv and b.csv
constexpr char separator = '\x1e';  // between summary.json and the tables

std::string name_of(std::size_t i) {
  return i == 0 ? "summary.json" : i == 1 ? "a.csv" : "b.csv";
}

}  // namespace

void take(std::string_view bytes) {
  static const test::ScratchFolder scratch;
  std::error_code ignored;
  for (std::size_t i = 0; i <= tables; ++i) {
    const std::size_t end = bytes.find(separator);
    put((scratch / name_of(i)).string(), bytes.substr(0, end));
    bytes.remove_prefix(end == std::string_view::npos ? bytes.size() : end + 1);
  }
  answered([&] { report::write_report(scratch.path()); });
  answered([&] { results::take_away(scratch.path(), results::files_of_earlier_run(scratch.path()), {}); });
  for (const auto& entry : std::filesystem::directory_iterator(scratch.path())) {
    std::filesystem::remove(entry.path(), ignored);
  }
}

std::vector<std::string> seeds() {
  const results::Table numbers = test::table_of_rows({"cycle", "t_s", "friction_J", "tension_N"},
                                                     {{1, 0.1, 1e-3, 10}, {2, 0.2, 2e-3, 10}, {3, 0.3, 5e-3, 20}});
  std::vector<std::string> all;
  for (const char* kind : {"line", "band", "map", "section", "motion"}) {
    for (const char* scale : {"linear", "log"}) {
      results::Figure figure{
          .name = "energy", .title = "Energy per cycle", .table = "a.csv", .x = "cycle", .y = {"friction_J"}};
      figure.kind = kind;
      figure.x_scale = figure.y_scale = scale;
      if (figure.kind == "band" || figure.kind == "map") figure.y.emplace_back("t_s");
      if (figure.kind == "line" || figure.kind == "band") figure.series = {"tension_N"};
      figure.caption = "What a cycle <takes>.";
      const test::SmallRun run{.highlights = {{.name = "friction", .path = "steady.friction_J", .value = 5e-3}},
                               .figures = {figure},
                               .shown = {{.title = "Cycles", .table = "b.csv", .columns = {"cycle", "friction_J"}}}};
      const test::ScratchFolder folder;
      results::write_csv(folder / "a.csv", numbers);
      std::string text = results::to_text(run.summary());
      for (int i = 0; i < 2; ++i) text += separator + bytes_of((folder / "a.csv").string());
      all.push_back(text);
    }
  }
  return all;
}

}  // namespace strandyn::fuzz
