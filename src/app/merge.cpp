#include <fmt/format.h>

#include "interrupt.hpp"
#include "strandyn/casefile/read.hpp"
#include "strandyn/results/folder.hpp"
#include "strandyn/study/run_case.hpp"
#include "strandyn/study/shard.hpp"
#include "streams.hpp"
#include "verbs.hpp"

namespace strandyn::app {

ExitCode merge(const MergeArguments& arguments) {
  const study::ShardSet set = study::read_shards(arguments.folders);
  const casefile::Scene scene = casefile::read_scene_text(set.source.text, set.source.file, set.source.overrides);
  for (const std::string& note : scene.notes) tell("note: {}\n", note);
  const auto analysis = study::prepare(scene);
  study::require_complete(*analysis, set);

  RunArguments run = arguments.run;
  run.file = set.source.file;
  const std::filesystem::path folder = run.out.empty() ? std::filesystem::path("results") / run.file.stem() : run.out;
  results::create_folder(folder);
  for (const study::ShardFolder& shard : set.shards) {
    if (!std::filesystem::equivalent(shard.folder, folder)) continue;
    throw InputError(fmt::format("{} is the folder of shard {}: give another one for the merged study with --out",
                                 folder.string(), shard.shard.words()));
  }
  watch_for_interrupt();
  std::filesystem::remove(folder / study::shard_name);
  analysis->pieces()->gather(set.shards, folder);
  return run_into(folder, scene, run, {.stop = {}, .progress = {}, .folder = folder, .resume = true, .merged = true});
}

}  // namespace strandyn::app
