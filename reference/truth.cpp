#include "reference/truth.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "reference/path/eye_paths.h"

namespace opaline::reference {

Transport transportOfIntegral(Transport transport) {
  return transport == Transport::Boundary ? Transport::Dipole : transport;
}

IntegralTruth integralTruth(const Geometry& geometry, const Irradiance& irradiance,
                            const IntegralOptions& integral, const PictureOptions& picture,
                            const PictureProgress& progress) {
  std::optional<Integral> exact;
  if (showsExitance(picture.aov) && seesMedia(geometry, picture))
    exact.emplace(geometry, irradiance, integral);
  const LeavingLight light{
      [&](const SurfacePoint& point) { return exact->at(point); },
      exitFactors(geometry.scene(), integral.transport),
      [&](const Look& look) { return directLightOf(geometry.scene(), irradiance, look); }};
  return {makePicture(geometry, irradiance, light, picture, progress),
          exact ? exact->patchCount() : 0};
}

namespace {

// The mean of many paths, with a random sequence for each look.
Exitance seenByPaths(const EyePaths& paths, const Look& look, int number, std::uint64_t seed) {
  constexpr std::uint64_t apartFromParticles = 0x5EED0FE7E;
  Random random(seed + apartFromParticles, look.number);
  Colour sum{};
  Colour squares{};
  for (int i = 0; i < number; ++i) {
    const Colour found = look.radiance ? paths.radiance(look.point, look.toEye, random)
                                       : paths.exitance(look.point, look.toEye, random);
    for (std::size_t c = 0; c < 3; ++c) {
      sum[c] += found[c];
      squares[c] += found[c] * found[c];
    }
  }
  Exitance seen;
  const auto count = static_cast<double>(number);
  for (std::size_t c = 0; c < 3; ++c) {
    const double mean = sum[c] / count;
    const double variance = std::max(squares[c] / count - mean * mean, 0.0) / count;
    seen.value[c] = mean;
    seen.error[c] = std::sqrt(variance);
  }
  return seen;
}

}  // namespace

Picture pathTruth(const PathTracer& tracer, const Geometry& geometry, const Irradiance& irradiance,
                  const PictureOptions& picture, const PictureProgress& progress) {
  const EyePaths paths(geometry, tracer, picture.eye);
  const int number =
      (picture.pathsOfPixel + picture.antialias - 1) / std::max(picture.antialias, 1);
  const int ofLook = picture.aov == Aov::Radiance ? number : picture.pathsOfPixel;
  const LeavingLight light{
      [&](const SurfacePoint& point) { return tracer.exitance(point); },
      exitFactors(geometry.scene(), Transport::BetterDipole),
      [&](const Look& look) { return seenByPaths(paths, look, ofLook, tracer.options().seed); },
      picture.eye.specular};
  return makePicture(geometry, irradiance, light, picture, progress);
}

PathLimits orUsual(const PathLimits& limits) {
  constexpr double usualError = 0.02;
  PathLimits result = limits;
  if (!limits.particles && !limits.seconds && !limits.error) result.error = usualError;
  return result;
}

double shareDone(const PathLimits& limits, std::uint64_t particles, double seconds, double error) {
  double share = 0;
  if (limits.particles)
    share =
        std::max(share, static_cast<double>(particles) / static_cast<double>(*limits.particles));
  if (limits.seconds) share = std::max(share, seconds / *limits.seconds);
  // The error falls with the square root of the work.
  if (limits.error) share = std::max(share, (*limits.error / error) * (*limits.error / error));
  return std::min(share, 1.0);
}

}  // namespace opaline::reference
