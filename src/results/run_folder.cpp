#include "strandyn/results/run_folder.hpp"

#include <fmt/format.h>

#include <system_error>
#include <utility>

#include "strandyn/core/error.hpp"
#include "strandyn/results/folder.hpp"
#include "strandyn/results/json.hpp"

namespace strandyn::results {
namespace {

/// Hands out the members of the summary by name; what nobody asked for is the rest.
class Summary {
 public:
  explicit Summary(const std::filesystem::path& path) : path_(path) {
    try {
      all_ = from_text(read_file(path), path.string());
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}; {}", error.what(), remedy));
    }
    if (!all_.is_object()) throw broken("not a summary: expected a JSON object at the top");
  }

  Value take(std::string_view key) {
    taken_.emplace_back(key);
    const Value* found = all_.find(key);
    return found ? *found : Value();
  }
  std::string take_words(std::string_view key) {
    const Value value = take(key);
    return value.words() ? *value.words() : std::string();
  }
  Value take_object(std::string_view key) {
    Value value = take(key);
    return value.is_object() ? value : Value();
  }
  /// Records whose members `is_whole` finds sufficient.
  template <class R>
  std::vector<R> take_records(std::string_view key, bool (*is_whole)(const R&)) {
    std::vector<R> records;
    const Value list = take(key);
    if (!list.is_null() && !list.is_list()) throw broken(fmt::format("{} is {}, not a list", key, list.kind()));
    for (const Value& entry : list.entries()) {
      RecordReader::fill(records.emplace_back(), entry);
      if (!is_whole(records.back())) throw broken(fmt::format("{}[{}] is incomplete", key, records.size() - 1));
    }
    return records;
  }
  Value rest() const {
    Value rest = Value::object();
    for (const auto& [key, value] : all_.members()) {
      if (std::ranges::find(taken_, key) == taken_.end()) rest.set(key, value);
    }
    return rest;
  }

 private:
  static constexpr std::string_view remedy = "run the case again to write it anew";
  InputError broken(std::string_view fault) const {
    return InputError(fmt::format("{}: {}; {}", path_.string(), fault, remedy));
  }

  std::filesystem::path path_;
  Value all_;
  std::vector<std::string> taken_;
};

/// The value at a path of keys, or null.
const Value* at(const Value& value, std::initializer_list<std::string_view> path) {
  const Value* here = &value;
  for (const std::string_view key : path) {
    here = here->find(key);
    if (!here) return nullptr;
  }
  return here;
}

/// What every case says of itself.
std::vector<std::string> facts_of(const Value& the_case) {
  std::vector<std::string> facts;
  const auto add = [&](std::initializer_list<std::string_view> path, std::string_view before, std::string_view after) {
    const Value* value = at(the_case, path);
    if (!value) return;
    if (value->words()) facts.push_back(fmt::format("{}{}{}", before, *value->words(), after));
    if (const auto number = value->number()) facts.push_back(fmt::format("{}{}{}", before, *number, after));
  };
  add({"conductor", "catalogue"}, "conductor ", "");
  add({"span", "length_m"}, "", " m span");
  add({"span", "tension_kN"}, "", " kN");
  add({"span", "tension_rts"}, "", " of the rated strength");
  add({"section", "law"}, "section law ", "");
  return facts;
}

bool is_there(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::exists(path, ignored);
}

/// A name that stays in its folder.
bool is_plain(const std::string& name) {
  return !name.empty() && std::filesystem::path(name).filename() == name && name != "." && name != "..";
}

}  // namespace

const Table& RunFolder::table(const std::string& file) {
  if (const auto found = read_.find(file); found != read_.end()) return found->second;
  const auto full = path / file;
  if (!is_plain(file) || !is_there(full)) {
    throw InputError(fmt::format("there is no {}, which {} names; run the case again to write it anew", full.string(),
                                 (path / "summary.json").string()));
  }
  return read_.emplace(file, read_csv(full)).first->second;
}

RunFolder read_run_folder(const std::filesystem::path& path) {
  const auto file = path / "summary.json";
  if (!is_there(file)) {
    throw FileError(fmt::format("there is no {}: give the folder that `strandyn run` wrote", file.string()));
  }
  Summary summary(file);
  RunFolder run;
  run.path = path;
  run.title = summary.take_words("title");
  run.status = summary.take_words("status");
  run.message = summary.take_words("message");
  run.the_case = summary.take_object("case");
  run.section = summary.take_object("section");
  run.cost = summary.take_object("cost");
  run.program = summary.take_object("program");
  const Value* type = at(run.the_case, {"analysis", "type"});
  if (type && type->words()) run.analysis = *type->words();
  run.facts = facts_of(run.the_case);
  for (const auto& [key, sentences] : {std::pair{"findings", &run.findings}, std::pair{"warnings", &run.warnings}}) {
    const Value found = summary.take(key);
    for (const Value& sentence : found.entries()) {
      sentences->push_back(sentence.words() ? *sentence.words() : to_text(sentence, -1));
    }
  }
  run.highlights = summary.take_records<Highlight>(
      "highlights", [](const Highlight& h) { return !h.name.empty() && !h.path.empty(); });
  run.figures = summary.take_records<Figure>(
      "figures", [](const Figure& f) { return is_plain(f.name) && !f.table.empty() && !f.x.empty() && !f.y.empty(); });
  run.shown = summary.take_records<ShownTable>(
      "shown_tables", [](const ShownTable& t) { return !t.table.empty() && !t.columns.empty(); });
  run.rest = summary.rest();
  return run;
}

}  // namespace strandyn::results
