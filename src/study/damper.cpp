#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "damper_rows.hpp"
#include "entries.hpp"
#include "findings.hpp"
#include "outlook.hpp"
#include "strandyn/build/losses.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/core/side_by_side.hpp"
#include "strandyn/damper/arm_chain.hpp"
#include "strandyn/damper/reduced_arm.hpp"

namespace strandyn::study {

using casefile::ArmModel;
using casefile::DamperAnalysis;
using casefile::Scene;
using damper::ArmAnswer;

namespace {

/// The frequencies of the case, ascending. [Hz]
std::vector<double> frequencies_of(const DamperAnalysis& keys) {
  if (!keys.frequencies.empty()) return keys.frequencies;
  std::vector<double> frequencies;
  const double octaves = std::log2(keys.to / keys.from);
  const int steps = std::max(1, static_cast<int>(std::ceil(octaves * keys.points_per_octave - 1e-9)));
  for (int i = 0; i <= steps; ++i) frequencies.push_back(keys.from * std::exp2(octaves * i / steps));
  return frequencies;
}

damper::Messenger messenger_of(const Scene& scene) {
  return {.law = build::build_law(scene, section::Dimension::planar),
          .mass_per_length = casefile::mass_per_length(scene).value_or(0),
          .material = build::material_loss(scene, 0)};
}

class Damper final : public Analysis {
 public:
  explicit Damper(const Scene& scene)
      : scene_(scene), keys_(scene.as<DamperAnalysis>()), messenger_(messenger_of(scene)) {
    if (keys_.arms.size() > 2) {
      refuse(scene.source, "analysis.arm[2]", fmt::format("{} arms: a damper has one or two", keys_.arms.size()),
             "leave the others out");
    }
    if (keys_.frequencies.empty() && !(keys_.to > keys_.from)) {
      refuse(scene.source, "analysis.to_Hz", fmt::format("does not lie above from_Hz = {}", keys_.from),
             "give a higher frequency");
    }
    require_ascending("analysis.frequencies_Hz", keys_.frequencies);
    require_ascending("analysis.clamp_velocity_m_per_s", keys_.velocities);
    for (std::size_t i = 0; i < keys_.arms.size(); ++i) {
      const casefile::ArmKeys& a = keys_.arms[i];
      if (a.inertia == 0 && a.eccentricity == 0 && messenger_.mass_per_length == 0) {
        refuse(scene.source, fmt::format("analysis.arm[{}].inertia_kg_m2", i),
               "a weight that is a point on a messenger without mass: its rotation has no inertia",
               "give the moment of inertia of the weight");
      }
      arms_.push_back(
          {.length = a.length, .weight = {.mass = a.mass, .inertia = a.inertia, .eccentricity = a.eccentricity}});
    }
    frequencies_ = frequencies_of(keys_);
  }

  Outlook outlook() override {
    Outlook outlook;
    const double jobs = static_cast<double>(frequencies_.size() * keys_.velocities.size() * arms_.size());
    const auto sections = static_cast<double>(2 * keys_.elements);
    const casefile::Law law = scene_.section.law;
    const bool slips = law != casefile::Law::stick && law != casefile::Law::slip && law != casefile::Law::elastic;
    if (keys_.model == ArmModel::reduced) {
      expect(outlook, 60000, 3.1);  // the loops of all amplitudes, once
    } else {
      // Rounds of Newton's method, each some cycles around the loops; where wires slip also their derivatives.
      expect(outlook, jobs * sections * keys_.periodic.samples * (slips ? 120 : 9), 3.1);
    }
    const SlippingCycle cycle{.tangents = true};
    outlook.seconds_per_evaluation =
        (slips ? 6 : 32) * slipping_time(*messenger_.law, static_cast<std::size_t>(2 * keys_.elements), cycle);
    return outlook;
  }

  void run(const Hooks& hooks, Outcome& outcome) override {
    DamperSummary summary;
    add_arms(hooks, summary);
    DamperRows chain, reduced;
    bool stopped = false;
    if (keys_.model != ArmModel::reduced) stopped = !by_chains(hooks, chain, outcome);
    if (keys_.model != ArmModel::chain && !stopped) by_two_unknowns(reduced, outcome);
    const DamperRows& main = keys_.model == ArmModel::reduced ? reduced : chain;
    for (const double velocity : keys_.velocities) {
      summary.velocities.push_back(shaken_at(velocity, main.rows, reduced.rows));
    }
    summary.failed = main.failed;
    outcome.tell(summary);
    for (const ShakenRow& shaken : summary.velocities) {
      std::string peaks;
      for (const PeakRow& peak : shaken.peaks) {
        peaks += fmt::format("{}{} at {:.4g} Hz", peaks.empty() ? "" : ", ", amount(peak.power, "W"), peak.frequency);
      }
      if (peaks.empty()) continue;
      outcome.findings.push_back(fmt::format("Shaken at {} the damper takes most at its resonances: {}.",
                                             amount(shaken.velocity, "m/s"), peaks));
    }
    add_damper_tables(chain.rows, reduced.rows, outcome);
    if (!main.failed.empty()) {
      outcome.warnings.push_back(fmt::format(
          "{} of {} points have no answer (`failed` in summary.json says why) and are left out: give points_per_octave "
          "more of them, or lower clamp_velocity_m_per_s",
          main.failed.size(), points()));
    }
    if (!stopped) return;
    outcome.exit_code = ExitCode::interrupted;
    outcome.message = fmt::format("interrupted after {} of {} points; they are kept", main.rows.size(), points());
  }

 private:
  void require_ascending(const char* key, const std::vector<double>& list) const {
    if (std::ranges::adjacent_find(list, std::ranges::greater_equal{}) == list.end()) return;
    refuse(scene_.source, key, "does not ascend", "sort the list, and leave out what stands twice");
  }

  std::size_t points() const { return frequencies_.size() * keys_.velocities.size(); }

  damper::ArmChainOptions chain_options(const Hooks& hooks) const {
    return {.elements = static_cast<std::size_t>(keys_.elements),
            .harmonics = keys_.periodic.harmonics,
            .samples = keys_.periodic.samples,
            .stop = hooks.stop};
  }

  void add_arms(const Hooks& hooks, DamperSummary& summary) const {
    for (const damper::Arm& arm : arms_) {
      const damper::ArmChain chain(arm, messenger_, chain_options(hooks));
      summary.arms.push_back({.frequencies = chain.natural_frequencies(2)});
    }
  }

  /// The rows of all velocities; false where it was stopped: then those that are there of every arm.
  bool by_chains(const Hooks& hooks, DamperRows& rows, Outcome& outcome) const {
    const std::size_t jobs = arms_.size() * keys_.velocities.size();
    std::vector<std::vector<ArmAnswer>> answers(jobs);
    std::mutex mutex;
    std::size_t done = 0;
    bool stopped = false;
    side_by_side(jobs, [&](std::size_t job) {
      damper::ArmChain chain(arms_[job % arms_.size()], messenger_, chain_options(hooks));
      const double velocity = keys_.velocities[job / arms_.size()];
      for (const double frequency : frequencies_) {
        ArmAnswer answer;
        try {
          answer = chain.answer({.frequency = frequency, .velocity = velocity});
        } catch (const Interrupted&) {
          const std::lock_guard lock(mutex);
          stopped = true;
          return;
        }
        answers[job].push_back(answer);
        const std::lock_guard lock(mutex);
        outcome.cost.section_evaluations += answer.effort.evaluations;
        outcome.cost.section_sweeps += answer.effort.sweeps;
        ++done;
        if (hooks.progress) {
          hooks.progress(static_cast<double>(done) / static_cast<double>(jobs * frequencies_.size()),
                         fmt::format("{:.4g} m/s, {:.4g} Hz", velocity, frequency));
        }
      }
    });
    for (std::size_t v = 0; v < keys_.velocities.size(); ++v) {
      for (std::size_t i = 0; i < frequencies_.size(); ++i) {
        std::vector<ArmAnswer> of_arms;
        for (std::size_t a = 0; a < arms_.size(); ++a) {
          const std::vector<ArmAnswer>& of_arm = answers[v * arms_.size() + a];
          if (i < of_arm.size()) of_arms.push_back(of_arm[i]);
        }
        if (of_arms.size() == arms_.size()) rows.add(of_arms, keys_.clamp_mass);
      }
    }
    return !stopped;
  }

  void by_two_unknowns(DamperRows& rows, Outcome& outcome) const {
    const damper::BendingLoops loops(*messenger_.law);
    outcome.cost.section_evaluations += loops.effort().evaluations;
    outcome.cost.section_sweeps += loops.effort().sweeps;
    for (const double velocity : keys_.velocities) {
      std::vector<damper::ReducedArm> arms;
      for (const damper::Arm& arm : arms_) arms.emplace_back(arm, messenger_, loops);
      for (const double frequency : frequencies_) {
        std::vector<ArmAnswer> of_arms;
        for (damper::ReducedArm& arm : arms) {
          of_arms.push_back(arm.answer({.frequency = frequency, .velocity = velocity}));
        }
        rows.add(of_arms, keys_.clamp_mass);
      }
    }
  }

  const Scene& scene_;
  const DamperAnalysis& keys_;
  damper::Messenger messenger_;
  std::vector<damper::Arm> arms_;
  std::vector<double> frequencies_;
};

}  // namespace

std::vector<results::MemberNote> notes_of_damper() {
  return results::ReferenceWriter::of<DamperSummary>();
}

std::unique_ptr<Analysis> prepare_damper(const Scene& scene) {
  return std::make_unique<Damper>(scene);
}

}  // namespace strandyn::study
