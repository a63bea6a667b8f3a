#include "strandyn/study/verify.hpp"

#include <algorithm>
#include <mutex>
#include <optional>

#include "strandyn/casefile/read.hpp"
#include "strandyn/core/side_by_side.hpp"
#include "strandyn/study/run_case.hpp"

namespace strandyn::study {
namespace {

std::vector<std::filesystem::path> case_files(const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(folder)) {
    throw FileError(folder.string() + ": there is no such folder of cases; name one with --cases");
  }
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::filesystem::path name = entry.path().lexically_relative(folder);
    if (entry.path().extension() == ".toml" && *name.begin() != "refused") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string case_name(const std::filesystem::path& file, const std::filesystem::path& folder) {
  return file.lexically_relative(folder).replace_extension().string();
}

bool is_asked(const std::string& name, const std::vector<std::string>& names) {
  return names.empty() || std::any_of(names.begin(), names.end(),
                                      [&](const std::string& part) { return name.find(part) != std::string::npos; });
}

}  // namespace

bool VerifiedCase::passed() const {
  return error.empty() &&
         std::all_of(verdicts.begin(), verdicts.end(), [](const casefile::Verdict& v) { return v.passed; });
}

std::vector<VerifiedCase> verify_cases(const std::filesystem::path& folder, const std::vector<std::string>& names,
                                       const std::function<void(const std::string&)>& started) {
  std::vector<std::filesystem::path> files;
  for (const std::filesystem::path& file : case_files(folder)) {
    if (is_asked(case_name(file, folder), names)) files.push_back(file);
  }
  std::vector<std::optional<VerifiedCase>> all(files.size());
  std::mutex mutex;
  side_by_side(files.size(), [&](std::size_t i) {
    VerifiedCase verified{.name = case_name(files[i], folder), .title = {}, .verdicts = {}, .error = {}};
    try {
      const casefile::Scene scene = casefile::read_scene(files[i]);
      if (scene.accept.criteria.empty()) return;
      if (started) {
        const std::lock_guard lock(mutex);
        started(verified.name);
      }
      verified.title = scene.title;
      verified.verdicts = run_case(scene).verdicts;
    } catch (const std::runtime_error& error) {
      // Input, file and computation errors alike: the other cases still run.
      verified.error = error.what();
    }
    all[i] = std::move(verified);
  });
  std::vector<VerifiedCase> done;
  for (std::optional<VerifiedCase>& verified : all) {
    if (verified) done.push_back(std::move(*verified));
  }
  return done;
}

}  // namespace strandyn::study
