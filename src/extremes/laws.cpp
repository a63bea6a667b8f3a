// Every law on paths that jump between 1e-12 and 10 1/m, from compression to the rated strength, in every step.
#include <cmath>
#include <random>

#include "point.hpp"
#include "strands.hpp"
#include "strandyn/section/compliant.hpp"
#include "strandyn/section/linear_law.hpp"
#include "strandyn/section/masing.hpp"
#include "strandyn/section/multilinear.hpp"
#include "strandyn/section/return_map.hpp"
#include "strandyn/section/spatial_compliant.hpp"
#include "strandyn/section/spatial_return_map.hpp"
#include "themes.hpp"

namespace strandyn::extremes {
namespace {

using section::Dimension;

/// Bits of a fixed seed, so that a path is the same on every machine.
Path wild_path(int steps, bool axial_moves) {
  std::mt19937_64 bits(2016);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53;
  };
  const auto curvature = [&] { return (between(-1, 1) < 0 ? -1 : 1) * std::pow(10.0, between(-12, 1)); };
  Path path = {{.eps = strain_at(0.15)}};
  for (int i = 0; i < steps; ++i) {
    Strain s{.eps = strain_at(0.15), .chi2 = curvature(), .chi3 = curvature()};
    if (axial_moves) {
      s.eps = strain_at(between(-0.2, 1));
      s.chi1 = between(-0.1, 0.1);
    }
    path.push_back(s);
  }
  return path;
}

Found wild(const section::Law& law, bool loses) {
  constexpr int steps = 2000;
  const Walk held = walk(law, wild_path(steps, false)), moved = walk(law, wild_path(steps, true));
  Found found;
  add_account(held, found);
  add_account(moved, found);
  if (loses) found.least("loss (J/m)", held.lost, 1e-3);
  if (!loses) found.most("loss (J/m)", std::max(held.lost, moved.lost), 0);
  return found.costs(cost_of(law, wild_path(steps, true), law));
}

section::MultilinearSection springs(section::BendingCoupling coupling) {
  return {.EA = 1e7,
          .GJ = 10,
          .EI = 30,
          .springs = {{.stiffness = 500, .yield = 0.01}, {.stiffness = 300, .yield = 0.02}},
          .coupling = coupling};
}
section::LinearStiffness linear(double EI) {
  return {.EA = curlew_constants().EA, .GJ = curlew_constants().GJ, .C_AT = curlew_constants().C_AT, .EI = EI};
}

}  // namespace

std::vector<Extreme> law_rows() {
  using section::BendingCoupling;
  const std::string what = "2000 steps, each anywhere from 1e-12 to 10 1/m, from compression to the rated strength";
  const std::string bound = "stored plus lost is the work of every step; no step gives energy";
  const auto row = [&](const char* name, std::function<Found()> run) {
    return Extreme{std::string("laws/") + name, what, bound, std::move(run)};
  };
  return {
      row("elastic", [] { return wild(section::LinearLaw("elastic", Dimension::planar, linear(100)), false); }),
      row("stick",
          [] {
            return wild(section::LinearLaw("stick", Dimension::spatial, linear(curlew_constants().EI_max)), false);
          }),
      row("slip",
          [] {
            return wild(section::LinearLaw("slip", Dimension::spatial, linear(curlew_constants().EI_min)), false);
          }),
      row("multilinear",
          [] { return wild(section::MultilinearLaw(springs(BendingCoupling::per_axis), Dimension::planar), true); }),
      row("multilinear-per-axis",
          [] { return wild(section::MultilinearLaw(springs(BendingCoupling::per_axis), Dimension::spatial), true); }),
      row("multilinear-coupled",
          [] { return wild(section::MultilinearLaw(springs(BendingCoupling::coupled), Dimension::spatial), true); }),
      row("masing", [] { return wild(section::MasingLaw(curlew()), true); }),
      row("return-map", [] { return wild(section::PlanarReturnMap(curlew(), 36), true); }),
      row("return-map-thin-wires", [] { return wild(section::PlanarReturnMap(many_thin_wires(), 36), true); }),
      row("compliant", [] { return wild(section::CompliantLaw(curlew()), true); }),
      row("biaxial-return-map", [] { return wild(section::SpatialReturnMap(curlew(), {}), true); }),
      row("spatial-compliant",
          [] { return wild(section::SpatialCompliantLaw(curlew(), {.springs = section::springs_in_space}), true); }),
  };
}

}  // namespace strandyn::extremes
