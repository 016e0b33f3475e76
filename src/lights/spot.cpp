#include "lights/spot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace opaline {

double SpotFalloff::operator()(double cosine) const {
  const double part = std::clamp(scale * cosine + offset, 0.0, 1.0);
  return part * part;
}

SpotFalloff falloffOf(const SpotLight& light) {
  constexpr double radians = std::numbers::pi / 180;
  const double inner = std::cos(double{light.innerDegrees} * radians);
  const double outer = std::cos(double{light.outerDegrees} * radians);
  const double scale = 1 / std::max(0.001, inner - outer);
  return {scale, -outer * scale};
}

}  // namespace opaline
