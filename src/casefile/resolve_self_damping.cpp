#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "resolve.hpp"
#include "strandyn/analysis/published_laws.hpp"

namespace strandyn::casefile {
namespace {

bool has_rated_strength(const Scene& scene) {
  return scene.conductor && scene.conductor->strand.rated_strength > 0;
}

void need_rated_strength(const Scene& scene, const std::string& path) {
  if (has_rated_strength(scene)) return;
  refuse(scene.source, path, "needs the rated strength of the conductor",
         "give conductor.rated_strength_kN, or the tension in kilonewtons");
}

void need_diameter(const Scene& scene, const std::string& path) {
  if (scene.conductor) return;
  refuse(scene.source, path, "needs the diameter of the conductor", "give [conductor]");
}

/// The limit of the amplitudes must have velocities to speak of, and leave a point of them.
void check_limit(const Scene& scene) {
  const SelfDampingAnalysis& a = scene.as<SelfDampingAnalysis>();
  if (!a.highest_amplitude_over_diameter) return;
  const std::string path = "analysis.highest_amplitude_over_diameter";
  need_diameter(scene, path);
  if (a.antinode_velocities.empty()) {
    refuse(scene.source, path, "limits the velocities of the grid, and there are none",
           "give antinode_velocity_m_per_s, or leave the limit out");
  }
  if (a.frequencies.empty()) return;  // the frequencies of modes are not known here
  const double least = std::ranges::min(a.antinode_velocities) /
                       (2 * std::numbers::pi * std::ranges::max(a.frequencies)) /
                       scene.conductor->strand.outer_diameter();
  if (least <= *a.highest_amplitude_over_diameter * (1 + 1e-9)) return;
  refuse(
      scene.source, path,
      fmt::format("leaves no point: the smallest velocity at the highest frequency is {:.3g} of the diameter", least),
      fmt::format("give {:.3g} or more, or smaller velocities", least));
}

void check_grid(const Scene& scene) {
  const SelfDampingAnalysis& a = scene.as<SelfDampingAnalysis>();
  const bool amplitudes =
      !a.amplitudes_over_diameter.empty() || !a.antinode_amplitudes.empty() || !a.antinode_velocities.empty();
  const bool tensions = !a.tensions_rts.empty() || !a.tensions.empty();
  const bool any = a.has_grid() || amplitudes || tensions;
  if (!any && a.at.empty()) {
    refuse(scene.source, "analysis", "has no point",
           "give frequencies_Hz, amplitude_over_diameter and tensions_rts, or [[analysis.at]] tables");
  }
  if (any && !a.has_grid()) {
    refuse(scene.source, "analysis", "its frequencies are missing", "give frequencies_Hz or modes");
  }
  if (any && !amplitudes) {
    refuse(scene.source, "analysis", "its amplitudes are missing",
           "give amplitude_over_diameter, antinode_amplitude_mm or antinode_velocity_m_per_s");
  }
  if (any && !tensions)
    refuse(scene.source, "analysis", "its tensions are missing", "give tensions_rts or tensions_kN");
  if (!a.amplitudes_over_diameter.empty()) need_diameter(scene, "analysis.amplitude_over_diameter");
  check_limit(scene);
  if (!a.tensions_rts.empty()) need_rated_strength(scene, "analysis.tensions_rts");
  for (std::size_t i = 0; i < a.at.size(); ++i) {
    if (a.at[i].amplitude_over_diameter) {
      need_diameter(scene, fmt::format("analysis.at[{}].amplitude_over_diameter", i));
    }
    if (a.at[i].tension_rts) need_rated_strength(scene, fmt::format("analysis.at[{}].tension_rts", i));
  }
  for (std::size_t i = 0; i < a.bands.size(); ++i) {
    const std::string path = fmt::format("analysis.bands_over_diameter[{}]", i);
    need_diameter(scene, path);
    if (a.bands[i][0] < a.bands[i][1]) continue;
    refuse(scene.source, path, "is empty", "give the smallest amplitude over diameter first, then the largest");
  }
}

void check_methods(const Scene& scene) {
  const SelfDampingAnalysis& a = scene.as<SelfDampingAnalysis>();
  const bool on_span = (a.mode_shape == ModeShape::clamped && a.takes(DampingMethod::quadrature)) ||
                       a.takes(DampingMethod::periodic) || a.takes(DampingMethod::transient);
  if ((on_span || a.names_modes()) && !(scene.span && scene.span->length)) {
    refuse(scene.source, "span.length_m",
           fmt::format("is missing, and {} needs it", on_span ? "the method of a point" : "the frequency of a mode"),
           on_span ? "give [span] with length_m, or method = \"quadrature\" with mode_shape = \"sine\""
                   : "give [span] with length_m, or frequencies in hertz");
  }
  if (!mass_per_length(scene)) {
    refuse(scene.source, scene.conductor ? "conductor.mass_kg_per_m" : "section.mass_kg_per_m",
           "is missing, and a vibration needs a mass", "give the mass per length in kilograms per metre");
  }
  if (a.simplified.chi_0_at_rated_strength) {
    need_rated_strength(scene, "analysis.foti_2018.chi_0_at_rated_strength_per_m");
  }
  const bool simplified =
      a.takes(DampingMethod::foti_2018) || std::ranges::any_of(a.energy_balances, [](const EnergyBalanceKeys& balance) {
        return balance.self_damping == BalancedBy::foti_2018;
      });
  const bool given = a.simplified.EI && a.simplified.chi_0_at_rated_strength;
  if (simplified && !given && !scene.conductor) {
    refuse(scene.source, "analysis.foti_2018", "is missing, and there is no strand to take its numbers from",
           "give EI_N_m2 and chi_0_at_rated_strength_per_m, or [conductor]");
  }
}

void check_balances(const Scene& scene) {
  const SelfDampingAnalysis& a = scene.as<SelfDampingAnalysis>();
  for (std::size_t i = 0; i < a.energy_balances.size(); ++i) {
    const EnergyBalanceKeys& balance = a.energy_balances[i];
    const std::string path = fmt::format("analysis.energy_balance[{}]", i);
    need_diameter(scene, path);
    if (balance.frequencies.empty() && a.frequencies.empty()) {
      refuse(scene.source, path, "its frequencies are missing", "give frequencies_Hz there or in [analysis]");
    }
    if (balance.self_damping != BalancedBy::published) continue;
    const auto laws = analysis::published_laws();
    const auto law = std::ranges::find(laws, balance.law, &analysis::PublishedLaw::name);
    if (law == laws.end()) {
      std::string names;
      for (const analysis::PublishedLaw& known : laws) names += (names.empty() ? "" : ", ") + std::string(known.name);
      refuse(scene.source, path + ".law", "is no published law that is known here", "choose one of " + names);
    }
    if (!law->tension) {
      refuse(scene.source, path + ".law", "has no exponent of the tension", "choose a law that has one");
    }
    if (!balance.factor && !law->takes_common_factor && !law->takes_similarity) {
      refuse(scene.source, path + ".factor", "is missing, and this law was published without one",
             "give k for metres, hertz and kilonewtons");
    }
    if (!balance.factor) need_rated_strength(scene, path + ".law");
  }
}

}  // namespace

void check_periodic(const Scene& scene) {
  std::visit(
      [&](const auto& analysis) {
        if constexpr (requires { analysis.periodic; }) {
          const PeriodicKeys& periodic = analysis.periodic;
          const int least = 4 * periodic.harmonics + 4;
          if (periodic.samples >= least) return;
          refuse(scene.source, "analysis.periodic.samples",
                 fmt::format("are too few for {} harmonics of the motion", periodic.harmonics),
                 fmt::format("give {} or more", least));
        }
      },
      scene.analysis);
}

void check_sweep(const Scene& scene) {
  if (!scene.is<SweepAnalysis>()) return;
  const auto& sweep = scene.as<SweepAnalysis>();
  if (sweep.from.has_value() != sweep.to.has_value()) {
    refuse(scene.source, sweep.from ? "analysis.from_Hz" : "analysis.to_Hz", "needs the other end of the sweep",
           "give both from_Hz and to_Hz, or relative_width");
  }
  if (sweep.from && *sweep.from == *sweep.to) {
    refuse(scene.source, "analysis.to_Hz", "is where the sweep begins", "give another frequency than from_Hz");
  }
}

void fill_laboratory_grid(Scene& scene) {
  auto* a = std::get_if<SelfDampingAnalysis>(&scene.analysis);
  if (!a || !a->has_grid() || a->method != DampingMethod::quadrature || a->mode_shape == ModeShape::clamped) return;
  const bool given =
      !a->amplitudes_over_diameter.empty() || !a->antinode_amplitudes.empty() || !a->antinode_velocities.empty();
  if (given || !scene.conductor) return;
  a->antinode_velocities = {0.05, 0.1, 0.2, 0.3, 0.4};
  if (!a->highest_amplitude_over_diameter) a->highest_amplitude_over_diameter = 0.5;
}

void check_self_damping(const Scene& scene) {
  if (!scene.is<SelfDampingAnalysis>()) return;
  check_grid(scene);
  check_methods(scene);
  check_balances(scene);
}

}  // namespace strandyn::casefile
