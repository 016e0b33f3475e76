#include "lab/scaling_scenes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace opaline::app {

namespace {

/// The size of surfels, relative to the mean free path, where no budget binds. A triangle of that
/// size (surfels::spacingOfMm) has at most √3/2 of the area of the square, so there are at least as
/// many surfels as squares.
constexpr double sizeInFreePaths = 0.65;

double areaMm2(const Mesh& mesh) {
  double sum = 0;
  for (const Triangle& triangle : mesh.triangles) {
    const Vec3& a = mesh.positionsMm[triangle[0]];
    const Vec3& b = mesh.positionsMm[triangle[1]];
    const Vec3& c = mesh.positionsMm[triangle[2]];
    double u[3];
    double v[3];
    for (std::size_t i = 0; i < 3; ++i) {
      u[i] = double{b[i]} - double{a[i]};
      v[i] = double{c[i]} - double{a[i]};
    }
    sum += 0.5 * std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                            u[0] * v[1] - u[1] * v[0]);
  }
  return sum;
}

double mostExtinctionPerMm(const Medium& medium) {
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i)
    most = std::max(most, medium.sigmaSPrimePerMm[i] + medium.sigmaAPerMm[i]);
  return most;
}

}  // namespace

// σ_tr² = 3 σ_a (σ_a + σ_s'), solved for σ_a without subtracting nearly equal numbers.
Medium withSmallerSigmaTr(const Medium& medium, double divisor) {
  Medium result = medium;
  for (std::size_t i = 0; i < 3; ++i) {
    const double scattering = medium.sigmaSPrimePerMm[i];
    const double absorption = medium.sigmaAPerMm[i];
    const double wanted = absorption * (absorption + scattering) / (divisor * divisor);
    const double root = std::sqrt(scattering * scattering + 4 * wanted);
    result.sigmaAPerMm[i] = wanted > 0 ? 2 * wanted / (scattering + root) : 0;
  }
  return result;
}

Scene withSmallerSigmaTr(Scene scene, double divisor) {
  for (Object& object : scene.objects) object.medium = withSmallerSigmaTr(object.medium, divisor);
  return scene;
}

double densityFor(const Scene& scene, int surfels) {
  double there = 0;
  for (const Object& object : scene.objects) {
    const double perMm = mostExtinctionPerMm(object.medium) / sizeInFreePaths;
    there += areaMm2(object.mesh) * perMm * perMm;
  }
  return there > 0 ? std::max(1.0, std::sqrt(surfels / there)) : 1;
}

Scene withDenserMedia(Scene scene, double factor) {
  for (Object& object : scene.objects) {
    for (double& coefficient : object.medium.sigmaSPrimePerMm) coefficient *= factor;
    for (double& coefficient : object.medium.sigmaAPerMm) coefficient *= factor;
  }
  return scene;
}

}  // namespace opaline::app
