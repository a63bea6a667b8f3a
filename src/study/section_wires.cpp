#include <algorithm>
#include <cmath>
#include <numbers>

#include "section_parts.hpp"
#include "strandyn/exact/papailiou.hpp"
#include "strandyn/section/spatial_return_map.hpp"

namespace strandyn::study {

using casefile::Scene;
using section::Component;
using section::Field;

namespace {

/// [N] Papailiou's limit of the bending force at a swept angle, signed: the tension side is where the sine is positive.
double papailiou_limit(const exact::PapailiouLayer& layer, double theta) {
  const double from_neutral_plane = std::asin(std::clamp(std::sin(theta), -1.0, 1.0));
  return layer.limit_force(from_neutral_plane);
}

/// A layer of a bent section.
struct LayerRow {
  double highest = 0, lowest = 0, slipping_share = 0, f_int = 0, f_ext = 0;
  std::optional<double> papailiou_highest{}, papailiou_lowest{}, largest_excess{};
};
template <class V>
void members(V& v, LayerRow& l) {
  v.value("highest_bending_force_N", l.highest, {.what = "of a wire, beyond its axial force"});
  v.value("lowest_bending_force_N", l.lowest, {.what = "of a wire, beyond its axial force"});
  v.value("slipping_share", l.slipping_share, {.what = "of the points around the lay"});
  v.value("f_int_N_per_m", l.f_int, {.what = "force of the inner contact"});
  v.value("f_ext_N_per_m", l.f_ext, {.what = "force of the outer contact"});
  v.value("papailiou_highest_N", l.papailiou_highest, {.what = "Papailiou's limit on the tension side"});
  v.value("papailiou_lowest_N", l.papailiou_lowest, {.what = "on the compression side"});
  v.value("largest_excess_over_papailiou", l.largest_excess, {.what = "of the wires' forces, relative"});
}
/// A section bent to a curvature.
struct WiresRow {
  double curvature = 0, moment = 0;
  std::vector<LayerRow> layers;
};
template <class V>
void members(V& v, WiresRow& w) {
  v.value("curvature_per_m", w.curvature, {.what = "of monotonic bending"});
  v.value("moment_N_m", w.moment, {.what = "at that curvature"});
  v.list("layers", w.layers, {.what = "each layer around the core"});
}

LayerRow row_of(const section::LayerState& layer, double axial_force) {
  const auto [low, high] = std::minmax_element(layer.force.begin(), layer.force.end());
  const auto slipping = std::count(layer.slips.begin(), layer.slips.end(), true);
  return {.highest = *high - axial_force,
          .lowest = *low - axial_force,
          .slipping_share = static_cast<double>(slipping) / static_cast<double>(layer.slips.size()),
          .f_int = layer.f_int,
          .f_ext = layer.f_ext};
}

/// `wires` of summary.json.
struct WiresSummary {
  std::vector<WiresRow> wires;
};
template <class V>
void members(V& v, WiresSummary& s) {
  v.list("wires", s.wires, {.what = "a section bent to each curvature that was asked for"});
}

}  // namespace

std::vector<results::MemberNote> notes_of_wires() {
  return results::ReferenceWriter::of<WiresSummary>();
}

void check_wires(const Scene& scene) {
  if (scene.as<casefile::SectionAnalysis>().wires_at.empty() || build::has_wires(scene.section.law)) return;
  refuse(scene.source, "analysis.wires_at_per_m", "this law knows no wires", "use law = \"return-map\"");
}

/// Monotonic bending of a virgin section; at each asked curvature the wires of every layer along one lay.
void list_wires(const Scene& scene, const Stop& stop, Outcome& outcome) {
  std::vector<double> curvatures = scene.as<casefile::SectionAnalysis>().wires_at;
  if (curvatures.empty()) return;
  std::sort(curvatures.begin(), curvatures.end());
  const conductor::Strand& strand = scene.conductor->strand;
  const std::vector<double> tensions = casefile::section_tensions(scene);
  const double tension = tensions.empty() ? 0 : tensions.front();
  const build::SectionNumbers numbers = build::section_numbers(scene);
  const AxialState axial = axial_state(numbers, scene.as<casefile::SectionAnalysis>().twist, tension);

  const section::SpatialReturnMap law(strand, {.points = scene.section.points});
  Field strains(section::Dimension::spatial, 1);
  Field stresses(section::Dimension::spatial, 1);
  section::StepEnergy energy(1);
  strains[Component::axial][0] = axial.strain;
  strains[Component::torsion][0] = axial.twist;
  section::History memory = law.start(strains);

  // Papailiou's limit is that of one layer without residual force.
  std::optional<exact::PapailiouLayer> papailiou;
  if (strand.layers.size() == 2 && strand.layers[1].residual_force == 0) papailiou.emplace(strand, tension);

  results::Table table(
      {"curvature_per_m", "layer", "theta_rad", "force_N", "stress_Pa", "gradient_N_per_m", "limit_N_per_m", "slips"});
  std::vector<WiresRow> rows;
  for (double curvature : curvatures) {
    // In small steps: a limit that follows the force feels the way.
    constexpr int steps = 200;
    const double from = strains[Component::bending2][0];
    for (int step = 1; step <= steps; ++step) {
      end_if_asked(stop);
      strains[Component::bending2][0] = from + (curvature - from) * step / steps;
      law.commit(memory, strains, energy);
    }
    law.respond(memory, strains, stresses, nullptr);
    const section::WireState wires = law.wires(memory, strains, 0);
    WiresRow& entry = rows.emplace_back();
    entry.curvature = curvature;
    entry.moment = stresses[Component::bending2][0];
    for (std::size_t j = 0; j < wires.layers.size(); ++j) {
      const section::LayerState& layer = wires.layers[j];
      const double c = std::cos(strand.layers[j + 1].lay_angle);
      const double s = std::sin(strand.layers[j + 1].lay_angle);
      const double axial_force = strand.layers[j + 1].EA_wire() *
                                 (c * c * axial.strain + strand.layers[j + 1].helix_radius * s * c * axial.twist);
      LayerRow in_layer = row_of(layer, axial_force);
      if (papailiou) {
        in_layer.papailiou_highest = papailiou->limit_force(std::numbers::pi / 2);
        in_layer.papailiou_lowest = papailiou->limit_force(-std::numbers::pi / 2);
        double largest_excess = 0;
        for (std::size_t i = 0; i < wires.theta.size(); ++i) {
          const double limit = papailiou_limit(*papailiou, wires.theta[i]);
          largest_excess = std::max(largest_excess, (layer.force[i] - axial_force) / limit - 1);
        }
        in_layer.largest_excess = largest_excess;
      }
      entry.layers.push_back(in_layer);
      for (std::size_t i = 0; i < wires.theta.size(); ++i) {
        table.append(std::array{curvature, static_cast<double>(j + 1), wires.theta[i], layer.force[i],
                                layer.force[i] / strand.layers[j + 1].wire_area, layer.gradient[i], layer.limit[i],
                                layer.slips[i] ? 1.0 : 0.0});
      }
    }
  }
  outcome.tell(WiresSummary{.wires = std::move(rows)});
  outcome.tables.push_back({.file = "wires.csv", .table = std::move(table)});
  outcome.figures.push_back({.name = "wires",
                             .title = "Wire forces around the section",
                             .kind = "section",
                             .table = "wires.csv",
                             .x = "theta_rad",
                             .y = {"force_N"},
                             .series = {"curvature_per_m", "layer"},
                             .caption = "Force of the wires of each layer around the lay, under monotonic bending."});
}

}  // namespace strandyn::study
