#include "bssrdf/ball.h"

#include <cmath>

#include "bssrdf/fresnel.h"

namespace opaline::bssrdf {

// The fluence in the ball is sinh(κr)/r, with 1/κ the diffusion length.
double takenByBall(double x) {
  constexpr double small = 0.01;
  return x < small ? x / 3 : 1 / std::tanh(x) - 1 / x;
}

// Even light E that passed the interface drives a fluence φ by t φ = κE - φ/2A, where diffusion
// takes the part t of φ away. φ/2A - (κ - 1)E leaves (paint.h, without a layer).
double colorOfBall(double thickColor, double eta, double x) {
  const double overTwoA = (1 - twoC1(eta)) / (1 + threeC2(eta)) / 2;
  const double kappa = 2 / (1 + threeC2(eta));
  const double takenByThick = overTwoA * (kappa / (thickColor + kappa - 1) - 1);
  const double taken = takenByThick * takenByBall(x);
  return kappa * overTwoA / (taken + overTwoA) - (kappa - 1);
}

}  // namespace opaline::bssrdf
