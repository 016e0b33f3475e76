#include "lab/truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace opaline::app {

namespace rf = opaline::reference;

Transport transportOfIntegral(Transport transport) {
  return transport == Transport::Boundary ? Transport::Dipole : transport;
}

IntegralTruth integralTruth(const rf::Geometry& geometry, const rf::Irradiance& irradiance,
                            const rf::IntegralOptions& integral, const rf::PictureOptions& picture,
                            const rf::PictureProgress& progress) {
  std::optional<rf::Integral> exact;
  if (rf::showsExitance(picture.aov)) exact.emplace(geometry, irradiance, integral);
  const rf::LeavingLight light{[&](const rf::SurfacePoint& point) { return exact->at(point); },
                               rf::exitFactors(geometry.scene(), integral.transport)};
  return {rf::makePicture(geometry, irradiance, light, picture, progress),
          exact ? exact->patchCount() : 0};
}

rf::Picture pathTruth(const rf::PathTracer& tracer, const rf::Geometry& geometry,
                      const rf::Irradiance& irradiance, const rf::PictureOptions& picture,
                      const rf::PictureProgress& progress) {
  const rf::LeavingLight light{
      [&](const rf::SurfacePoint& point) { return tracer.exitance(point); },
      rf::exitFactors(geometry.scene(), Transport::BetterDipole)};
  return rf::makePicture(geometry, irradiance, light, picture, progress);
}

void warnOfLostLight(const rf::PathTracer& tracer, const LogCallback& log) {
  // A closed mesh loses particles only where rounding lets one through an edge: some in a million.
  constexpr double most = 1e-3;
  const double lost = std::max({tracer.lostShare(0), tracer.lostShare(1), tracer.lostShare(2)});
  if (lost <= most) return;
  log(LogLevel::Warning, fmt::format("{:.2g} % of the light slipped through gaps of the surface "
                                     "and was lost; --path is correct for closed bodies only",
                                     100 * lost));
}

rf::PathLimits orUsual(const rf::PathLimits& limits) {
  constexpr double usualError = 0.02;
  rf::PathLimits result = limits;
  if (!limits.particles && !limits.seconds && !limits.error) result.error = usualError;
  return result;
}

double shareDone(const rf::PathLimits& limits, std::uint64_t particles, double seconds,
                 double error) {
  double share = 0;
  if (limits.particles)
    share =
        std::max(share, static_cast<double>(particles) / static_cast<double>(*limits.particles));
  if (limits.seconds) share = std::max(share, seconds / *limits.seconds);
  // Errors fall with the root of the work.
  if (limits.error) share = std::max(share, (*limits.error / error) * (*limits.error / error));
  return std::min(share, 1.0);
}

}  // namespace opaline::app
