#pragma once
/// \file What a vibration loses beside friction: the branches of the wires' metals, the air around the span.

#include <optional>

#include "strandyn/casefile/scene.hpp"
#include "strandyn/model/model.hpp"

namespace strandyn::build {

/// None where the scene gives no [material]. Handbook constants: aluminium 1350 expands by 23e-6/K, conducts 234 W/(m
/// K), holds 900 J/(kg K) at 2703 kg/m^3; carbon steel 11.5e-6/K, 50 W/(m K), 480 J/(kg K), 7780 kg/m^3. Wires of other
/// alloys count as one or the other, by Young's modulus.
section::MaterialBranches material_branches(const casefile::Scene& scene);

/// Nothing where the scene gives no [air], or one without density.
std::optional<model::Surroundings> surroundings(const casefile::Scene& scene);

}  // namespace strandyn::build
