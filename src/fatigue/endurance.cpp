#include "strandyn/fatigue/endurance.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace strandyn::fatigue {
namespace {

constexpr double MPa = 1e6;
constexpr double knee = 2e7;  // cycles

struct Line {
  double factor = 0;    // [MPa]
  double exponent = 0;  // [-]
  double stress(double cycles) const { return factor * MPa * std::pow(cycles, exponent); }
  double cycles(double stress) const { return std::pow(stress / (factor * MPa), 1 / exponent); }
};
struct BorderLine {
  Line before, after;
};
constexpr BorderLine one_layer{.before = {730, -0.2}, .after = {430, -0.17}};
constexpr BorderLine several_layers{.before = {450, -0.2}, .after = {263, -0.17}};

const BorderLine& line_of(AluminiumLayers layers) {
  return layers == AluminiumLayers::one ? one_layer : several_layers;
}

constexpr std::array limits = {EnduranceLimit{"ACSR, one layer of aluminium", 22.5 * MPa},
                               EnduranceLimit{"ACSR, several layers of aluminium", 8.5 * MPa},
                               EnduranceLimit{"AAAC, alloy 6201", 5.7 * MPa}};

}  // namespace

double cycles_endured(AluminiumLayers layers, double stress) {
  if (stress <= 0) return std::numeric_limits<double>::infinity();
  const BorderLine& line = line_of(layers);
  if (stress >= line.before.stress(knee)) return line.before.cycles(stress);
  return stress < line.after.stress(knee) ? line.after.cycles(stress) : knee;
}

double stress_endured(AluminiumLayers layers, double cycles) {
  const BorderLine& line = line_of(layers);
  return cycles <= knee ? line.before.stress(cycles) : line.after.stress(cycles);
}

std::span<const EnduranceLimit> endurance_limits() {
  return limits;
}

double endurance_limit(AluminiumLayers layers) {
  return limits[layers == AluminiumLayers::one ? 0 : 1].stress;
}

double damage(AluminiumLayers layers, std::span<const StressCycles> spectrum) {
  double sum = 0;
  for (const StressCycles& s : spectrum) sum += s.cycles / cycles_endured(layers, s.stress);
  return sum;
}

}  // namespace strandyn::fatigue
