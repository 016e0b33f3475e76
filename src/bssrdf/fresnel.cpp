#include "bssrdf/fresnel.h"

#include <cassert>
#include <cmath>

namespace opaline::bssrdf {

namespace {

// Up to this the published fits have an error of at most 0.007. Beyond it they diverge: A turns
// negative at 2.9.
constexpr double largestEtaOfFits = 2.4;

/// 3∫ F μ² dμ inside, as an integral over the cosine outside, where it is smooth.
double threeC2Integrated(double eta) {
  constexpr int panels = 128;
  const auto integrand = [&](double mu) {
    const double inside = std::sqrt(1.0 - (1.0 - mu * mu) / (eta * eta));
    return (1.0 - fresnelReflectance(eta, mu)) * mu * inside;
  };
  // Simpson's rule.
  double sum = integrand(0.0) + integrand(1.0);
  for (int i = 1; i < 2 * panels; ++i)
    sum += (i % 2 == 1 ? 4.0 : 2.0) * integrand(i / (2.0 * panels));
  return 1.0 - 3.0 / (eta * eta) * sum / (6.0 * panels);
}

// The mean over diffuse light that entered of a function of the squared cosine outside and of F_t
// there, by the midpoint rule over μ².
template <typename Function>
double meanOfEntered(double eta, const Function& function) {
  assert(eta >= 1.0);
  constexpr int steps = 2048;
  double entering = 0;
  double weighted = 0;
  for (int i = 0; i < steps; ++i) {
    const double squared = (i + 0.5) / steps;
    const double transmitted = 1.0 - fresnelReflectance(eta, std::sqrt(squared));
    entering += transmitted;
    weighted += transmitted * function(squared, transmitted);
  }
  return weighted / entering;
}

}  // namespace

double fresnelReflectance(double eta, double cosTheta) {
  assert(eta > 0);
  if (eta == 1.0) return 0.0;
  const double cosSquaredInside = 1.0 - (1.0 - cosTheta * cosTheta) / (eta * eta);
  if (cosSquaredInside <= 0.0) return 1.0;
  const double cosInside = std::sqrt(cosSquaredInside);
  const double perpendicular = (cosTheta - eta * cosInside) / (cosTheta + eta * cosInside);
  const double parallel = (eta * cosTheta - cosInside) / (eta * cosTheta + cosInside);
  return 0.5 * (perpendicular * perpendicular + parallel * parallel);
}

double fresnelReflectanceInside(double eta, double cosTheta) {
  return fresnelReflectance(1.0 / eta, cosTheta);
}

// Walsh 1926, the closed form of the diffuse reflectance, as in Duntley 1942 and Egan and Hilgeman
// 1979.
double meanTransmittance(double eta) {
  assert(eta > 0);
  // Reciprocity: a diffuse field's mean transmittance falls by the factor that its radiance gains
  // inside.
  if (eta < 1.0) return meanTransmittance(1.0 / eta) * (eta * eta);
  // The terms below would cancel here; to first order the reflectance is (eta - 1)/3.
  const double excess = eta - 1.0;
  if (excess < 1e-6) return 1.0 - excess / 3.0;
  const double n = eta;
  const double n2 = n * n;
  const double n4 = n2 * n2;
  const double sum = n2 + 1.0;
  const double difference = excess * (n + 1.0);  // n² - 1
  const double product = sum * difference;       // n⁴ - 1
  const double reflectance =
      0.5 + excess * (3.0 * n + 1.0) / (6.0 * (n + 1.0) * (n + 1.0)) +
      n2 * difference * difference / (sum * sum * sum) * std::log(excess / (n + 1.0)) -
      2.0 * n2 * n * (n2 + 2.0 * n - 1.0) / (sum * product) +
      8.0 * n4 * (n4 + 1.0) / (sum * product * product) * std::log1p(excess);
  return 1.0 - reflectance;
}

double meanCosineInside(double eta) {
  return meanOfEntered(eta, [&](double squared, double /*transmitted*/) {
    return std::sqrt(1.0 - (1.0 - squared) / (eta * eta));
  });
}

double mirroredOfEntered(double eta) {
  constexpr double thickness = 0.3;
  const double collides = meanOfEntered(eta, [&](double squared, double transmitted) {
    const double cosine = std::sqrt(1.0 - (1.0 - squared) / (eta * eta));
    const double passes = std::exp(-thickness / cosine);
    return (1.0 - passes) / (1.0 - (1.0 - transmitted) * passes);
  });
  const double passes = std::exp(-thickness / meanCosineInside(eta));
  return (1.0 - (1.0 - passes) / collides) / passes;
}

double diffuseReflectanceInside(double eta) {
  return -1.440 / (eta * eta) + 0.710 / eta + 0.668 + 0.0636 * eta;
}

double twoC1(double eta) {
  assert(eta >= 1.0);
  if (eta > largestEtaOfFits) return 1.0 - meanTransmittance(eta) / (eta * eta);
  return -9.23372 +
         eta * (22.2272 + eta * (-20.9292 + eta * (10.2291 + eta * (-2.54396 + eta * 0.254913))));
}

double threeC2(double eta) {
  assert(eta >= 1.0);
  if (eta > largestEtaOfFits) return threeC2Integrated(eta);
  const double inverse = 1.0 / eta;
  return -1641.1 + inverse * (1376.53 + inverse * (-656.175 + inverse * 135.926)) +
         eta * (1213.67 + eta * (-568.556 + eta * (164.798 + eta * (-27.0181 + eta * 1.91826))));
}

}  // namespace opaline::bssrdf
