#include "checkpoint.hpp"

#include <fmt/format.h>

#include <sstream>

#include "flat_case.hpp"
#include "strandyn/casefile/echo.hpp"
#include "strandyn/core/archive.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/results/folder.hpp"
#include "strandyn/study/run_case.hpp"
#include "strandyn/version.hpp"

namespace strandyn::study {

namespace {

/// Raise the version with every change of what is archived, wherever it is.
Seal checkpoint_seal() {
  static const std::string writer = fmt::format("strandyn {} ({})", program_version, program_revision);
  return {.kind = "checkpoint", .version = 4, .writer = writer};
}

/// What a resumed run must have in common: all but what does not touch its numbers.
FlatCase identity_of(const casefile::Scene& scene) {
  FlatCase flat = flat_case(casefile::case_as_run(scene));
  std::erase_if(flat, [](const auto& entry) {
    const std::string& path = entry.first;
    return path == "title" || path.starts_with("accept") || path == "integrator.checkpoint_every_s";
  });
  return flat;
}

/// One line a key, and back.
std::string text_of(const FlatCase& flat) {
  std::string text;
  for (const auto& [path, value] : flat) text += path + '\t' + value + '\n';
  return text;
}
FlatCase flat_of(const std::string& text) {
  FlatCase flat;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t tab = line.find('\t');
    if (tab != std::string::npos) flat[line.substr(0, tab)] = line.substr(tab + 1);
  }
  return flat;
}

std::string words_of_difference(const FlatCase& here, const FlatCase& there) {
  const auto found = first_difference(here, there);
  if (!found) return "they were written by another program";
  return fmt::format("{} is {} here and {} there", found->key, found->first, found->second);
}

}  // namespace

CheckpointFile::CheckpointFile(const casefile::Scene& scene, const Hooks& hooks)
    : path_(hooks.folder / checkpoint_name), identity_(text_of(identity_of(scene))) {
  if (hooks.folder.empty()) return;
  every_ = scene.integrator.checkpoint_every;
  if (!hooks.resume || !std::filesystem::exists(path_)) return;
  const std::string file = results::read_file(path_);
  std::string identity;
  try {
    Archive a(unseal(checkpoint_seal(), file));
    a(identity, resume_);
    a.finish();
    resumes_ = !resume_.empty();
  } catch (const FileError& error) {
    throw FileError(fmt::format("cannot resume from {}: {}; run without --resume", path_.string(), error.what()));
  }
  if (identity == identity_) return;
  throw InputError(fmt::format(
      "cannot resume from {}: it belongs to another case: {}; give the case as it was, or run without --resume",
      path_.string(), words_of_difference(flat_of(identity_), flat_of(identity))));
}

solver::Checkpoints CheckpointFile::checkpoints(std::function<bool()> interrupted) {
  solver::Checkpoints hooks{.resume = std::move(resume_)};
  if (!every_) return hooks;
  hooks.due = [this, stopped = std::move(interrupted)] { return is_due() || stopped(); };
  hooks.keep = [this](const std::string& state) { write(state); };
  return hooks;
}

void CheckpointFile::refuse_state(const observe::CheckpointCheck& check, const std::string& why) const {
  if (!check.takes_up()) return;
  throw InputError(fmt::format(
      "cannot resume from {}: it is no state that this case can be in: {}; take it away, or run without --resume",
      path_.string(), why));
}

bool CheckpointFile::is_due() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - written_).count() >= *every_;
}

void CheckpointFile::write(const std::string& state) {
  Archive a;
  std::string content = state;
  a(identity_, content);
  results::write_file(path_, seal(checkpoint_seal(), a.bytes()));
  written_ = std::chrono::steady_clock::now();
}

}  // namespace strandyn::study
