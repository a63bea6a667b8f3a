#pragma once
/// \file One analysis of one scene, from its preparation to what it leaves.
///
///     prepare(scene)  decides all that can be refused, and owns what it decided     `check` ends here
///     outlook()       what will be modelled and what it will cost                   `describe`
///     run(...)        computes; throws no InputError but for a checkpoint of another case
/// The table in src/study/entries.hpp is the only place that knows all analyses.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "strandyn/casefile/scene.hpp"
#include "strandyn/core/stop.hpp"
#include "strandyn/results/figure.hpp"
#include "strandyn/study/pieces.hpp"

namespace strandyn::study {

/// How the caller takes part in a run.
struct Hooks {
  Stop stop;                                                        ///< true: end early, keep what there is
  std::function<void(double fraction, std::string_view)> progress;  ///< how far, in words
  std::function<void(std::string_view)> announce = {};              ///< what is going to be integrated, before it is
  /// Where a study of many points keeps the finished ones, and a long run its cycles and checkpoints; empty: nowhere.
  std::filesystem::path folder = {};
  bool resume = false;  ///< go on from the checkpoint or the finished points in `folder`, if there are any
  /// Of files that are not as they were left: no part of the results, which are those without the damage.
  std::function<void(std::string_view)> warn = {};
  std::optional<Shard> shard = {};  ///< of an analysis that has pieces: the part to be computed
  bool merged =
      false;  ///< what is resumed are the shares of all shards: nothing is computed twice, and nothing says so
};

struct Cost {
  double wall_s = 0, cpu_s = 0;
  std::uint64_t steps = 0, rejected_steps = 0, order_one_steps = 0;
  std::uint64_t residual_evaluations = 0, jacobian_evaluations = 0;
  std::uint64_t section_evaluations = 0, section_sweeps = 0;
  std::uint64_t newton_iterations = 0;

  /// The counts of work that belongs to the same run; its time is among the run's already.
  void add(const Cost& part);
};
template <class V>
void members(V& v, Cost& c) {
  v.value("wall_s", c.wall_s, {.what = "time that passed"});
  v.value("cpu_s", c.cpu_s, {.what = "time of all processors"});
  v.value("steps", c.steps, {.what = "steps that were accepted"});
  v.value("rejected_steps", c.rejected_steps, {.what = "steps that were cut"});
  v.value("order_one_steps", c.order_one_steps, {.what = "steps of IDA that fell back to order 1"});
  v.value("residual_evaluations", c.residual_evaluations, {.what = "evaluations of the forces of the chain"});
  v.value("jacobian_evaluations", c.jacobian_evaluations, {.what = "the same with the tangent"});
  v.value("section_evaluations", c.section_evaluations, {.what = "one section point, one call of its law"});
  v.value("section_sweeps", c.section_sweeps, {.what = "of these, the ones that marched through the layers"});
  v.value("newton_iterations", c.newton_iterations, {.what = "corrections of the integrator"});
}

/// What an analysis leaves.
struct Outcome {
  ExitCode exit_code = ExitCode::done;
  std::string message;       ///< why exit_code is not `done`; empty otherwise
  bool ended_early = false;  ///< interrupted or failed midway: a checkpoint may still serve
  results::Value summary = results::Value::object();
  std::vector<results::NamedTable> tables;
  std::vector<std::string> streamed;  ///< tables that are in the folder already, in full
  std::vector<std::string> written;   ///< other files that are in the folder already
  std::vector<results::Figure> figures;
  std::vector<results::ShownTable> shown;
  std::vector<results::Highlight> highlights;
  std::vector<std::string> warnings;
  std::vector<std::string> findings;  ///< what was found, in sentences, with what must be known beside it
  Cost cost;

  /// The members of a record, among those of the summary.
  template <class R>
  void tell(const R& record) {
    summary.merge(results::to_value(record));
    for (results::Highlight& highlight : results::highlights_of(record)) highlights.push_back(std::move(highlight));
  }
};

/// What is expected of an analysis before it runs.
struct Outlook {
  results::Value modelled = results::Value::object();  ///< groups of what will be modelled
  double evaluations_least = 0, evaluations_most = 0;  ///< of sections
  double seconds_per_evaluation = 0;                   ///< all the work around it included
  double memory = 0;                                   ///< [B]

  template <class R>
  void tell(const char* group, const R& record) {
    modelled.set(group, results::to_value(record));
  }
};

class Analysis {
 public:
  virtual ~Analysis() = default;
  /// The scene whose section the summary tells; null: that which was prepared.
  virtual const casefile::Scene* base() const { return nullptr; }
  virtual Outlook outlook() = 0;
  /// What can be divided among shards; null where nothing can.
  virtual const Pieces* pieces() const { return nullptr; }
  virtual void run(const Hooks& hooks, Outcome& outcome) = 0;
};

/// Throws InputError for what the scene, which must outlive the analysis, asks and this version cannot do.
std::unique_ptr<Analysis> prepare(const casefile::Scene& scene);

}  // namespace strandyn::study
