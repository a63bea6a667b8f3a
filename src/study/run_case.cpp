#include "strandyn/study/run_case.hpp"

#include <fmt/format.h>

#include <chrono>
#include <ctime>

#include "entries.hpp"
#include "strandyn/build/section_law.hpp"
#include "strandyn/casefile/echo.hpp"
#include "strandyn/section/return_map.hpp"
#include "strandyn/self_damping/log.hpp"
#include "strandyn/version.hpp"

namespace strandyn::study {

using results::Value;

namespace {

struct Program {
  std::string name = "strandyn", version = program_version, revision = program_revision, compiler = program_compiler;
  std::string simd = section::vector_target().name;
  std::size_t simd_doubles = static_cast<std::size_t>(section::vector_target().lanes);
};
template <class V>
void members(V& v, Program& p) {
  v.value("name", p.name, {.what = "strandyn"});
  v.value("version", p.version, {.what = "its version"});
  v.value("revision", p.revision, {.what = "of its source"});
  v.value("compiler", p.compiler, {.what = "that built it"});
  v.value("simd", p.simd, {.what = "instruction set of the section kernels"});
  v.value("simd_doubles", p.simd_doubles, {.what = "doubles in a register"});
}

struct VerdictRow {
  std::string path, found, wanted;
  bool passed = false;
  std::string reason;
  std::optional<std::string> source{};
};
template <class V>
void members(V& v, VerdictRow& r) {
  v.value("path", r.path, {.what = "into this summary"});
  v.value("found", r.found, {.what = "what stands there"});
  v.value("wanted", r.wanted, {.what = "what the case expects"});
  v.value("passed", r.passed, {.what = "whether it holds"});
  v.value("reason", r.reason, {.what = "why it must hold"});
  v.value("source", r.source, {.what = "where the expected value comes from"});
}

std::vector<VerdictRow> rows_of(const std::vector<casefile::Verdict>& verdicts) {
  std::vector<VerdictRow> rows;
  for (const casefile::Verdict& v : verdicts) {
    rows.push_back({.path = v.path, .found = v.found, .wanted = v.wanted, .passed = v.passed, .reason = v.reason});
    if (!v.source.empty()) rows.back().source = v.source;
  }
  return rows;
}

/// Is the case run as it was written? What [accept] promises holds for that; an override of [accept] itself is meant.
bool acceptance_applies(const casefile::Scene& scene) {
  bool changed = false;
  for (const auto& [path, entry] : scene.source.entries) {
    if (!entry.overridden) continue;
    if (path.starts_with("accept")) return true;
    changed = true;
  }
  return !changed;
}

void judge_acceptance(const casefile::Scene& scene, CaseResult& result) {
  result.verdicts = casefile::judge(scene.accept, result.summary, static_cast<int>(result.exit_code));
  std::size_t failed = 0;
  for (const casefile::Verdict& verdict : result.verdicts) failed += verdict.passed ? 0 : 1;
  if (failed == 0 || result.exit_code != ExitCode::done) return;
  if (!acceptance_applies(scene)) {
    result.warnings.push_back(
        fmt::format("{} of the case's {} [accept] entries fail; they speak of the case without --set and do not decide "
                    "the exit code",
                    failed, result.verdicts.size()));
    return;
  }
  result.exit_code = ExitCode::not_converged;
  result.message = fmt::format("{} of the case's {} [accept] entries failed", failed, result.verdicts.size());
}

const char* status_word(ExitCode code) {
  if (code == ExitCode::done) return "done";
  return code == ExitCode::interrupted ? "interrupted" : "failed";
}

/// Which part of a study a summary is of.
struct ShardRow {
  std::size_t number = 0, of = 0, all = 0;
  std::vector<std::size_t> own{};
};
template <class V>
void members(V& v, ShardRow& r) {
  v.value("number", r.number, {.what = "of the shard, from 1"});
  v.value("of", r.of, {.what = "how many shards there are"});
  v.value("points_of_study", r.all, {.what = "how many points, or settings, the study has in all"});
  v.value("own", r.own, {.what = "the numbers of those that are the shard's, from 1"});
}

ShardRow row_of(const Shard& shard, const Pieces& pieces) {
  ShardRow row{.number = shard.number, .of = shard.of, .all = pieces.count()};
  for (const std::size_t place : pieces.share(shard)) row.own.push_back(place + 1);
  return row;
}

/// What all summaries have in common.
struct Frame {
  std::string title, status, message;
  Program program;
  std::optional<ShardRow> shard{};
  build::SectionNumbers section;
  Cost cost;
  std::vector<std::string> findings, warnings, files;
  std::vector<VerdictRow> accept;
  std::vector<results::Highlight> highlights;
  std::vector<results::Figure> figures;
  std::vector<results::ShownTable> shown;
};
template <class V>
void members(V& v, Frame& f) {
  v.value("title", f.title, {.what = "of the case"});
  v.value("status", f.status, {.what = "done, failed or interrupted"});
  v.value("message", f.message, {.what = "why it is not done"});
  v.record("program", f.program, {.what = "what has computed this"});
  v.value("case", "", {.what = "the case as run: every key with its value"});
  v.record("shard", f.shard, {.what = "which part of a study this is; absent where it is the whole"});
  v.record("section", f.section, {.what = "the numbers of the section"});
  v.record("cost", f.cost, {.what = "what it took"});
  v.value("findings", f.findings, {.what = "what was found, in words"});
  v.value("warnings", f.warnings, {.what = "what to know before a number is used"});
  v.list("accept", f.accept, {.what = "the verdicts on [accept]"});
  v.list("highlights", f.highlights, {.what = "the numbers to look at first"});
  v.list("figures", f.figures, {.what = "what is worth drawing"});
  v.list("shown_tables", f.shown, {.what = "the tables that the terminal and the page show"});
  v.value("files", f.files, {.what = "the tables of this folder, and its fields"});
}

Value list_of(const std::vector<std::string>& words) {
  Value list = Value::list();
  for (const std::string& word : words) list.append(word);
  return list;
}

/// What every summary begins with; `status` and `cost` get their values at the end, and stand where they are read
/// first.
Value frame(const casefile::Scene& scene, const Analysis& analysis) {
  Value s = Value::object();
  s.set("title", scene.title);
  s.set("status", "");
  s.set("program", program_of_summaries());
  s.set("case", casefile::case_as_run(scene));
  s.set("section", results::to_value(build::section_numbers(analysis.base() ? *analysis.base() : scene)));
  s.set("cost", results::to_value(Cost{}));
  s.set("findings", Value::list());
  s.set("warnings", Value::list());
  return s;
}

}  // namespace

std::vector<results::MemberNote> notes_of_frame() {
  return results::ReferenceWriter::of<Frame>();
}

results::Value program_of_summaries() {
  return results::to_value(Program{});
}

const char* resumes_from(const casefile::Scene& scene) {
  if (scene.is<casefile::TradeoffAnalysis>()) return settings_folder;
  return scene.is<casefile::SelfDampingAnalysis>() ? self_damping::log_name : checkpoint_name;
}

CaseResult run_case(const casefile::Scene& scene, const Hooks& hooks) {
  const auto wall_start = std::chrono::steady_clock::now();
  const std::clock_t cpu_start = std::clock();
  const std::unique_ptr<Analysis> analysis = prepare(scene);
  CaseResult result;
  result.summary = frame(scene, *analysis);
  result.warnings = scene.warnings;
  if (hooks.shard) result.summary.set("shard", results::to_value(row_of(*hooks.shard, *analysis->pieces())));
  try {
    analysis->run(hooks, result);
  } catch (const Interrupted& stopped) {
    result.exit_code = ExitCode::interrupted;
    result.message = stopped.what();
  }

  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - wall_start;
  result.cost.wall_s = wall.count();
  result.cost.cpu_s = static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC;
  Value& s = result.summary;
  s.set("cost", results::to_value(result.cost));
  s.set("findings", list_of(result.findings));
  s.set("warnings", list_of(result.warnings));
  if (!hooks.shard) judge_acceptance(scene, result);  // it speaks of the whole study
  s.set("warnings", list_of(result.warnings));
  s.set("status", status_word(result.exit_code));
  if (!result.message.empty()) s.set("message", result.message);
  if (!result.verdicts.empty()) s.set("accept", results::to_value(rows_of(result.verdicts)));
  s.set("highlights", results::to_value(result.highlights));
  s.set("figures", results::to_value(result.figures));
  s.set("shown_tables", results::to_value(result.shown));
  std::vector<std::string> files;
  for (const results::NamedTable& table : result.tables) files.push_back(table.file);
  files.insert(files.end(), result.written.begin(), result.written.end());
  s.set("files", list_of(files));
  return result;
}

}  // namespace strandyn::study
