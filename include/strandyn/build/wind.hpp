#pragma once
/// \file The wind of a scene: curve, wake and speed along the chain.

#include <optional>

#include "strandyn/casefile/scene.hpp"
#include "strandyn/model/model.hpp"

namespace strandyn::build {

const air::WindPowerCurve& curve_of(casefile::WindCurve curve);

/// Of the scene's [[wind]], for a chain that is laid out; nothing where there is none.
std::optional<model::Wind> wind_of(const casefile::Scene& scene, const model::Model& model);

/// [kg] of air that swings with each node of the chain; none where wakes have no part in it.
std::vector<model::Body> air_that_moves_along(const model::Model& model);

/// [Hz] at which vortices are shed, by the scene's speed of the wind, at the start; empty where it names a mode.
std::optional<double> shedding_frequency(const casefile::Scene& scene);

}  // namespace strandyn::build
