#include "boundary/channel.h"

#include <cmath>

namespace opaline::test::boundary {

double reflectanceOutside(double eta, double cosine) {
  const double inner = std::sqrt(1 - (1 - cosine * cosine) / (eta * eta));
  const double across = (cosine - eta * inner) / (cosine + eta * inner);
  const double along = (eta * cosine - inner) / (eta * cosine + inner);
  return (across * across + along * along) / 2;
}

double reflectanceInside(double eta, double cosine) {
  const double squared = 1 - eta * eta * (1 - cosine * cosine);
  return squared <= 0 ? 1 : reflectanceOutside(eta, std::sqrt(squared));
}

Diffusion::Diffusion(const Channel& channel)
    : extinctionPerMm(channel.sigmaSPerMm + channel.sigmaAPerMm),
      albedo(channel.sigmaSPerMm / extinctionPerMm),
      diffusionMm((2 * channel.sigmaAPerMm + channel.sigmaSPerMm) /
                  (3 * extinctionPerMm * extinctionPerMm)),
      attenuationPerMm(std::sqrt(channel.sigmaAPerMm / diffusionMm)),
      eta(channel.eta) {
  constexpr int steps = 20000;
  double first = 0;
  double second = 0;
  double entering = 0;
  double slant = 0;
  for (int k = 0; k < steps; ++k) {
    const double cosine = (k + 0.5) / steps;
    const double inside = reflectanceInside(eta, cosine) * cosine / steps;
    first += 2 * inside;
    second += 3 * cosine * inside;
    const double outside = 2 * (1 - reflectanceOutside(eta, cosine)) * cosine / steps;
    entering += outside;
    slant += outside * std::sqrt(1 - (1 - cosine * cosine) / (eta * eta));
  }
  boundary = (1 + second) / (1 - first);
  meanTransmittance = entering;
  slantCosine = slant / entering;
}

}  // namespace opaline::test::boundary
