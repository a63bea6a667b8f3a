#include "checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "strandyn/casefile/echo.hpp"
#include "strandyn/core/archive.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/results/folder.hpp"
#include "strandyn/version.hpp"

namespace strandyn::study {

using json = nlohmann::ordered_json;

namespace {

/// Raise the version with every change of what is archived, wherever it is.
Seal checkpoint_seal() {
  static const std::string writer = fmt::format("strandyn {} ({})", program_version, program_revision);
  return {.kind = "checkpoint", .version = 2, .writer = writer};
}

/// The case without what does not touch its numbers.
json identity_of(const casefile::Scene& scene) {
  json identity = casefile::case_as_run(scene);
  identity.erase("title");
  identity.erase("accept");
  if (identity.contains("integrator")) identity["integrator"].erase("checkpoint_every_s");
  return identity;
}

/// The first key in which two cases differ, with both values.
std::string first_difference(const json& here, const json& there) {
  const json left = here.flatten();
  const json right = there.flatten();
  const auto value = [](const json& flat, const std::string& key) {
    return flat.contains(key) ? flat[key].dump() : std::string("not given");
  };
  for (const json* side : {&left, &right}) {
    for (const auto& [key, ignored] : side->items()) {
      if (value(left, key) == value(right, key)) continue;
      std::string path = key.substr(1);
      std::replace(path.begin(), path.end(), '/', '.');
      return fmt::format("{} is {} here and {} there", path, value(left, key), value(right, key));
    }
  }
  return "their keys stand in another order";
}

}  // namespace

CheckpointFile::CheckpointFile(const casefile::Scene& scene, const Hooks& hooks)
    : path_(hooks.folder / checkpoint_name), identity_(identity_of(scene).dump()) {
  if (hooks.folder.empty()) return;
  every_ = scene.integrator.checkpoint_every;
  if (!hooks.resume || !std::filesystem::exists(path_)) return;
  const std::string file = results::read_file(path_);
  std::string identity;
  try {
    Archive a(unseal(checkpoint_seal(), file));
    a(identity, resume_);
    a.finish();
  } catch (const FileError& error) {
    throw FileError(fmt::format("cannot resume from {}: {}; run without --resume", path_.string(), error.what()));
  }
  if (identity == identity_) return;
  throw InputError(fmt::format(
      "cannot resume from {}: it belongs to another case: {}; give the case as it was, or run without --resume",
      path_.string(), first_difference(json::parse(identity_), json::parse(identity))));
}

solver::Checkpoints CheckpointFile::checkpoints(std::function<bool()> interrupted) {
  solver::Checkpoints hooks{.resume = std::move(resume_)};
  if (!every_) return hooks;
  hooks.due = [this, stopped = std::move(interrupted)] { return is_due() || stopped(); };
  hooks.keep = [this](const std::string& state) { write(state); };
  return hooks;
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
