#include <fmt/format.h>

#include "refusals.hpp"
#include "resolve.hpp"

namespace strandyn::casefile {

namespace {

struct KnownDamper {
  double clamp_mass;
  std::array<double, 2> lengths, masses, inertias, offsets;
  MessengerKeys messenger;
};

constexpr double steel = 7800;  // [kg/m^3]

KnownDamper known(DamperName name) {
  if (name == DamperName::sdm) {
    return {.clamp_mass = 0.835,
            .lengths = {0.150, 0.197},
            .masses = {2.65, 3.115},
            .inertias = {8.41e-3, 1.65e-2},
            .offsets = {0.0163, 0.0222},
            .messenger = {.bending_stiffness = 7.7945, .mass_per_length = steel * 1.327e-4, .loss_factor = 0.0769}};
  }
  return {.clamp_mass = 0.3532,
          .lengths = {0.157, 0.113},
          .masses = {0.8633, 0.7652},
          .inertias = {1.815e-3, 9.614e-4},
          .offsets = {0.020, 0.010},
          .messenger = {.bending_stiffness = 4.903, .mass_per_length = steel * 9.85e-5, .loss_factor = 0.1334}};
}

/// Keys that stand beside a name change that damper.
void fill(DamperKeys& damper, const KnownDamper& from) {
  const auto fill_list = [](std::vector<double>& list, const std::array<double, 2>& values) {
    if (list.empty()) list.assign(values.begin(), values.end());
  };
  if (!damper.clamp_mass) damper.clamp_mass = from.clamp_mass;
  fill_list(damper.lengths, from.lengths);
  fill_list(damper.masses, from.masses);
  fill_list(damper.inertias, from.inertias);
  fill_list(damper.offsets, from.offsets);
  if (!damper.messenger) damper.messenger = from.messenger;
}

void check_lists(const DamperKeys& damper, const std::string& path, const Source& source) {
  const std::size_t arms = damper.lengths.size();
  if (arms > 2) {
    refuse(source, path + ".arm_m", fmt::format("names {} arms", arms), "give one length, or two: left and right");
  }
  for (const auto& [list, key] : {std::pair{&damper.masses, "weight_kg"}, std::pair{&damper.inertias, "inertia_kg_m2"},
                                  std::pair{&damper.offsets, "offset_m"}}) {
    if (list->size() == arms) continue;
    refuse(source, fmt::format("{}.{}", path, key),
           list->empty() ? "is missing" : fmt::format("has {} entries for {} arms", list->size(), arms),
           "give one number for each arm of arm_m");
  }
}

void resolve_messenger(MessengerKeys& messenger, const std::string& path, const Source& source) {
  if (messenger.strand) {
    if (!needs_strand(messenger.law)) {
      refuse(source, path + ".law", fmt::format("\"{}\" knows no wires", name_of(messenger.law)),
             "use a law of strands such as \"return-map\", or EI_N_m2 in place of conductor");
    }
    resolve_conductor(*messenger.strand, source, path + ".conductor");
    if (!messenger.mass_per_length) messenger.mass_per_length = messenger.strand->strand.mass_per_length;
  }
  messenger.mass_per_length = messenger.mass_per_length.value_or(0);
}

/// `length` [m]: of the span, where it is known.
void resolve_damper(DamperKeys& damper, const std::string& path, const Source& source, std::optional<double> length) {
  if (damper.catalogue) {
    fill(damper, known(*damper.catalogue));
  } else if (!damper.messenger) {
    refuse(source, path + ".messenger", "is missing", "give messenger = { EI_N_m2 = ..., mass_kg_per_m = ... }");
  } else if (damper.offsets.empty()) {
    damper.offsets.assign(damper.lengths.size(), 0.0);
  }
  resolve_messenger(*damper.messenger, path + ".messenger", source);
  damper.clamp_mass = damper.clamp_mass.value_or(0);
  check_lists(damper, path, source);
  if (length && damper.at > *length) {
    refuse(source, path + ".at_m", "lies outside the span",
           fmt::format("give a distance from the left support between 0 and {} metres", *length));
  }
}

/// Dampers of an energy balance: one near each end.
void resolve_in_balance(EnergyBalanceKeys& balance, const std::string& path, const Source& source) {
  if (balance.dampers.empty()) {
    for (const auto& [given, key] :
         {std::pair{balance.span.has_value(), ".span_m"}, std::pair{balance.damper_at.has_value(), ".damper_at_m"}}) {
      if (given) refuse(source, path + key, "belongs to dampers, and there are none", "give a damper, or remove it");
    }
    return;
  }
  if (!balance.span) {
    refuse(source, path + ".span_m", "is missing, and dampers protect a span of some length",
           "give its length in metres");
  }
  const double half = *balance.span / 2;
  int left = 0, right = 0;
  for (std::size_t i = 0; i < balance.dampers.size(); ++i) {
    const std::string damper = fmt::format("{}.damper[{}]", path, i);
    resolve_damper(balance.dampers[i], damper, source, balance.span);
    if (balance.dampers[i].messenger->strand) {
      refuse(source, damper + ".messenger.conductor", "is a strand, and a balance knows elastic messengers",
             "give EI_N_m2 and loss_factor, those of the strand at the velocity of its clamp");
    }
    ++(balance.dampers[i].at < half ? left : right);
    if (left > 1 || right > 1) {
      refuse(source, damper, "is a second damper near one end, and a balance knows one an end",
             "put it near the other end, or simulate the span with [[wind]]");
    }
  }
  if (balance.damper_at && (balance.damper_at->to <= balance.damper_at->from || balance.damper_at->to >= half)) {
    refuse(source, path + ".damper_at_m.to", "does not lie between from and the middle of the span",
           "give places that ascend from the support");
  }
}

}  // namespace

void resolve_dampers(Scene& scene) {
  if (auto* study = std::get_if<SelfDampingAnalysis>(&scene.analysis)) {
    for (std::size_t i = 0; i < study->energy_balances.size(); ++i) {
      resolve_in_balance(study->energy_balances[i], fmt::format("analysis.energy_balance[{}]", i), scene.source);
    }
  }
  if (scene.dampers.empty()) return;
  const bool in_time = scene.is<ForcedAnalysis>() || scene.is<TransientAnalysis>() || scene.is<DecayAnalysis>();
  if (!in_time) {
    refuse(scene.source, "damper",
           fmt::format("hangs on spans that vibrate in time, not in analysis.type = \"{}\"", word_of(scene.analysis)),
           "remove the table, or choose \"decay\", \"forced\" or \"transient\"; \"damper\" tests one on a shaker");
  }
  if (scene.accuracy) {
    refuse(scene.source, "accuracy", "chooses no settings for a span with dampers",
           "remove it, and give [span] elements and [integrator] steps_per_cycle");
  }
  if (scene.span && scene.span->dimension == Dimension::spatial) {
    refuse(scene.source, "damper", "swings in the plane of x and y only", "give span.dimension = \"planar\"");
  }
  Refusals refusals;
  for (std::size_t i = 0; i < scene.dampers.size(); ++i) {
    refusals.hold([&] {
      resolve_damper(scene.dampers[i], fmt::format("damper[{}]", i), scene.source, scene.span->total_length());
    });
  }
  refusals.pass_on();
}

}  // namespace strandyn::casefile
