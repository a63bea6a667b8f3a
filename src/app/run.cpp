#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <optional>

#include "interrupt.hpp"
#include "shipped.hpp"
#include "strandyn/report/format.hpp"
#include "strandyn/report/page.hpp"
#include "strandyn/report/progress.hpp"
#include "strandyn/report/shown.hpp"
#include "strandyn/report/text_table.hpp"
#include "strandyn/results/earlier_run.hpp"
#include "strandyn/results/folder.hpp"
#include "strandyn/results/json.hpp"
#include "strandyn/results/writing.hpp"
#include "strandyn/study/run_case.hpp"
#include "strandyn/study/shard.hpp"
#include "streams.hpp"
#include "verbs.hpp"

namespace strandyn::app {
namespace {

void write_results(const std::filesystem::path& folder, const std::vector<std::string>& earlier,
                   const study::CaseResult& result) {
  std::vector<std::string> written = result.written;
  for (const results::NamedTable& table : result.tables) {
    written.push_back(table.file);
    if (std::ranges::find(result.streamed, table.file) != result.streamed.end()) continue;
    results::write_csv(folder / table.file, table.table);
  }
  results::write_json(folder / "summary.json", result.summary);
  results::take_away(folder, earlier, written);
}

std::string verdict_table(const std::vector<casefile::Verdict>& verdicts) {
  report::TextTable table(
      {{"accept", "", 4, report::Align::left}, {"found", ""}, {"wanted", ""}, {"", "", 4, report::Align::left}});
  for (const casefile::Verdict& v : verdicts)
    table.add_row({v.path, v.found, v.wanted, v.passed ? "passed" : "FAILED"});
  return table.str();
}

/// Results go to standard output: tables, the numbers to look at first, verdicts.
void print_results(const study::CaseResult& result) {
  for (const results::ShownTable& shown : result.shown) {
    const auto table = std::ranges::find(result.tables, shown.table, &results::NamedTable::file);
    if (table == result.tables.end() || table->table.rows() == 0) continue;
    print("\n{}\n{}", shown.title, report::text_of(shown, table->table));
  }
  if (!result.highlights.empty()) print("\n{}", report::text_of(result.highlights));
  for (const std::string& finding : result.findings) print("\n{}\n", finding);
  if (!result.verdicts.empty()) print("\n{}", verdict_table(result.verdicts));
}

/// What is going to be said while it runs goes to standard error.
study::Hooks speaking(study::Hooks hooks, const RunArguments& arguments, report::Progress& progress) {
  hooks.stop = interrupted;
  hooks.progress = [&](double part, std::string_view what) { progress.update(part, what); };
  hooks.announce = [quiet = arguments.quiet](std::string_view what) {
    if (!quiet) tell("{}\n", what);
  };
  hooks.warn = [](std::string_view what) { tell("warning: {}\n", what); };
  return hooks;
}

/// Where the results are, what they took to write, and where a newcomer goes from here.
void tell_where(const std::filesystem::path& folder, bool has_page, double run_s) {
  const results::Written written = results::written_so_far();
  const double share = 100 * written.seconds / std::max({run_s, written.seconds, 1e-9});
  tell("results in {} ({} MB, {} % of the time to write)\n", folder.string(),
       report::significant(1e-6 * static_cast<double>(written.bytes), 2), report::significant(share, 2));
  if (has_page) {
    tell("  their page        {}\n", (folder / "report.html").string());
  } else {
    tell("  a page of them    strandyn report {}\n", folder.string());
  }
  const std::filesystem::path docs = shipped("docs", "share/doc/strandyn/docs");
  if (!std::filesystem::exists(docs / "outputs.md")) return;
  tell("  what is in them   {}\n  a first study     {}\n", (docs / "outputs.md").string(),
       (docs / "tutorial.md").string());
}

/// results/<case name>, the shard in it where there is one.
std::filesystem::path folder_of(const RunArguments& arguments, const std::optional<study::Shard>& shard) {
  if (!arguments.out.empty()) return arguments.out;
  std::string name = arguments.file.stem().string();
  if (shard) name += fmt::format(".shard-{}-of-{}", shard->number, shard->of);
  return std::filesystem::path("results") / name;
}

}  // namespace

ExitCode run(const RunArguments& arguments) {
  const casefile::Scene scene = read_noted(arguments.file, arguments.overrides);
  const auto analysis = study::prepare(scene);  // a case that cannot run leaves no folder
  std::optional<study::Shard> shard;
  if (!arguments.shard.empty()) {
    shard = study::parse_shard(arguments.shard);
    study::require_shards(scene, *analysis, *shard);
  }
  const std::filesystem::path folder = folder_of(arguments, shard);
  if (shard && arguments.resume) study::require_own_folder(folder, *shard);
  results::create_folder(folder);
  if (shard) {
    const study::CaseText source{
        .file = arguments.file.string(), .text = results::read_file(arguments.file), .overrides = arguments.overrides};
    study::note_shard(folder, *shard, source, *analysis);
  } else {
    std::filesystem::remove(folder / study::shard_name);  // what comes is the whole
  }
  if (arguments.resume && !arguments.quiet) {
    const std::filesystem::path kept = folder / study::resumes_from(scene);
    const bool there = std::filesystem::exists(kept);
    tell("{} {}\n", there ? "resuming from" : "starting from the beginning: there is no", kept.string());
  }
  return run_into(folder, scene, arguments,
                  {.stop = {}, .progress = {}, .folder = folder, .resume = arguments.resume, .shard = shard});
}

ExitCode run_into(const std::filesystem::path& folder, const casefile::Scene& scene, const RunArguments& arguments,
                  const study::Hooks& how) {
  const std::vector<std::string> earlier = results::files_of_earlier_run(folder);
  watch_for_interrupt();
  report::Progress progress({.out = &std::cerr, .terminal = report::stderr_is_terminal(), .quiet = arguments.quiet});
  const study::CaseResult result = study::run_case(scene, speaking(how, arguments, progress));
  progress.finish();
  write_results(folder, earlier, result);
  std::error_code ignored;  // a checkpoint that stays does no harm
  if (!result.ended_early) std::filesystem::remove(folder / study::checkpoint_name, ignored);
  if (arguments.report) report::write_report(folder);

  std::optional<FileError> unprinted;  // where standard output fails, the rest is still said
  try {
    if (!arguments.quiet && !arguments.json) print_results(result);
    if (arguments.json) print_raw(results::to_text(result.summary) + '\n');
  } catch (const FileError& error) {
    unprinted = error;
  }
  if (!arguments.quiet) {
    for (const std::string& warning : result.warnings) tell("warning: {}\n", warning);
    tell_where(folder, arguments.report, result.cost.wall_s);
  }
  if (!result.message.empty()) tell("strandyn: {}\n", result.message);
  if (unprinted) throw *unprinted;
  return result.exit_code;
}

}  // namespace strandyn::app
