// What a shard notes of itself, as `merge` reads it: beside a note that is whole, up to the list of what is missing.
#include "answer.hpp"
#include "results/scratch_folder.hpp"
#include "strandyn/casefile/read.hpp"
#include "strandyn/study/shard.hpp"
#include "target.hpp"

namespace strandyn::fuzz {
namespace {

constexpr const char* study_text = R"([conductor]
catalogue = "drake"
[section]
law = "return-map"
points = 12
[analysis]
type = "self-damping"
method = "foti-2018"
frequencies_Hz = [10, 20]
amplitude_over_diameter = [0.02, 0.05]
tensions_rts = 0.2
)";

/// The note of a shard of three, in this folder.
void write_note(const std::filesystem::path& folder, std::size_t number, const std::vector<std::string>& overrides) {
  const casefile::Scene scene = casefile::read_scene_text(study_text, "case.toml", overrides);
  study::note_shard(folder, {.number = number, .of = 3},
                    {.file = "case.toml", .text = study_text, .overrides = overrides}, *study::prepare(scene));
}

}  // namespace

void take(std::string_view bytes) {
  static const test::ScratchFolder found, whole;
  static const bool written = (write_note(whole.path(), 2, {}), true);
  if (!written) return;
  put((found / study::shard_name).string(), bytes);
  for (const auto& folders : {std::vector{found.path(), whole.path()}, {whole.path(), found.path()}, {found.path()}}) {
    answered([&] {
      const study::ShardSet set = study::read_shards(folders);
      const casefile::Scene scene = casefile::read_scene_text(set.source.text, set.source.file, set.source.overrides);
      study::require_complete(*study::prepare(scene), set);
    });
  }
}

std::vector<std::string> seeds() {
  std::vector<std::string> files;
  for (const std::vector<std::string>& overrides :
       {std::vector<std::string>{}, {"conductor.friction=0.4"}, {"title=x", "analysis.frequencies_Hz=[10]"}}) {
    const test::ScratchFolder folder;
    write_note(folder.path(), 1, overrides);
    files.push_back(bytes_of((folder / study::shard_name).string()));
  }
  return files;
}

}  // namespace strandyn::fuzz
