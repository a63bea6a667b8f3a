#pragma once
/// \file What a vibration loses beside friction: the branches of the wires' metals, the air around the span.

#include <optional>

#include "strandyn/casefile/scene.hpp"
#include "strandyn/model/model.hpp"

namespace strandyn::build {

/// Nothing where the scene gives no [material]. Handbook constants: aluminium 1350 expands by 23e-6/K, conducts 234
/// W/(m K), holds 900 J/(kg K) at 2703 kg/m^3; carbon steel 11.5e-6/K, 50 W/(m K), 480 J/(kg K), 7780 kg/m^3. Wires of
/// other alloys count as one or the other, by Young's modulus.
///
/// The bending stiffness that loses is the one that the law has at rest under `tension` [N]: contacts that give are in
/// series with the wires, and what they store is stored in metal, too. So the loss factor of a section that does not
/// slip is that of its metals, whatever the law.
section::MaterialLoss material_loss(const casefile::Scene& scene, double tension);

/// Nothing where the scene gives no [air], or one without density.
std::optional<model::Surroundings> surroundings(const casefile::Scene& scene);

}  // namespace strandyn::build
