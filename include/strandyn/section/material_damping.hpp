#pragma once
/// \file What the metal of the wires itself loses: Maxwell branches beside the section law, each a spring and a dashpot
/// in series along every strain of the section.
///
///     sigma' = E e' - sigma/tau                       one branch: stiffness E, relaxation time tau
///     E*(omega) = E i omega tau/(1 + i omega tau)     what it adds to the stiffness under a sine
///     D = pi chi^2 sum E omega tau/(1 + omega^2 tau^2)     its loss per cycle of a curvature amplitude chi
///
/// **Loss factor.** A metal loses nearly the same part of its energy at every frequency: eta = D/(pi E chi^2), E the
/// isothermal stiffness that the law has. Branches evenly apart in ln tau do so: with E_b = (2/pi) eta K d, d their
/// distance, the sum is eta K up to a ripple of 2/cosh(pi^2/d). The outermost ones stand for all that would follow
/// beyond, and are stronger by 1/(1 - exp(-d)). Six, 1.5 apart about sqrt(200) Hz, keep eta within 1 % from 1 to 200
/// Hz.
///
/// **Heat.** A bent wire warms where it is compressed and cools where it is stretched; the heat that flows across it is
/// lost (Zener 1937, Phys. Rev. 52, 230; 53, 90). For a round wire, to a good approximation one branch:
///     eta(omega) = Delta omega tau/(1 + omega^2 tau^2),   tau = d^2/(13.55 a_th),   Delta = E alpha^2 T/(rho c_p)
/// on the bending stiffness that a wire has about its own axis. It is there without any flaw of the metal: a floor.
///
/// **The stiffness that branches act on** is that of the section at rest, layer by layer: EA, GJ and EI of sticking
/// wires with the layers' own loss factors, whatever slips later. Where wires slip, friction takes a hundred times
/// more. Who builds them scales EI to what the law has at rest. The law `slip` has the wires' own bending only, and the
/// branches with it. The coupling of tension and torsion has none.
///
/// **A step** of h in which the strain goes evenly by de is exact,
///     sigma_1 = sigma_0 exp(-x) + E de (1 - exp(-x))/x,   x = h/tau
/// and so is the loss, the time integral of sigma^2/(E tau), never negative. What it exceeds the trapezoidal work by is
/// the step's quadrature error, of second order and of either sign.

#include <array>
#include <vector>

#include "strandyn/conductor/strand.hpp"
#include "strandyn/section/batch.hpp"

namespace strandyn::section {

/// [N] or [N m^2] per component, in the order of Component.
using ComponentStiffness = std::array<double, component_count>;

struct MaterialBranch {
  double relaxation_time = 0;  ///< [s]
  ComponentStiffness stiffness{};
};
using MaterialBranches = std::vector<MaterialBranch>;

/// The metal of a layer.
struct Metal {
  double loss_factor = 0;     ///< [-]
  double thermal_strain = 0;  ///< [1/K] of expansion; 0: no thermoelastic loss
  double heat_capacity = 0;   ///< [J/(m^3 K)] rho c_p
  double diffusivity = 0;     ///< [m^2/s]
};

/// What of a layer's stiffness counts: all that it has while its wires stick, or their own bending only.
enum class Wires { sticking, slipping };

/// What a section's metal loses, before it is made into branches.
struct MaterialLoss {
  ComponentStiffness constant{};  ///< sum of eta K: the same at every frequency
  MaterialBranches heat;          ///< one branch for each diameter and metal
};
/// Of a strand whose layer j is of metals[j], at `temperature` [K].
MaterialLoss material_loss(const conductor::Strand& strand, const std::vector<Metal>& metals, double temperature,
                           Wires wires);
/// Of one loss factor on a section that is not made of wires.
MaterialLoss material_loss(const ComponentStiffness& stiffness, double loss_factor);

/// [N] or [N m^2] a quarter ahead of the strain, by the loss factors themselves: D of a sine of amplitude e is pi e^2
/// times it. Branches reproduce it within 1 % from 1 to 200 Hz.
double loss_at(const MaterialLoss& loss, Component component, double omega);
MaterialBranches branches_of(const MaterialLoss& loss);

/// What the branches add to a stiffness at omega [rad/s]: in phase with the strain, and a quarter ahead of it. D of a
/// sine of amplitude e is pi loss e^2. [N] or [N m^2]
struct ComplexStiffness {
  double storage = 0, loss = 0;
};
ComplexStiffness stiffness_at(const MaterialBranches& branches, Component component, double omega);

/// The forces of all branches at all section points of a chain, as the last step left them.
class MaterialMemory {
 public:
  MaterialMemory() = default;
  MaterialMemory(MaterialBranches branches, Dimension dimension, std::size_t points);

  bool is_empty() const { return branches_.empty(); }
  /// Relaxed: after a long time at rest.
  void relax();
  /// Adds what the branches answer `step` seconds after `before`. Pure.
  void respond(const Field& before, const Field& strains, double step, Field& stresses, TangentField* tangents) const;
  /// Accepts `strains` as the end of a step, and tells its energies.
  void commit(const Field& before, const Field& strains, double step);

  /// [J/m] per section point: of the state, of the last step (>= 0), and its excess over the trapezoidal balance.
  const AlignedVector& stored() const { return stored_; }
  const AlignedVector& dissipated() const { return dissipated_; }
  const AlignedVector& quadrature_error() const { return quadrature_error_; }

  template <class Archive>
  void archive(Archive& a) {
    for (Field& forces : forces_) {
      for (std::size_t c = 0; c < component_count; ++c) a(forces[Component{c}]);
    }
    a(stored_, dissipated_, quadrature_error_);
  }

 private:
  MaterialBranches branches_;
  std::vector<Field> forces_;  // per branch
  AlignedVector stored_, dissipated_, quadrature_error_;
};

}  // namespace strandyn::section
