#pragma once

namespace opaline::bssrdf {

/// What diffusion in a ball takes of the fluence at its surface, over what it takes in a body
/// without end: coth x - 1/x, of x radii over the diffusion length.
double takenByBall(double x);

/// The share of even light that entered a bare ball which leaves again, from that share of a body
/// without end of the same medium.
double colorOfBall(double thickColor, double eta, double x);

}  // namespace opaline::bssrdf
