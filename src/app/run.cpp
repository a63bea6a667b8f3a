#include <fmt/format.h>

#include <iostream>

#include "interrupt.hpp"
#include "strandyn/casefile/read.hpp"
#include "strandyn/report/progress.hpp"
#include "strandyn/report/shown.hpp"
#include "strandyn/report/text_table.hpp"
#include "strandyn/results/folder.hpp"
#include "strandyn/results/json.hpp"
#include "strandyn/study/run_case.hpp"
#include "verbs.hpp"

namespace strandyn::app {
namespace {

void write_results(const std::filesystem::path& folder, const study::CaseResult& result) {
  for (const study::NamedTable& table : result.tables) results::write_csv(folder / table.file, table.table);
  results::write_json(folder / "summary.json", results::from_text(result.summary.dump(), ""));
}

std::string verdict_table(const std::vector<casefile::Verdict>& verdicts) {
  report::TextTable table(
      {{"accept", "", 4, report::Align::left}, {"found", ""}, {"wanted", ""}, {"", "", 4, report::Align::left}});
  for (const casefile::Verdict& v : verdicts)
    table.add_row({v.path, v.found, v.wanted, v.passed ? "passed" : "FAILED"});
  return table.str();
}

/// The energy of each cycle, where there are cycles.
std::string cycle_table(const std::vector<study::NamedTable>& tables) {
  const results::ShownTable shown{
      .title = "Energy of each cycle",
      .table = "cycles.csv",
      .columns = {"cycle", "t_s", "antinode_amplitude_m", "external_work_J", "viscous_dissipation_J",
                  "friction_dissipation_J", "numerical_dissipation_J", "elements_slipping"}};
  for (const study::NamedTable& table : tables) {
    if (table.file == shown.table) return report::text_of(shown, table.table);
  }
  return {};
}

/// The figures that a reader looks for first.
std::string headline(const nlohmann::ordered_json& s) {
  std::string text;
  if (s.contains("steady")) {
    const auto& steady = s["steady"];
    text += fmt::format(
        "last {} cycles at {:.4f} Hz: antinode amplitude {:.4g} mm, friction {:.4g} J per cycle, "
        "self-damping {:.4g} mW/m, damping ratio {:.4g}\n",
        steady["cycles"].get<int>(), steady["frequency_Hz"].get<double>(),
        1e3 * steady["antinode_amplitude_m"].get<double>(), steady["friction_dissipation_J"].get<double>(),
        1e3 * steady["self_damping_W_per_m"].get<double>(), steady["damping_ratio"].get<double>());
    text += steady.contains("numerical_share")
                ? fmt::format("numerical part {:.3g} J per cycle: {:.3g} % of what friction and viscous damping take\n",
                              steady["numerical_dissipation_J"].get<double>(),
                              100 * steady["numerical_share"].get<double>())
                : fmt::format("numerical part {:.3g} J per cycle; no friction or viscous damping\n",
                              steady["numerical_dissipation_J"].get<double>());
  }
  for (const auto& loop : s.value("loops", nlohmann::ordered_json::array())) {
    text += fmt::format("loop at {:.4g} kN, +-{:.4g} 1/m: area {:.6g} J/m, secant stiffness {:.6g} N m^2\n",
                        loop["tension_N"].get<double>() / 1e3, loop["curvature_per_m"].get<double>(),
                        loop["area_J_per_m"].get<double>(), loop["secant_stiffness_N_m2"].get<double>());
  }
  if (s.contains("frequencies_Hz")) {
    int number = 0;
    for (const auto& f : s["frequencies_Hz"]) text += fmt::format("mode {:2}: {:.5f} Hz\n", ++number, f.get<double>());
  }
  return text;
}

}  // namespace

ExitCode run(const RunArguments& arguments) {
  const casefile::Scene scene = casefile::read_scene(arguments.file, arguments.overrides);
  const std::filesystem::path folder =
      arguments.out.empty() ? std::filesystem::path("results") / arguments.file.stem() : arguments.out;
  results::create_folder(folder);
  watch_for_interrupt();

  report::Progress progress({.out = &std::cerr, .terminal = report::stderr_is_terminal(), .quiet = arguments.quiet});
  const study::Hooks hooks{.stop = interrupted,
                           .progress = [&](double part, std::string_view what) { progress.update(part, what); },
                           .announce =
                               [&](std::string_view what) {
                                 if (!arguments.quiet) fmt::print(stderr, "{}\n", what);
                               },
                           .folder = folder,
                           .resume = arguments.resume};
  const std::filesystem::path checkpoint = folder / study::checkpoint_name;
  if (arguments.resume && !arguments.quiet) {
    const bool there = std::filesystem::exists(checkpoint);
    fmt::print(stderr, "{} {}\n", there ? "resuming from" : "starting from the beginning: there is no",
               checkpoint.string());
  }
  const study::CaseResult result = study::run_case(scene, hooks);
  progress.finish();
  write_results(folder, result);
  std::error_code ignored;  // a checkpoint that stays does no harm
  if (!result.ended_early) std::filesystem::remove(checkpoint, ignored);

  if (!arguments.quiet) {
    if (const std::string cycles = cycle_table(result.tables); !cycles.empty()) fmt::print(stderr, "\n{}\n", cycles);
    fmt::print(stderr, "{}", headline(result.summary));
    for (const auto& warning : result.summary["warnings"]) {
      fmt::print(stderr, "warning: {}\n", warning.get<std::string>());
    }
    if (!result.verdicts.empty()) fmt::print(stderr, "\n{}", verdict_table(result.verdicts));
    fmt::print(stderr, "results in {}\n", folder.string());
  }
  if (!result.message.empty()) fmt::print(stderr, "strandyn: {}\n", result.message);
  if (arguments.json) fmt::print("{}\n", result.summary.dump(2));
  return result.exit_code;
}

}  // namespace strandyn::app
