#include "environment/sky_irradiance.h"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <utility>

#include "bssrdf/fresnel.h"

namespace opaline {

namespace {

constexpr std::size_t intervals = 1024;

}  // namespace

SkyIrradiance SkyIrradiance::arriving(SkyParts sky) {
  return {std::move(sky), [](double cosine) { return cosine; }, std::numbers::pi};
}

SkyIrradiance SkyIrradiance::entering(SkyParts sky, double eta) {
  return {std::move(sky),
          [eta](double cosine) { return (1 - bssrdf::fresnelReflectance(eta, cosine)) * cosine; },
          std::numbers::pi * bssrdf::meanTransmittance(eta)};
}

SkyIrradiance::SkyIrradiance(SkyParts sky, const std::function<double(double)>& weight,
                             double whole)
    : sky_(std::move(sky)), whole_(whole) {
  for (std::size_t i = 0; i <= intervals; ++i)
    weights_.push_back(static_cast<float>(weight(static_cast<double>(i) / intervals)));
  weights_.push_back(weights_.back());
}

float SkyIrradiance::weightOf(float cosine) const {
  const float place = cosine * static_cast<float>(intervals);
  const auto below = static_cast<std::size_t>(place);
  const float above = place - static_cast<float>(below);
  return weights_[below] + above * (weights_[below + 1] - weights_[below]);
}

std::array<double, 3> SkyIrradiance::at(const Vec3& normal) const {
  std::array<double, 3> sum{};
  double all = 0;
  for (const SkyParts::Part& part : sky_.parts) {
    const float cosine = part.direction[0] * normal[0] + part.direction[1] * normal[1] +
                         part.direction[2] * normal[2];
    if (cosine <= 0) continue;
    const auto weight = static_cast<double>(part.solidAngle * weightOf(std::min(cosine, 1.0F)));
    for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * double{part.radiance[c]};
    all += weight;
  }
  for (std::size_t c = 0; c < 3; ++c)
    sum[c] = whole_ * (double{sky_.ambient[c]} + (all > 0 ? sum[c] / all : 0));
  return sum;
}

}  // namespace opaline
