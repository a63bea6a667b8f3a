// The command line: finds the verb, turns what went wrong into a message and an exit code.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <filesystem>
#include <functional>
#include <new>
#include <optional>
#include <sstream>
#include <string>

#include "completion.hpp"
#include "slips.hpp"
#include "strandyn/version.hpp"
#include "streams.hpp"
#include "verbs.hpp"

namespace {

using strandyn::ExitCode;
namespace app = strandyn::app;

/// A message a line: a case file may have several.
int report_error(ExitCode code, const char* text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) app::tell("strandyn: {}\n", line);
  return static_cast<int>(code);
}

/// What the program's own help, or a slip on the command line, has to say.
int answer(const CLI::App& program, const CLI::ParseError& error) {
  std::ostringstream out, words;
  const int code = program.exit(error, out, words);
  app::tell("{}", words.str());
  app::print_raw(out.str());
  return code == 0 ? 0 : static_cast<int>(ExitCode::wrong_input);
}

/// Adds the arguments that every verb on a case takes.
CLI::App* add_case_verb(CLI::App& program, const char* name, const char* help, app::RunArguments& arguments) {
  CLI::App* verb = program.add_subcommand(name, help);
  verb->add_option("CASE", arguments.file, "case file (TOML)")->required();
  verb->add_option("--set", arguments.overrides, "override one key of the case: KEY.PATH=VALUE; may be repeated")
      ->expected(1)
      ->take_all();
  return verb;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program{"Vibration of stranded overhead conductors in time, and the energy they lose per cycle.",
                   "strandyn"};
  program.set_version_flag("--version", fmt::format("strandyn {} ({}, {})", strandyn::program_version,
                                                    strandyn::program_revision, strandyn::program_compiler));
  program.require_subcommand(1);

  app::RunArguments arguments;
  std::string name, shell;
  std::filesystem::path folder, wires;
  bool of_results = false, of_keys = false;
  std::function<ExitCode()> verb;

  CLI::App* run = add_case_verb(program, "run", "run a case and write its results", arguments);
  run->add_option("--out", arguments.out, "results folder (default: results/<case name>)");
  run->add_flag("--json", arguments.json, "print summary.json to standard output");
  run->add_flag("--quiet", arguments.quiet, "no progress and no tables");
  run->add_flag("--resume", arguments.resume,
                "go on from what the results folder has: finished points of a study, or the checkpoint of [integrator] "
                "checkpoint_every_s");
  run->add_option(
      "--shard", arguments.shard,
      "compute one part of a study, I/N (2/3: the second of three), in a folder of its own; `merge` puts the "
      "parts together");
  run->add_flag("--report", arguments.report, "make the page report.html, too");
  run->callback([&] { verb = [&] { return app::run(arguments); }; });

  app::MergeArguments merging;
  CLI::App* merge = program.add_subcommand("merge", "put the shards of a study together");
  merge->add_option("DIR", merging.folders, "the folders that `run --shard` wrote, all of one study")->required();
  merge->add_option("--out", merging.run.out, "results folder (default: results/<case name>)");
  merge->add_flag("--json", merging.run.json, "print summary.json to standard output");
  merge->add_flag("--quiet", merging.run.quiet, "no progress and no tables");
  merge->add_flag("--report", merging.run.report, "make the page report.html, too");
  merge->callback([&] { verb = [&] { return app::merge(merging); }; });

  CLI::App* check = add_case_verb(program, "check", "read and validate a case, run nothing", arguments);
  check->add_option("--shard", arguments.shard, "whether the case can be run in this part, I/N");
  check->callback([&] { verb = [&] { return app::check(arguments); }; });
  CLI::App* describe = add_case_verb(
      program, "describe", "the resolved case in SI units, what will be modelled, the expected cost", arguments);
  describe->add_flag("--json", arguments.json, "print JSON instead of words");
  describe->callback([&] { verb = [&] { return app::describe(arguments); }; });

  app::VerifyArguments verification;
  CLI::App* verify = program.add_subcommand("verify", "run the cases that carry an [accept] table, side by side");
  verify->add_option("NAME", verification.names,
                     "parts of case names (default: all); `extremes` and parts of its rows' names: hard cases with "
                     "the bounds that physics sets them");
  verify->add_option("--cases", verification.folder, "folder of the cases (default: ./cases)");
  verify->add_flag("--json", verification.json, "print JSON");
  verify->add_flag("--markdown", verification.markdown,
                   "print the tables in Markdown (docs/validation.md, docs/extremes.md)");
  verify->callback([&] { verb = [&] { return app::verify(verification); }; });

  CLI::App* conductors = program.add_subcommand("conductors", "the catalogue of conductors");
  CLI::Option* one = conductors->add_option("NAME", name, "one conductor, as a table to paste into a case");
  conductors->add_option("--import", wires, "a CSV file of wires per layer, as a table to paste into a case")
      ->excludes(one);
  conductors->callback(
      [&] { verb = [&] { return wires.empty() ? app::conductors(name) : app::import_conductor(wires); }; });

  CLI::App* schema = program.add_subcommand("schema", "JSON Schema of a case file, for editors");
  CLI::Option* for_results =
      schema->add_flag("--results", of_results, "what the members of summary.json mean instead, in Markdown");
  schema->add_flag("--keys", of_keys, "the keys as a page to read, in Markdown")->excludes(for_results);
  schema->callback([&] {
    verb = [&] {
      return app::schema(of_results ? app::SchemaForm::results
                         : of_keys  ? app::SchemaForm::keys
                                    : app::SchemaForm::json);
    };
  });

  CLI::App* complete =
      program.add_subcommand("completion", "a script that completes verbs, options and conductors in a shell");
  complete->add_option("SHELL", shell, "bash, zsh or fish")->required();
  complete->callback([&] {
    verb = [&] {
      app::print_raw(app::completion(program, shell));
      return ExitCode::done;
    };
  });
  program.add_subcommand("man", "the page of the manual, for man -l")->callback([&] {
    verb = [&] {
      app::print_raw(app::manual(program, std::string(strandyn::program_version)));
      return ExitCode::done;
    };
  });

  CLI::App* report = program.add_subcommand("report", "turn a results folder into one HTML page and its plots");
  report->add_option("DIR", folder, "results folder")->required();
  report->callback([&] { verb = [&] { return app::report(folder); }; });

  app::guard_streams();
  try {
    try {
      program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      const auto slip = error.get_exit_code() == 0 ? std::nullopt : app::find_slip(program, argc, argv);
      return slip ? report_error(ExitCode::wrong_input, slip->c_str()) : answer(program, error);
    }
    return static_cast<int>(verb());
  } catch (const strandyn::InputError& error) {
    return report_error(ExitCode::wrong_input, error.what());
  } catch (const strandyn::FileError& error) {
    return report_error(ExitCode::no_file, error.what());
  } catch (const strandyn::ComputationError& error) {
    return report_error(ExitCode::not_converged, error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    return report_error(ExitCode::no_file, error.what());
  } catch (const std::bad_alloc&) {
    return report_error(ExitCode::not_converged,
                        "there is not enough memory for this; ask for fewer elements or points");
  } catch (const std::exception& error) {
    return report_error(ExitCode::not_converged, fmt::format("unexpected failure: {}", error.what()).c_str());
  }
}
