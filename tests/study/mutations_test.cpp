// Shipped cases with keys changed at random: what `prepare` lets pass, no run refuses afterwards.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "strandyn/casefile/echo.hpp"
#include "strandyn/casefile/read.hpp"
#include "strandyn/casefile/schema.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/results/json.hpp"
#include "strandyn/study/run_case.hpp"

using namespace strandyn;
using nlohmann::ordered_json;

namespace {

std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text ? std::strtoull(text, nullptr, 10) : otherwise;
}

/// Shipped cases that run in the quick suite.
std::vector<std::filesystem::path> quick_cases() {
  std::vector<std::filesystem::path> files;
  const std::filesystem::path root = std::filesystem::path(STRANDYN_SOURCE_DIR) / "cases";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    if (entry.path().extension() != ".toml" || entry.path().parent_path().filename() == "refused") continue;
    std::ifstream stream(entry.path());
    std::string first;
    std::getline(stream, first);
    if (!first.starts_with("# label: ")) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

struct Leaf {
  std::string path;
  ordered_json value;
};

/// The keys of a case as run with their values.
void collect(const ordered_json& value, const std::string& path, std::vector<Leaf>& leaves) {
  if (value.is_object()) {
    for (const auto& [key, child] : value.items()) collect(child, path.empty() ? key : path + "." + key, leaves);
  } else if (value.is_array() && !value.empty() && value.front().is_object()) {
    for (std::size_t i = 0; i < value.size(); ++i) collect(value[i], path + "[" + std::to_string(i) + "]", leaves);
  } else {
    leaves.push_back({.path = path, .value = value});
  }
}

/// The words that the schema has for a key, wherever it stands; and the keys of each table.
struct Vocabulary {
  std::map<std::string, std::set<std::string>> words;
  std::map<std::string, std::vector<std::pair<std::string, ordered_json>>> keys;

  explicit Vocabulary(const ordered_json& schema) { add(schema, ""); }

 private:
  void add(const ordered_json& schema, const std::string& table) {
    if (schema.contains("items")) add(schema["items"], table);
    if (!schema.contains("properties")) return;
    for (const auto& [key, child] : schema["properties"].items()) {
      if (child.contains("enum")) {
        for (const auto& word : child["enum"]) {
          if (word.is_string()) words[key].insert(word.get<std::string>());
        }
      }
      if (child.contains("type")) keys[table].emplace_back(key, child);
      add(child, key);
    }
  }
};

class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : random_(seed), vocabulary_(ordered_json::parse(casefile::case_schema())) {}

  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }

  template <class List>
  auto one_of(const List& list) {
    auto it = list.begin();
    std::advance(it, static_cast<std::ptrdiff_t>(below(list.size())));
    return *it;
  }

  /// One override, as --set takes it.
  std::string change(const std::vector<Leaf>& leaves) {
    if (below(3) == 0) return addition();
    const Leaf leaf = one_of(leaves);
    return leaf.path + "=" + other(leaf.path, leaf.value);
  }

 private:
  /// A key that the table may have, whether or not it belongs to the case.
  std::string addition() {
    const std::string table = one_of(std::vector<std::string>{"span", "section", "integrator", "analysis", "static"});
    const auto& [key, schema] = one_of(vocabulary_.keys.at(table));
    const std::string path = table + "." + key;
    if (schema.contains("enum")) return path + "=" + ordered_json(one_of(vocabulary_.words.at(key))).dump();
    const std::string type = schema["type"].is_string() ? schema["type"].get<std::string>() : "number";
    if (type == "boolean") return path + (below(2) ? "=true" : "=false");
    if (type == "string") return path + "=\"mode 3\"";
    return path + "=" + one_of(std::vector<std::string>{"0", "1", "4", "12", "0.5", "-1", "[1, 2]"});
  }

  std::string other(const std::string& path, const ordered_json& value) {
    const std::string key = path.substr(path.rfind('.') + 1);
    if (vocabulary_.words.contains(key)) return ordered_json(one_of(vocabulary_.words.at(key))).dump();
    if (value.is_boolean()) return value.get<bool>() ? "false" : "true";
    if (value.is_number_integer()) {
      const auto n = value.get<long>();
      return std::to_string(one_of(std::vector<long>{0, -n, n + 1, n + 4, 2 * n, n / 2, 3, 1}));
    }
    if (value.is_number()) {
      const double x = value.get<double>();
      return ordered_json(one_of(std::vector<double>{0.0, -x, x * 1.5, x / 3, 10 * x, 0.1 * x, x + 1})).dump();
    }
    if (value.is_string()) return one_of(std::vector<std::string>{"\"mode 2\"", "\"mode 500\"", "\"other\"", "3"});
    return one_of(std::vector<std::string>{"[]", "[0]", "[1, 2, 3]", "[0, 0, 1]", "1"});
  }

  std::mt19937_64 random_;
  Vocabulary vocabulary_;
};

/// Meshes and sections that would only take time.
bool is_large(const casefile::Scene& scene) {
  return scene.section.points > 200 || (scene.span && scene.span->elements.value_or(0) > 200);
}

}  // namespace

TEST_CASE("mutations of shipped cases: whatever prepare lets pass is not refused by the run") {
  const std::uint64_t seed = from_environment("STRANDYN_SEED", std::random_device{}());
  const std::uint64_t wanted = from_environment("STRANDYN_MUTATIONS", 50);
  MESSAGE("STRANDYN_SEED=" << seed << " STRANDYN_MUTATIONS=" << wanted);
  Mutator mutator(seed);
  const std::vector<std::filesystem::path> files = quick_cases();
  std::uint64_t tried = 0;
  std::uint64_t refused = 0;
  while (tried < wanted) {
    const std::filesystem::path file = mutator.one_of(files);
    std::vector<Leaf> leaves;
    collect(ordered_json::parse(results::to_text(casefile::case_as_run(casefile::read_scene(file)))), "", leaves);
    std::erase_if(leaves, [](const Leaf& leaf) { return leaf.path.starts_with("accept") || leaf.path == "title"; });
    std::vector<std::string> overrides;
    std::string said = file.string();
    for (std::size_t i = 0; i <= mutator.below(2); ++i) {
      overrides.push_back(mutator.change(leaves));
      said += " --set '" + overrides.back() + "'";
    }
    CAPTURE(said);
    std::optional<casefile::Scene> scene;
    try {
      scene = casefile::read_scene(file, overrides);
      if (is_large(*scene)) continue;
      study::prepare(*scene);
    } catch (const InputError&) {
      ++refused;
      ++tried;
      continue;
    } catch (const FileError&) {  // it names a file that is not there
      ++refused;
      ++tried;
      continue;
    }
    ++tried;
    try {
      study::run_case(*scene, {.stop = [] { return true; }, .progress = {}});
    } catch (const ComputationError&) {  // does not converge: no fault of the input
    } catch (const InputError& error) {
      FAIL_CHECK("prepared, then refused: " << error.what());
    } catch (const FileError&) {  // nowhere to keep a checkpoint
    }
  }
  MESSAGE(refused << " of " << tried << " refused");
  CHECK(5 * refused >= 2 * wanted);
  CHECK(refused < wanted);
}
