#pragma once
/// \file What a conductor at its clamp endures, and how much of that a year of vibration takes.
///
/// CIGRE's safe border line, below nearly all fatigue tests on conductors in clamps [CIGRE1979]:
///     sigma = A N^B     sigma in MPa, amplitude (half of peak to peak), N cycles
///                       N <= 2e7: B = -0.2,  A = 450 (several layers of aluminium), 730 (one)
///                       N >  2e7: B = -0.17, A = 263,                               430
/// The two lines do not meet: at 2e7 they are 15.6 and 15.1 MPa. Between those, N is 2e7. sigma is the
/// Poffenberger-Swart stress of the bending amplitude (analysis/bending_amplitude.hpp), not a stress that a wire feels:
/// the line was drawn with it.
///
/// EPRI's endurance limits [EPRI2006], of the same stress: vibration below them is taken to do no harm.
///
/// Miner: D = sum n/N(sigma); a life is used up at D = 1.                                            [Miner1945]

#include <optional>
#include <span>
#include <string_view>

namespace strandyn::fatigue {

enum class AluminiumLayers { one, several };

/// N at a stress amplitude [Pa]; infinite at 0.
double cycles_endured(AluminiumLayers layers, double stress);
/// The stress amplitude [Pa] that is endured for so many cycles.
double stress_endured(AluminiumLayers layers, double cycles);

struct EnduranceLimit {
  std::string_view conductor;
  double stress = 0;  ///< [Pa] amplitude
};
std::span<const EnduranceLimit> endurance_limits();
/// [Pa] of ACSR.
double endurance_limit(AluminiumLayers layers);

/// So many cycles of a stress amplitude [Pa].
struct StressCycles {
  double stress = 0, cycles = 0;
};
/// D of Miner's rule [-].
double damage(AluminiumLayers layers, std::span<const StressCycles> spectrum);

}  // namespace strandyn::fatigue
