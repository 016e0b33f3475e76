#pragma once

#include "soft_body/cage.h"

namespace opaline::soft_body {

/// What a body is like, as SoftBodyOptions has it.
struct Character {
  double swingHz = 2.5;
  double settleSeconds = 1.5;
};

/// λ / μ of Lamé: Poisson's ratio is 3/7.
inline constexpr double lambdaOverMu = 6;

/// The constants of a substep. h is its length, a the edge of a cell, ρ the density.
struct Dynamics {
  double substepSeconds = 0;  ///< h
  double waveNumber = 0;      ///< μ h² / (ρ a²)
  double shear = 0;           ///< part of its way that a cell's shear goes back in a substep
  double compliance = 0;      ///< of its volume, in cells; see makeDynamics
  double anchor = 0;          ///< (ω h)² of the pull to rest
  double grip = 0;            ///< (ω h)² of the hold
  double follow = 0;          ///< part of its way that the hold goes to where it is pulled
  double damping = 1;         ///< what is left of a velocity
};

/// A body as stiff as a column of its height must be to sway in shear at that frequency, and the
/// longest substep at which one iteration has its forces exact.
Dynamics makeDynamics(const Cage& cage, const Character& character);

}  // namespace opaline::soft_body
