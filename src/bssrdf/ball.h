#pragma once

namespace opaline::bssrdf {

/// The part of the fluence at a ball's surface that diffusion takes away, divided by that for a
/// half-space: coth x - 1/x, where x is the radius in diffusion lengths.
double takenByBall(double x);

/// Of even light that entered an unpainted ball, the share that leaves again. `thickColor` is that
/// share for a half-space of the same medium.
double colorOfBall(double thickColor, double eta, double x);

}  // namespace opaline::bssrdf
