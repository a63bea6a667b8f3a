#pragma once
/// \file The model of an arm: a clamped chain that moves across its line, the weight beside its last node.

#include "strandyn/damper/damper.hpp"
#include "strandyn/model/model.hpp"

namespace strandyn::damper {

/// The messenger's law must feel no axial strain (without_axial.hpp). `frequency` [Hz] is that at which its metal
/// loses; 0: it does not.
model::Model arm_model(const Arm& arm, const Messenger& messenger, std::size_t elements, double frequency);

}  // namespace strandyn::damper
