#pragma once
/// \file Four ways to the self-damping of one bench run, by the words of the standards.  [IEEE563] [IEC62567]
///
/// ledger:  friction, material and viscous loss of the measured cycles; still air and the numerical part stand beside.
///          By position: the losses of the sections and the viscous forces on the nodes, between two nodes of the
///          vibration.
/// The other ways see a whole vibration, as a laboratory does: they contain what the air takes.
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
  double friction = 0, material = 0, viscous = 0, air = 0;  ///< [J] per cycle
  double numerical = 0, quadrature_error = 0;               ///< [J] per cycle
  double power = 0;                                         ///< [W/m] friction, material and viscous
  double air_power = 0;                                     ///< [W/m]
  std::optional<double> numerical_share{};                  ///< [-] of all of these; nothing where there are none
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
  double ledger = 0;     ///< [W/m] the ledger by position, between the same nodes; without the air
  double air = 0;        ///< [W/m] of still air between them
};

struct DecayReading {
  std::vector<double> amplitudes{};  ///< [m] of the mode's coordinate, cycle by cycle
  double decrement = 0;              ///< [-] at the measured amplitude
  double modal_energy = 0;           ///< [J] measured
  double power = 0;                  ///< [W/m]
  double by_sine = 0;                ///< [W/m] with m L V^2/4
  double ledger = 0;                 ///< [W/m] the ledger of the decaying cycles at the same amplitude, air included
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
