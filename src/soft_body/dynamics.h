#pragma once

#include "soft_body/cage.h"

namespace opaline::soft_body {

/// λ / μ of Lamé: Poisson's ratio is 6/13.
inline constexpr double lambdaOverMu = 12;

/// The constants of a substep. h is its length, a the edge of a cell, ρ the density.
struct Dynamics {
  double substepSeconds = 0;  ///< h
  double waveNumber = 0;      ///< μ h² / (ρ a²)
  double shear = 0;           ///< as shared::SoftStep has it
  double compliance = 0;      ///< as shared::SoftStep has it
  double anchor = 0;          ///< (ω h)² of the pull to rest
  double grip = 0;            ///< (ω h)² of the hold
  double follow = 0;          ///< part of its way that the hold goes to where it is pulled
  double damping = 1;         ///< what is left of a velocity
};

/// A body as stiff as a column of its height must be to sway in shear at that frequency, and a
/// swing that falls to a twentieth in that time. The substep is the longest at which one iteration
/// has the forces of cells inside the body exact; at the surface, where there is less mass, a
/// cell's volume is softer.
Dynamics makeDynamics(const Cage& cage, double swingHz, double settleSeconds);

}  // namespace opaline::soft_body
