#include "soft_body/dynamics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace opaline::soft_body {

namespace {

// Σ |∂C|² / mass of a cell's volume C = V/V₀ - 1 at rest, inside the body: in cells and cells'
// masses, three times 2² by its coefficients, and each corner has eight cells' shares of mass.
constexpr double gradient2AtRest = 12.0 / 8;

// The least compliance of the volume that is left after the softness of a single iteration is
// subtracted.
constexpr double leastCompliance = 0.5;

constexpr double leastSubstepsPerSecond = 400;

// Relative to the frequency of the swing.
constexpr double anchorFrequency = 0.15;
constexpr double gripFrequency = 10;
constexpr double mostGrip = 0.25;

constexpr double followSeconds = 0.03;

double squared(double x) {
  return x * x;
}

}  // namespace

Dynamics makeDynamics(const Cage& cage, double swingHz, double settleSeconds) {
  assert(swingHz > 0 && settleSeconds > 0);
  // Shear waves cross the height in a quarter of a period.
  const double waveSpeed = 4 * cage.heightCells * swingHz;  // cells / s
  const double mostWaveNumber = 1 / (lambdaOverMu * (gradient2AtRest + leastCompliance));
  const double substepsPerSecond =
      std::max(leastSubstepsPerSecond, std::ceil(waveSpeed / std::sqrt(mostWaveNumber)));
  Dynamics dynamics;
  dynamics.substepSeconds = 1 / substepsPerSecond;
  const double h = dynamics.substepSeconds;
  dynamics.waveNumber = squared(waveSpeed * h);
  dynamics.shear = 8 * dynamics.waveNumber;
  // XPBD's compliance α / h² is 1 / (k h²). A single iteration that starts from a multiplier of 0
  // makes the constraint softer, as if |∂C|² were added to the compliance (Macklin et al. 2016, Eq.
  // 18). It is subtracted here.
  dynamics.compliance = 1 / (lambdaOverMu * dynamics.waveNumber) - gradient2AtRest;
  const double swing = 2 * std::numbers::pi * swingHz * h;
  dynamics.anchor = squared(anchorFrequency * swing);
  dynamics.grip = std::min(squared(gripFrequency * swing), mostGrip);
  dynamics.follow = -std::expm1(-h / followSeconds);
  // A swing falls to a twentieth. Damping by mass reduces its height by half the rate of
  // velocities.
  dynamics.damping = std::exp(-2 * std::log(20.0) * h / settleSeconds);
  return dynamics;
}

}  // namespace opaline::soft_body
