#include "verbs.hpp"

#include <fmt/format.h>

#include "strandyn/casefile/import_wires.hpp"
#include "strandyn/casefile/read.hpp"
#include "strandyn/casefile/schema.hpp"
#include "strandyn/conductor/catalogue.hpp"
#include "strandyn/conductor/constants.hpp"
#include "strandyn/report/outline.hpp"
#include "strandyn/report/page.hpp"
#include "strandyn/report/text_table.hpp"
#include "strandyn/results/json.hpp"
#include "strandyn/study/reference.hpp"
#include "strandyn/study/run_case.hpp"
#include "strandyn/study/shard.hpp"
#include "streams.hpp"

namespace strandyn::app {
namespace {

/// The smallest case that brings a conductor through the reader; `name` is a text of TOML.
casefile::Scene scene_of(std::string_view name) {
  const std::string text = fmt::format("[conductor]\ncatalogue = {}\n[analysis]\ntype = \"axial-torsion\"\n", name);
  return casefile::read_scene_text(text, "the catalogue");
}
/// Of a word of the shell, which may hold anything.
std::string as_toml(std::string_view word) {
  return results::to_text(results::Value(harmless(word)), -1);
}

/// What a run would say at its end.
void warn(const casefile::Scene& scene) {
  for (const std::string& warning : scene.warnings) tell("warning: {}\n", warning);
}

}  // namespace

casefile::Scene read_noted(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  casefile::Scene scene = casefile::read_scene(file, overrides);
  for (const std::string& note : scene.notes) tell("note: {}\n", note);
  return scene;
}

ExitCode check(const RunArguments& arguments) {
  const casefile::Scene scene = read_noted(arguments.file, arguments.overrides);
  const auto analysis = study::prepare(scene);
  if (!arguments.shard.empty()) study::require_shards(scene, *analysis, study::parse_shard(arguments.shard));
  warn(scene);
  print("{}: in order ({}, {} analysis)\n", arguments.file.string(), scene.title, casefile::word_of(scene.analysis));
  return ExitCode::done;
}

ExitCode describe(const RunArguments& arguments) {
  const casefile::Scene scene = read_noted(arguments.file, arguments.overrides);
  const results::Value told = study::describe_case(scene);
  warn(scene);
  if (arguments.json) {
    print_raw(results::to_text(told) + '\n');
  } else {
    print("{}\n", report::text_of(told));
  }
  return ExitCode::done;
}

ExitCode conductors(const std::string& name) {
  if (!name.empty()) {
    scene_of(as_toml(name));  // refuses an unknown name and says which is near
    print("{}", conductor::case_table(*conductor::find_entry(name)));
    return ExitCode::done;
  }
  using report::Align;
  report::TextTable table({{"name", "", 4, Align::left},
                           {"wires"},
                           {"diameter", "mm", 4},
                           {"mass", "kg/m", 4},
                           {"strength", "kN", 4},
                           {"EA", "MN", 4},
                           {"EI min", "N m^2", 4},
                           {"EI max", "N m^2", 5}});
  for (const conductor::CatalogueEntry& entry : conductor::catalogue()) {
    const conductor::Strand strand = scene_of(as_toml(entry.name)).conductor->strand;
    const conductor::SectionConstants c = conductor::section_constants(strand);
    int wires = 0;
    for (const conductor::Layer& layer : strand.layers) wires += layer.wires;
    table.add_row({std::string(entry.name), wires, 1e3 * strand.outer_diameter(), strand.mass_per_length,
                   strand.rated_strength / 1e3, c.EA / 1e6, c.EI_min, c.EI_max});
  }
  print("{}", table.str());
  return ExitCode::done;
}

ExitCode import_conductor(const std::filesystem::path& csv) {
  print("{}", casefile::import_wires(csv));
  return ExitCode::done;
}

ExitCode schema(SchemaForm form) {
  print_raw(form == SchemaForm::results ? study::outputs_reference()
            : form == SchemaForm::keys  ? casefile::key_reference()
                                        : casefile::case_schema() + "\n");
  return ExitCode::done;
}

ExitCode report(const std::filesystem::path& folder) {
  print("{}\n", report::write_report(folder).string());
  return ExitCode::done;
}

}  // namespace strandyn::app
