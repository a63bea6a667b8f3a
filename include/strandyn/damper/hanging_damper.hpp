#pragma once
/// \file A Stockbridge damper on a span, in time: its clamp moves and turns with a node, its arms are chains.
///
/// Each arm is integrated from the last commit to the trial motion of the node by the trapezoidal rule, which takes no
/// energy of its own, with Newton's method to 1e-12 m. Its clamp is a held node that follows the node of the span; what
/// holds it is the force on the span. The span's matrix has what the clamp feels of the arms as of the last
/// factorization. The mass of the clamp belongs to the span.
///
/// An arm begins as a rigid body that moves with its clamp. The metal's loss counts at one frequency (arm_chain.hpp).
/// Weight is left out, as in damper.hpp; rotations are taken for small.

#include <vector>

#include "strandyn/damper/damper.hpp"
#include "strandyn/model/model.hpp"
#include "strandyn/system/attachment.hpp"

namespace strandyn::damper {

enum class Side { left, right };

struct HangingArm {
  Arm arm;
  Side side = Side::right;
};

struct HangingDamperOptions {
  std::size_t node = 0;      ///< of the span
  std::size_t elements = 6;  ///< of an arm
  double frequency = 0;      ///< [Hz] at which the metal of the messenger loses
};

/// On a chain in a plane. `span` must outlive it.
std::unique_ptr<system::Attachment> make_hanging_damper(const model::Model& span, const std::vector<HangingArm>& arms,
                                                        const Messenger& messenger,
                                                        const HangingDamperOptions& options);

}  // namespace strandyn::damper
