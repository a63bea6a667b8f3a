#include "strandyn/study/shard.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "entries.hpp"
#include "flat_case.hpp"
#include "strandyn/casefile/echo.hpp"
#include "strandyn/casefile/read.hpp"
#include "strandyn/results/folder.hpp"
#include "strandyn/results/json.hpp"

namespace strandyn::study {

using results::Value;

namespace {

/// The file shard.json.
struct Note {
  std::size_t number = 0, of = 0;
  std::string program{}, study{}, file{}, text{};
  std::vector<std::string> overrides{};
};
template <class V>
void members(V& v, Note& n) {
  v.value("shard", n.number, {.what = "the number of the shard, from 1"});
  v.value("of", n.of, {.what = "how many there are"});
  v.value("program", n.program, {.what = "that computes it, with its vector target"});
  v.value("study", n.study, {.what = "what the numbers of its points depend on, in brief"});
  v.value("case_file", n.file, {.what = "the file of the case"});
  v.value("case_text", n.text, {.what = "what stood in it"});
  v.value("overrides", n.overrides, {.what = "the arguments of --set"});
}

/// strandyn 0.1.0 (revision, compiler), AVX2: no other one promises the same bits.
std::string program_words() {
  const Value program = program_of_summaries();
  const auto word = [&](const char* key) { return *program.find(key)->words(); };
  return fmt::format("{} {} ({}, {}), {}", word("name"), word("version"), word("revision"), word("compiler"),
                     word("simd"));
}

Note read_note(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / shard_name;
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) {
    throw InputError(
        fmt::format("{}: there is no {} in it; give the folders that `strandyn run CASE --shard I/N` wrote",
                    folder.string(), shard_name));
  }
  Note note;
  const Value value = results::from_text(results::read_file(file), file.string());
  const bool whole = results::RecordReader::fill(note, value) == 0 && note.number > 0 && note.number <= note.of;
  if (whole) return note;
  throw InputError(fmt::format("{}: is not as a shard leaves it; run the shard again", file.string()));
}

casefile::Scene scene_of(const CaseText& source) {
  return casefile::read_scene_text(source.text, source.file, source.overrides);
}

CaseText source_of(const Note& note) {
  return {.file = note.file, .text = note.text, .overrides = note.overrides};
}

/// Throws where the two are no shards of one study.
void require_same_study(const Note& first, const std::filesystem::path& first_folder, const Note& note,
                        const std::filesystem::path& folder) {
  if (note.text != first.text || note.overrides != first.overrides) {
    const auto as_run = [](const Note& n) { return flat_case(casefile::case_as_run(scene_of(source_of(n)))); };
    if (const auto difference = first_difference(as_run(first), as_run(note))) {
      throw InputError(
          fmt::format("{} and {} are shards of different cases: {} is {} in the one and {} in the other; merge the "
                      "shards of one case",
                      first_folder.string(), folder.string(), difference->key, difference->first, difference->second));
    }
  }
  if (note.study != first.study) {
    throw InputError(
        fmt::format("{} and {} were computed from different files beside the same case; run one of them again",
                    first_folder.string(), folder.string()));
  }
  if (note.of != first.of) {
    throw InputError(
        fmt::format("{} is shard {} of {} and {} is shard {} of {}: their shares overlap; merge shards of "
                    "one division",
                    first_folder.string(), first.number, first.of, folder.string(), note.number, note.of));
  }
}

/// 2, 4-7, 9: places counted from 1; of a long list its beginning.
std::string numbers_of(const std::vector<std::size_t>& places) {
  constexpr std::size_t most = 12;
  std::vector<std::string> words;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::size_t first = i;
    while (i + 1 < places.size() && places[i + 1] == places[i] + 1) ++i;
    if (words.size() == most) {
      words.emplace_back("...");
      break;
    }
    words.push_back(first == i ? fmt::format("{}", places[i] + 1)
                               : fmt::format("{}-{}", places[first] + 1, places[i] + 1));
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

/// What to do instead of asking for shards.
std::string instead_of_shards(const casefile::Scene& scene) {
  if (scene.is<casefile::SweepAnalysis>()) {
    return "each point of a sweep begins at the one before it; run it without --shard, or ask for the points in a "
           "self-damping study by the method \"periodic\"";
  }
  const bool in_time = scene.is<casefile::DecayAnalysis>() || scene.is<casefile::ForcedAnalysis>() ||
                       scene.is<casefile::TransientAnalysis>();
  if (in_time) {
    return "each step follows from the one before it; run it without --shard ([integrator] checkpoint_every_s and "
           "--resume let it go on), or vary its keys in a tradeoff, whose settings can be divided";
  }
  return "it is one computation; run it without --shard, or vary its keys in a tradeoff, whose settings can be divided";
}

}  // namespace

void require_shards(const casefile::Scene& scene, const Analysis& analysis, const Shard& shard) {
  const Pieces* pieces = analysis.pieces();
  if (!pieces) {
    throw InputError(fmt::format("--shard {}: the analysis \"{}\" is no study of independent points: {}", shard.words(),
                                 casefile::word_of(scene.analysis), instead_of_shards(scene)));
  }
  if (shard.of > pieces->count()) {
    throw InputError(fmt::format("--shard {}: the study has {} {}{}; give no more shards than that", shard.words(),
                                 pieces->count(), pieces->noun(), pieces->count() == 1 ? "" : "s"));
  }
}

void require_own_folder(const std::filesystem::path& folder, const Shard& shard) {
  std::error_code ignored;
  if (!std::filesystem::exists(folder / shard_name, ignored)) return;
  const Note note = read_note(folder);
  if (note.number == shard.number && note.of == shard.of) return;
  throw InputError(
      fmt::format("cannot resume shard {} in {}: it is the folder of shard {}/{}; give each shard a folder "
                  "of its own with --out, or run without --resume",
                  shard.words(), folder.string(), note.number, note.of));
}

void note_shard(const std::filesystem::path& folder, const Shard& shard, const CaseText& source,
                const Analysis& analysis) {
  const Note note{.number = shard.number,
                  .of = shard.of,
                  .program = program_words(),
                  .study = analysis.pieces()->identity(),
                  .file = source.file,
                  .text = source.text,
                  .overrides = source.overrides};
  results::write_json(folder / shard_name, results::to_value(note));
}

ShardSet read_shards(const std::vector<std::filesystem::path>& folders) {
  std::vector<Note> notes;
  for (const std::filesystem::path& folder : folders) notes.push_back(read_note(folder));
  ShardSet set{
      .source = source_of(notes.front()), .identity = notes.front().study, .shards = {}, .of = notes.front().of};
  std::map<std::size_t, std::filesystem::path> by_number;
  for (std::size_t i = 0; i < folders.size(); ++i) {
    const Note& note = notes[i];
    if (note.program != program_words()) {
      throw InputError(
          fmt::format("{} was computed by {}, and this is {}: merge with the program and on the kind of "
                      "machine that computed the shards, or run the shard again with this one",
                      folders[i].string(), note.program, program_words()));
    }
    require_same_study(notes.front(), folders.front(), note, folders[i]);
    const auto [place, is_new] = by_number.emplace(note.number, folders[i]);
    if (is_new) continue;
    throw InputError(fmt::format("{} and {} are both shard {}/{}: their shares overlap; give one of them",
                                 place->second.string(), folders[i].string(), note.number, note.of));
  }
  for (const auto& [number, folder] : by_number) {
    set.shards.push_back({.shard = {.number = number, .of = set.of}, .folder = folder});
  }
  return set;
}

void require_complete(const Analysis& analysis, const ShardSet& set) {
  // No shard notes these, whatever stands in the file.
  if (!analysis.pieces() || set.of > analysis.pieces()->count()) {
    throw InputError(fmt::format("{}: is not as a shard leaves it: its case cannot be divided so; run the shard again",
                                 (set.shards.front().folder / shard_name).string()));
  }
  const Pieces& pieces = *analysis.pieces();
  if (pieces.identity() != set.identity) {
    throw InputError(
        fmt::format("the shards of {} were computed from other files beside the case than lie there now; "
                    "put these back, or run the shards again",
                    set.source.file));
  }
  std::vector<std::string> faults;
  for (std::size_t number = 1; number <= set.of; ++number) {
    const Shard shard{.number = number, .of = set.of};
    const auto given = std::ranges::find(set.shards, shard, &ShardFolder::shard);
    if (given == set.shards.end()) {
      const std::vector<std::size_t> share = pieces.share(shard);
      if (share.empty()) continue;
      faults.push_back(fmt::format("shard {} is not given: {}s {}; run it with --shard {} and give its folder, too",
                                   shard.words(), pieces.noun(), numbers_of(share), shard.words()));
      continue;
    }
    const Pieces::Found found = pieces.look(*given);
    if (found.missing.empty()) continue;
    faults.push_back(fmt::format("shard {} ({}) lacks {} of its {} {}s: {}{}; go on with --shard {} --resume --out {}",
                                 shard.words(), given->folder.string(), found.missing.size(),
                                 pieces.share(shard).size(), pieces.noun(), numbers_of(found.missing),
                                 found.fault.empty() ? "" : fmt::format(" ({})", found.fault), shard.words(),
                                 given->folder.string()));
  }
  if (faults.empty()) return;
  throw InputError(fmt::format("the study is not complete:\n  {}", fmt::join(faults, "\n  ")));
}

}  // namespace strandyn::study
