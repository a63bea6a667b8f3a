#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "entries.hpp"
#include "strandyn/casefile/echo.hpp"
#include "strandyn/casefile/read.hpp"
#include "strandyn/core/checksum.hpp"
#include "strandyn/results/folder.hpp"
#include "strandyn/results/json.hpp"
#include "strandyn/study/run_case.hpp"
#include "tradeoff_rows.hpp"

namespace strandyn::study {

using casefile::Scalar;
using casefile::Scene;

namespace {

constexpr std::size_t most_settings = 1000;
/// As --set takes it.
std::string text_of(const Scalar& value) {
  if (const bool* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const double* number = std::get_if<double>(&value)) return fmt::format("{}", *number);
  return std::get<std::string>(value);
}

results::Value value_of(const Scalar& value) {
  if (const double* x = std::get_if<double>(&value); x && *x == std::round(*x) && std::abs(*x) < 1e15) {
    return results::Value(static_cast<std::int64_t>(*x));
  }
  return std::visit([](const auto& x) { return results::Value(x); }, value);
}

class Tradeoff final : public Analysis, public Pieces {
 public:
  explicit Tradeoff(const Scene& scene)
      : scene_(scene),
        keys_(scene.as<casefile::TradeoffAnalysis>()),
        file_(std::filesystem::path(scene.source.file).parent_path() / keys_.base) {
    list_settings();
    base_ = casefile::read_scene(file_);
    if (base_.is<casefile::TradeoffAnalysis>()) {
      refuse(scene.source, "analysis.base", "is a tradeoff itself", "name a case of another analysis");
    }
    std::vector<std::size_t> setting = settings_.front();
    for (std::size_t k = 0; k < keys_.knobs.size(); ++k) {
      for (std::size_t value = 0; value < keys_.knobs[k].values.size(); ++value) {
        setting[k] = value;
        check(setting, fmt::format("analysis.knob[{}].values[{}]", k, value));
      }
    }
  }

  const Scene* base() const override { return &base_; }

  const Pieces* pieces() const override { return this; }
  const char* noun() const override { return "setting"; }
  std::size_t count() const override { return settings_.size(); }
  std::vector<std::size_t> share(const Shard& shard) const override { return dealt(settings_.size(), shard); }
  std::string identity() const override {
    return fmt::format("{:016x}", checksum(results::to_text(casefile::case_as_run(scene_), -1) +
                                           results::to_text(casefile::case_as_run(base_), -1) +
                                           results::to_text(program_of_summaries(), -1)));
  }
  Found look(const ShardFolder& shard) const override {
    Found found;
    for (const std::size_t number : share(shard.shard)) {
      if (!is_kept(number, shard.folder)) found.missing.push_back(number);
    }
    return found;
  }
  void gather(const std::vector<ShardFolder>& shards, const std::filesystem::path& out) const override {
    const std::filesystem::path folder = out / settings_folder;
    std::filesystem::remove_all(folder);
    results::create_folder(folder);
    for (const ShardFolder& shard : shards) {
      for (const std::size_t number : share(shard.shard)) {
        const std::filesystem::path kept = file_of(shard.folder / settings_folder, number);
        if (std::filesystem::exists(kept)) results::write_file(file_of(folder, number), results::read_file(kept));
      }
    }
  }

  Outlook outlook() override {
    Outlook all;
    double seconds = 0;
    for (const std::vector<std::size_t>& setting : settings_) {
      const Scene scene = scene_of(setting);
      const Outlook one = prepare(scene)->outlook();
      all.evaluations_least += one.evaluations_least;
      all.evaluations_most += one.evaluations_most;
      seconds += std::sqrt(one.evaluations_least * one.evaluations_most) * one.seconds_per_evaluation;
      all.memory = std::max(all.memory, one.memory);
    }
    const double mean = std::sqrt(all.evaluations_least * all.evaluations_most);
    if (mean > 0) all.seconds_per_evaluation = seconds / mean;
    results::Value group = results::Value::object();
    group.set("base", file_.string());
    group.set("settings", settings_.size());
    all.modelled.set("tradeoff", std::move(group));
    return all;
  }

  void run(const Hooks& hooks, Outcome& outcome) override {
    const std::filesystem::path folder = hooks.folder.empty() ? hooks.folder : hooks.folder / settings_folder;
    if (!folder.empty()) {
      if (!hooks.resume) std::filesystem::remove_all(folder);
      results::create_folder(folder);
    }
    TradeoffSummary summary{.quantity = keys_.quantity};
    const std::vector<std::size_t> own = share(hooks.shard.value_or(Shard{}));
    for (const std::size_t i : own) {
      std::optional<SettingRow> row = run_setting(i, folder, hooks, outcome);
      if (!row) {
        outcome.exit_code = ExitCode::interrupted;
        outcome.message =
            fmt::format("interrupted after {} of {} settings; they are kept", summary.points.size(), own.size());
        break;
      }
      summary.points.push_back(std::move(*row));
      // What the reference lacks is found by whoever puts the shards together.
      if (i > 0 || hooks.shard || summary.points.front().value) continue;
      outcome.exit_code = ExitCode::not_converged;
      outcome.message = fmt::format("the reference ({}) has no {}: {}", words_of(settings_.front()), keys_.quantity,
                                    summary.points.front().message.value_or("its summary has no such number"));
      break;
    }
    if (!hooks.shard) return sum_up(summary, outcome);
    outcome.tell(summary);
    add_settings(summary, outcome);
  }

 private:
  /// All combinations: the reference first, then those that go back from it by one value of one knob, then the others.
  void list_settings() {
    std::size_t count = 1;
    for (const casefile::KnobKeys& knob : keys_.knobs) {
      count *= knob.values.size();
      if (count > most_settings) {
        refuse(scene_.source, "analysis.knob", fmt::format("give more than {} combinations", most_settings),
               "give fewer values");
      }
    }
    std::vector<std::size_t> setting(keys_.knobs.size(), 0);
    for (std::size_t i = 0; i < count; ++i) {
      std::size_t rest = i;
      for (std::size_t k = setting.size(); k-- > 0;) {
        setting[k] = rest % keys_.knobs[k].values.size();
        rest /= keys_.knobs[k].values.size();
      }
      settings_.push_back(setting);
    }
    std::ranges::stable_sort(settings_, {}, [this](const auto& s) { return std::min<std::size_t>(back(s), 2); });
  }
  /// By how many values a setting lies behind the reference.
  std::size_t back(const std::vector<std::size_t>& setting) const {
    std::size_t sum = 0;
    for (std::size_t k = 0; k < setting.size(); ++k) sum += keys_.knobs[k].values.size() - 1 - setting[k];
    return sum;
  }

  /// [-] of the whole work, as far as finer values cost in proportion.
  double share_of(std::size_t first, std::size_t last) const {
    double sum = 0, all = 0;
    for (std::size_t i = 0; i < settings_.size(); ++i) {
      double weight = 1;
      for (std::size_t k = 0; k < keys_.knobs.size(); ++k) {
        const double* x = std::get_if<double>(&keys_.knobs[k].values[settings_[i][k]]);
        const double* finest = std::get_if<double>(&keys_.knobs[k].values.back());
        if (x && finest && *x > 0 && *finest > 0) weight *= std::min(*x / *finest, *finest / *x);
      }
      all += weight;
      if (i >= first && i < last) sum += weight;
    }
    return sum / all;
  }

  std::string words_of(const std::vector<std::size_t>& setting) const {
    std::vector<std::string> words;
    for (std::size_t k = 0; k < setting.size(); ++k) {
      words.push_back(fmt::format("{} = {}", keys_.knobs[k].key, text_of(keys_.knobs[k].values[setting[k]])));
    }
    return fmt::format("{}", fmt::join(words, ", "));
  }

  Scene scene_of(const std::vector<std::size_t>& setting) const {
    std::vector<std::string> overrides;
    for (std::size_t k = 0; k < setting.size(); ++k) {
      overrides.push_back(fmt::format("{}={}", keys_.knobs[k].key, text_of(keys_.knobs[k].values[setting[k]])));
    }
    return casefile::read_scene(file_, overrides);
  }

  void check(const std::vector<std::size_t>& setting, const std::string& key_path) const {
    try {
      const Scene scene = scene_of(setting);
      prepare(scene);
    } catch (const InputError& error) {
      refuse(scene_.source, key_path, fmt::format("is refused by the base: {}", error.what()),
             "give a key of the base and values that it can run with");
    }
  }

  /// The run of a setting, or what an earlier one has left of it; nothing where it was stopped.
  std::optional<SettingRow> run_setting(std::size_t number, const std::filesystem::path& folder, const Hooks& hooks,
                                        Outcome& outcome) const {
    const std::vector<std::size_t>& setting = settings_[number];
    const std::filesystem::path file = file_of(folder, number);
    results::Value summary = results::Value::object();
    const auto fail = [&](const char* why) {
      summary.set("status", "failed");
      summary.set("message", why);
    };
    std::optional<Scene> read;
    try {
      const Scene& scene = read.emplace(scene_of(setting));
      if (!folder.empty() && hooks.resume) summary = earlier(file, scene);
      if (summary.empty()) {
        const double from = share_of(0, number), part = share_of(number, number + 1);
        const Hooks inner{.stop = hooks.stop, .progress = [&](double fraction, std::string_view) {
                            if (hooks.progress) hooks.progress(from + part * fraction, words_of(setting));
                          }};
        CaseResult result = run_case(scene, inner);
        if (result.exit_code == ExitCode::interrupted) return std::nullopt;
        summary = std::move(result.summary);
        if (!folder.empty()) results::write_json(file, summary);
      }
    } catch (const ComputationError& error) {
      fail(error.what());
      summary.set("program", program_of_summaries());
      summary.set("case", casefile::case_as_run(*read));
      if (!folder.empty()) results::write_json(file, summary);
    } catch (const InputError& error) {  // each value is fine, and not all of them together
      fail(error.what());
    }
    SettingRow row{.number = number, .is_reference = number == 0};
    row.status = *summary.find("status")->words();
    if (const results::Value* message = summary.find("message"); message && message->words()) {
      row.message = *message->words();
    }
    row.value = casefile::number_at(keys_.quantity, summary);
    row.section_evaluations = casefile::number_at("cost.section_evaluations", summary).value_or(0);
    row.cpu = casefile::number_at("cost.cpu_s", summary).value_or(0);
    outcome.cost.section_evaluations += static_cast<std::uint64_t>(row.section_evaluations);
    outcome.cost.section_sweeps +=
        static_cast<std::uint64_t>(casefile::number_at("cost.section_sweeps", summary).value_or(0));
    outcome.cost.steps += static_cast<std::uint64_t>(casefile::number_at("cost.steps", summary).value_or(0));
    return row;
  }

  static std::filesystem::path file_of(const std::filesystem::path& folder, std::size_t number) {
    return folder / fmt::format("{:03}.json", number);
  }

  /// Whether the folder has what the setting leaves: its summary, or nothing where the base refuses it.
  bool is_kept(std::size_t number, const std::filesystem::path& folder) const {
    try {
      const Scene scene = scene_of(settings_[number]);
      if (!earlier(file_of(folder / settings_folder, number), scene).empty()) return true;
      prepare(scene);
      return false;
    } catch (const InputError&) {
      return true;
    }
  }

  /// The summary in `file` if it is of this program and this very case, else nothing.
  static results::Value earlier(const std::filesystem::path& file, const Scene& scene) {
    const results::Value none = results::Value::object();
    if (!std::filesystem::exists(file)) return none;
    const std::optional<results::Value> kept = results::from_line(results::read_file(file));
    if (!kept || !kept->find("status") || !kept->find("status")->words()) return none;
    const auto same = [&](const char* key, const results::Value& wanted) {
      const results::Value* found = kept->find(key);
      return found && results::to_text(*found, -1) == results::to_text(wanted, -1);
    };
    return same("case", casefile::case_as_run(scene)) && same("program", program_of_summaries()) ? *kept : none;
  }

  void sum_up(TradeoffSummary& summary, Outcome& outcome) const {
    if (!summary.points.empty() && summary.points.front().value) {
      measure(steps_back(), keys_.targets, outcome.exit_code == ExitCode::done, summary, outcome);
    }
    outcome.tell(summary);
    add_settings(summary, outcome);
    add_tables(summary, outcome);
    for (const CheapestRow& row : summary.cheapest) {
      if (!row.number || !row.cost_ratio) continue;
      outcome.findings.push_back(fmt::format("Within {:g} % of the reference: at {:.2g} of its cost (setting {}).",
                                             100 * row.target, *row.cost_ratio, *row.number));
    }
  }

  std::vector<StepBack> steps_back() const {
    std::vector<StepBack> steps;
    for (std::size_t k = 0; k < keys_.knobs.size(); ++k) {
      std::vector<std::size_t> before = settings_.front();
      --before[k];
      const auto at = static_cast<std::size_t>(std::ranges::find(settings_, before) - settings_.begin());
      steps.push_back({.key = keys_.knobs[k].key, .number = at});
    }
    return steps;
  }

  /// `settings` of each of the points.
  void add_settings(const TradeoffSummary& summary, Outcome& outcome) const {
    const results::Value* points = outcome.summary.find("points");
    results::Value with = results::Value::list();
    for (std::size_t i = 0; i < points->entries().size(); ++i) {
      results::Value point = results::Value::object();
      results::Value settings = results::Value::object();
      for (std::size_t k = 0; k < keys_.knobs.size(); ++k) {
        const std::size_t at = settings_[summary.points[i].number][k];
        settings.set(keys_.knobs[k].key, value_of(keys_.knobs[k].values[at]));
      }
      point.set("settings", std::move(settings));
      point.merge(points->entries()[i]);
      with.append(std::move(point));
    }
    outcome.summary.set("points", std::move(with));
  }

  /// The values of the knobs; where one is no number its place in the list stands for it.
  std::vector<double> values_of(std::size_t number) const {
    std::vector<double> values;
    for (std::size_t k = 0; k < keys_.knobs.size(); ++k) {
      const std::size_t at = settings_[number][k];
      const double* x = std::get_if<double>(&keys_.knobs[k].values[at]);
      values.push_back(x ? *x : static_cast<double>(at));
    }
    return values;
  }
  /// Columns of the knobs before others.
  std::vector<std::string> columns(std::initializer_list<const char*> others) const {
    std::vector<std::string> names;
    for (const casefile::KnobKeys& knob : keys_.knobs) names.push_back(knob.key);
    names.insert(names.end(), others.begin(), others.end());
    return names;
  }
  static std::vector<double> joined(std::vector<double> first, std::initializer_list<double> others) {
    first.insert(first.end(), others.begin(), others.end());
    return first;
  }

  void add_tables(const TradeoffSummary& summary, Outcome& outcome) const {
    results::Table all(columns(
        {"number", "value", "error", "error_size", "cost_ratio", "section_evaluations", "cpu_s", "on_frontier"}));
    results::Table frontier({"cost_ratio", "error_size", "number"});
    std::vector<std::array<double, 3>> best;
    for (const SettingRow& row : summary.points) {
      if (!row.error || !row.cost_ratio || row.is_reference) continue;
      const double size = std::abs(*row.error), number = static_cast<double>(row.number);
      all.append(joined(values_of(row.number), {number, *row.value, *row.error, size, *row.cost_ratio,
                                                row.section_evaluations, row.cpu, row.on_frontier ? 1.0 : 0.0}));
      if (row.on_frontier && size > 0) best.push_back({*row.cost_ratio, size, number});
    }
    std::ranges::sort(best);
    for (const auto& row : best) frontier.append(row);
    results::Table cheapest(columns({"target", "error", "cost_ratio", "number"}));
    for (const CheapestRow& row : summary.cheapest) {
      if (!row.number) continue;
      cheapest.append(
          joined(values_of(*row.number), {row.target, *row.error, *row.cost_ratio, static_cast<double>(*row.number)}));
    }
    std::vector<std::string> others = columns({});
    others.erase(others.begin());
    add_tradeoff_figures(others, outcome);
    outcome.shown.push_back({.title = "Error and cost of the settings",
                             .table = "tradeoff.csv",
                             .columns = columns({"value", "error", "cost_ratio", "cpu_s", "on_frontier"})});
    outcome.shown.push_back({.title = "The cheapest setting within each target",
                             .table = "cheapest.csv",
                             .columns = columns({"target", "error", "cost_ratio"})});
    outcome.tables.push_back({.file = "tradeoff.csv", .table = std::move(all)});
    outcome.tables.push_back({.file = "frontier.csv", .table = std::move(frontier)});
    outcome.tables.push_back({.file = "cheapest.csv", .table = std::move(cheapest)});
  }

  const Scene& scene_;
  const casefile::TradeoffAnalysis& keys_;
  std::filesystem::path file_;
  Scene base_;
  std::vector<std::vector<std::size_t>> settings_;  // of each, the place in every knob's values
};

}  // namespace

std::vector<results::MemberNote> notes_of_tradeoff() {
  return results::ReferenceWriter::of<TradeoffSummary>();
}

std::unique_ptr<Analysis> prepare_tradeoff(const Scene& scene) {
  return std::make_unique<Tradeoff>(scene);
}

}  // namespace strandyn::study
