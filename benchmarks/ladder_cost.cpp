// What a section point costs under each law, and how often it need not be marched.
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "ladder.hpp"
#include "strandyn/exact/full_slip.hpp"
#include "strandyn/section/compliant.hpp"
#include "strandyn/section/linear_law.hpp"
#include "strandyn/section/masing.hpp"
#include "strandyn/section/multilinear.hpp"
#include "strandyn/section/spatial_return_map.hpp"
#include "timing.hpp"

namespace strandyn::bench {
namespace {

using section::Component;
using section::Dimension;

constexpr double eta = 0.15;

struct NamedLaw {
  std::string name;
  std::unique_ptr<const section::Law> law;
};

/// Curlew under each law of a dimension. The springs of `multilinear` stand for its four layers.
std::vector<NamedLaw> laws_of(const conductor::Strand& strand, Dimension dimension) {
  using namespace section;
  const conductor::SectionConstants c = conductor::section_constants(strand);
  const bool planar = dimension == Dimension::planar;
  std::vector<NamedLaw> laws;
  const auto add = [&](std::string name, std::unique_ptr<const Law> law) {
    laws.push_back({fmt::format("{}, {}", planar ? "planar" : "spatial", name), std::move(law)});
  };
  add("stick", std::make_unique<LinearLaw>("stick", dimension,
                                           LinearStiffness{.EA = c.EA, .GJ = c.GJ, .C_AT = c.C_AT, .EI = c.EI_max}));
  MultilinearSection springs{.EA = c.EA, .GJ = c.GJ, .EI = c.EI_min, .springs = {}};
  const exact::FullSlip slip = exact::full_slip(strand, eta * strand.rated_strength);
  for (std::size_t j = 1; j < strand.layers.size(); ++j) {
    springs.springs.push_back({.stiffness = c.EI_friction[j], .yield = slip.layer_moment[j] / c.EI_friction[j]});
  }
  add("multilinear, 4 springs", std::make_unique<MultilinearLaw>(springs, dimension));
  if (planar) add("masing", std::make_unique<MasingLaw>(strand));
  for (int points : {20, 36, 72}) {
    const std::string name = fmt::format("return-map, {} points", points);
    if (planar) {
      add(name, std::make_unique<PlanarReturnMap>(strand, points));
    } else {
      const SpatialReturnMapOptions options{.points = points, .axial_resultants = false};
      add(name, std::make_unique<SpatialReturnMap>(strand, options));
    }
  }
  if (planar) {
    add("compliant, 36 points", std::make_unique<CompliantLaw>(strand));
  } else {
    const SpatialReturnMapOptions options{.points = 36, .axial_resultants = true};
    add("return-map, 36 points, axial resultants", std::make_unique<SpatialReturnMap>(strand, options));
  }
  return laws;
}

void print_times(const NamedLaw& named, double eps, double chi_0) {
  // At 2 chi_0 every layer slips; at 1e-4 none does. Off the grid directions, where the law is spatial.
  const auto at = [&](double chi) {
    const bool spatial = named.law->dimension() == Dimension::spatial;
    const double direction = spatial ? 0.3 : 0.0;
    return time_law(*named.law, {.eps = eps, .chi2 = std::cos(direction) * chi, .chi3 = std::sin(direction) * chi});
  };
  const LawTimes slip = at(2 * chi_0);
  const LawTimes stick = at(1e-4 * chi_0);
  fmt::print("| {} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {:.2f} / {:.2f} |\n", named.name,
             1e9 * slip.response, 1e9 * slip.with_tangent, 1e9 * slip.commit, 1e9 * stick.response,
             1e9 * stick.with_tangent, 1e9 * stick.commit, slip.with_tangent / stick.with_tangent, slip.sweeps,
             stick.sweeps);
}

/// (chi2, chi3) over the amplitude, at a phase [rad].
struct Path {
  std::string name;
  std::function<double(double)> chi2, chi3;
};

/// Share of the commits that march, over the second cycle of 200 steps.
double share_of_sweeps(const section::Law& law, const Path& path, double eps, double amplitude) {
  constexpr int steps = 200;
  section::Field strains(law.dimension(), 1);
  section::StepEnergy energy(1);
  strains[Component::axial][0] = eps;
  section::History history = law.start(strains);
  section::Effort effort;
  for (int n = 0; n <= 2 * steps; ++n) {
    const double phase = 2 * std::numbers::pi * n / steps;
    strains[Component::bending2][0] = amplitude * path.chi2(phase);
    if (law.dimension() == Dimension::spatial) strains[Component::bending3][0] = amplitude * path.chi3(phase);
    const section::Effort step = law.commit(history, strains, energy);
    if (n > steps) effort += step;
  }
  return static_cast<double>(effort.sweeps) / static_cast<double>(effort.evaluations);
}

}  // namespace

void print_cost_tables() {
  const conductor::Strand strand = catalogue_strand("curlew");
  const double eps = strain_at(strand, eta);
  const double chi_0 = exact::full_slip(strand, eta * strand.rated_strength).chi_0;
  fmt::print(
      "\nNanoseconds per section point, Curlew at eta {}, batches of {}; r response, t with tangent, c commit.\n", eta,
      law_batch);
  fmt::print("\n| law | slips: r | t | c | sticks: r | t | c | slips/sticks, t | sweeps per evaluation |\n");
  fmt::print("| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (Dimension dimension : {Dimension::planar, Dimension::spatial}) {
    for (const NamedLaw& named : laws_of(strand, dimension)) print_times(named, eps, chi_0);
  }

  const section::MasingLaw masing(strand);
  const section::PlanarReturnMap planar(strand, 36);
  const section::SpatialReturnMap spatial(strand, {.points = 36, .axial_resultants = false});
  const auto cosine = [](double phase) { return std::cos(phase); };
  const auto sine = [](double phase) { return std::sin(phase); };
  const Path straight{"straight", cosine, [](double) { return 0.0; }};
  const Path ellipse{"ellipse 2:1", cosine, [](double phase) { return 0.5 * std::sin(phase); }};
  const Path circle{"circle", cosine, sine};
  constexpr double shares[] = {0.02, 0.05, 0.1, 0.2, 0.5, 1, 2};
  fmt::print("\nShare of the commits of a cycle (200 steps) that march, Curlew at eta {}, by chi_max/chi_0.\n\n", eta);
  fmt::print("| law | path |");
  for (double share : shares) fmt::print(" {} |", share);
  fmt::print("\n| --- | --- |");
  for (std::size_t i = 0; i < std::size(shares); ++i) fmt::print(" --- |");
  const auto row = [&](std::string_view name, const section::Law& law, const Path& path) {
    fmt::print("\n| {} | {} |", name, path.name);
    for (double share : shares) fmt::print(" {:.2f} |", share_of_sweeps(law, path, eps, share * chi_0));
  };
  row("masing", masing, straight);
  row("planar return-map", planar, straight);
  for (const Path& path : {straight, ellipse, circle}) row("spatial return-map", spatial, path);
  fmt::print("\n");
}

}  // namespace strandyn::bench
