#include "reference/truth.h"

#include <algorithm>
#include <optional>

namespace opaline::reference {

Transport transportOfIntegral(Transport transport) {
  return transport == Transport::Boundary ? Transport::Dipole : transport;
}

IntegralTruth integralTruth(const Geometry& geometry, const Irradiance& irradiance,
                            const IntegralOptions& integral, const PictureOptions& picture,
                            const PictureProgress& progress) {
  std::optional<Integral> exact;
  if (showsExitance(picture.aov)) exact.emplace(geometry, irradiance, integral);
  const LeavingLight light{[&](const SurfacePoint& point) { return exact->at(point); },
                           exitFactors(geometry.scene(), integral.transport)};
  return {makePicture(geometry, irradiance, light, picture, progress),
          exact ? exact->patchCount() : 0};
}

Picture pathTruth(const PathTracer& tracer, const Geometry& geometry, const Irradiance& irradiance,
                  const PictureOptions& picture, const PictureProgress& progress) {
  const LeavingLight light{[&](const SurfacePoint& point) { return tracer.exitance(point); },
                           exitFactors(geometry.scene(), Transport::BetterDipole)};
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
  // Errors fall with the root of the work.
  if (limits.error) share = std::max(share, (*limits.error / error) * (*limits.error / error));
  return std::min(share, 1.0);
}

}  // namespace opaline::reference
