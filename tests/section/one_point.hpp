#pragma once
/// \file One section point of a planar law, for tests that walk along a path by hand.

#include "strandyn/section/law.hpp"

namespace strandyn::test {

struct PlanarStrain {
  double eps = 0;  ///< [-]
  double chi = 0;  ///< [1/m]
};

class OnePoint {
 public:
  struct Answer {
    double N = 0;
    double M = 0;
    double dM_dchi = 0;
    double dM_deps = 0;
    bool swept = false;
  };
  struct Loss {
    double stored = 0;
    double dissipated = 0;
    double quadrature_error = 0;
    bool swept = false;
  };

  OnePoint(const section::Law& law, PlanarStrain start) : law_(law), history_(law.start(field(start))) {}

  Answer respond(PlanarStrain to) const {
    using enum section::Component;
    section::Field stresses(section::Dimension::planar, 1);
    section::TangentField tangents(section::Dimension::planar, 1);
    const auto effort = law_.respond(history_, field(to), stresses, &tangents);
    return {.N = stresses[axial][0],
            .M = stresses[bending2][0],
            .dM_dchi = tangents(bending2, bending2)[0],
            .dM_deps = tangents(bending2, axial)[0],
            .swept = effort.sweeps == 1};
  }

  Loss commit(PlanarStrain to) {
    section::StepEnergy energy(1);
    const auto effort = law_.commit(history_, field(to), energy);
    return {.stored = energy.stored[0],
            .dissipated = energy.dissipated[0],
            .quadrature_error = energy.quadrature_error[0],
            .swept = effort.sweeps == 1};
  }

 private:
  static section::Field field(PlanarStrain strain) {
    section::Field f(section::Dimension::planar, 1);
    f[section::Component::axial][0] = strain.eps;
    f[section::Component::bending2][0] = strain.chi;
    return f;
  }

  const section::Law& law_;
  section::History history_;
};

}  // namespace strandyn::test
