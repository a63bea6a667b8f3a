#pragma once
/// \file Four ways to the self-damping of one bench run, by the words of the standards.  [IEEE563] [IEC62567]
///
/// ledger:  friction and viscous loss of the measured cycles; the numerical part stands beside. By position: the
///          friction of the sections and the viscous forces on the nodes, between two nodes of the vibration.
/// power:   force times velocity of the shaker, from their fundamentals and as the work of whole cycles.
/// ISWR:    amplitudes at the first and the last node between shaker and far end, each over that of the antinode beside
///          it. The wave number k is that of the distance of the nodes, EI that of the fundamentals of moment and
///          curvature between them, Re(sum M chi*)/(sum |chi|^2); the tension that waves run under follows from both,
///          T = (m w^2 - EI k^4)/k^2: stretching adds to it, by 3/16 EA (k Y)^2 in a string.
/// decay:   the decrement of the mode's coordinate where it passes the measured amplitude, times twice the modal
/// energy. The standards take m L V^2/4 for it; measured is the kinetic energy of the
///          fundamental at its crest.

#include "strandyn/analysis/methods.hpp"
#include "strandyn/laboratory/test_bench.hpp"

namespace strandyn::laboratory {

struct LedgerReading {
  double friction = 0, viscous = 0, numerical = 0, quadrature_error = 0;  ///< [J] per cycle
  double power = 0;                                                       ///< [W/m] friction and viscous
  std::optional<double> numerical_share{};  ///< [-] of friction and viscous; nothing where there are none
};

struct PowerReading {
  double from_phasors = 0;  ///< [W/m]
  double from_work = 0;     ///< [W/m]
  double phase = 0;         ///< [rad] from the velocity to the force
};

struct IswrReading {
  analysis::NodePair nodes;
  double near_position = 0, far_position = 0;  ///< [m] from the left support
  int loops = 0;                               ///< between them
  analysis::WaveGuide guide;
  double power = 0;      ///< [W/m] between the nodes
  double by_string = 0;  ///< [W/m] the same with sqrt(T m) and the tension at rest, the form of the standards
  double ledger = 0;     ///< [W/m] the ledger by position, between the same nodes
};

struct DecayReading {
  std::vector<double> amplitudes{};  ///< [m] of the mode's coordinate, cycle by cycle
  double decrement = 0;              ///< [-] at the measured amplitude
  double modal_energy = 0;           ///< [J] measured
  double power = 0;                  ///< [W/m]
  double by_sine = 0;                ///< [W/m] with m L V^2/4
  double ledger = 0;                 ///< [W/m] the ledger of the decaying cycles at the same amplitude
};

struct Readings {
  double antinode_amplitude = 0;     ///< [m] mean of the measured cycles
  double fundamental_amplitude = 0;  ///< [m] of the largest antinode away from the ends, the fundamental alone
  LedgerReading ledger;
  PowerReading power;
  std::optional<IswrReading> iswr{};  ///< nothing below three loops on one side of the shaker
  std::optional<DecayReading> decay{};
};

Readings read_all(const BenchSpan& bench, const BenchRun& run);

}  // namespace strandyn::laboratory
