#pragma once
/// \file How much longer a chord is than the unstressed length, without the loss of digits of a difference.
///
///     chord^2 - l0^2 = (span^2 - l0^2) + change . (2 span + change)
/// The first term is the same at every state, so that its rounding (1e-16 of l0, where a tension stretches by 1e-3)
/// takes no part in a vibration: what is left is 1e-16 of the stretch.

namespace strandyn::beam {

/// [m] chord - l0, where the chord is that of `span + change`.
template <class Vector>
double stretch_of(const Vector& span, const Vector& change, double l0, double chord) {
  return ((span.squaredNorm() - l0 * l0) + change.dot(2 * span + change)) / (chord + l0);
}

}  // namespace strandyn::beam
