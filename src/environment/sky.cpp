#include "environment/sky.h"

namespace opaline {

bool skyIsDark(const Lighting& lighting) {
  return !lighting.environment && lighting.ambient == Rgb{0, 0, 0};
}

bool sameSky(const Lighting& a, const Lighting& b) {
  return a.ambient == b.ambient && a.environment == b.environment;
}

ShCoefficients projectSky(const Lighting& lighting) {
  ShCoefficients sum = projectUniform(lighting.ambient);
  if (!lighting.environment) return sum;
  const ShCoefficients environment = projectEnvironment(*lighting.environment);
  for (std::size_t i = 0; i < sum.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) sum[i][c] += environment[i][c];
  }
  return sum;
}

}  // namespace opaline
