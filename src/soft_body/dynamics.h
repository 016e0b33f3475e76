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
  double follow = 0;          ///< part of the way to its goal that the hold moves
  double damping = 1;         ///< factor of velocities
};

/// Constants of a body whose stiffness lets a column of its height sway in shear at `swingHz`, and
/// whose swing decays to a twentieth in `settleSeconds`. The substep is the longest for which one
/// iteration computes the forces of cells inside the body exactly. At the surface, where there is
/// less mass, a cell's volume is softer.
Dynamics makeDynamics(const Cage& cage, double swingHz, double settleSeconds);

}  // namespace opaline::soft_body
