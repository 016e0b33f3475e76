#pragma once

#include <cstddef>
#include <cstdint>

#include "opaline/log.h"
#include "opaline/renderer.h"
#include "reference/geometry.h"
#include "reference/integral.h"
#include "reference/irradiance.h"
#include "reference/path/path_run.h"
#include "reference/path/path_tracer.h"
#include "reference/picture.h"

namespace opaline::app {

/// There is an integral of half-spaces alone, so that boundary transport is judged by the dipole's.
Transport transportOfIntegral(Transport transport);

struct IntegralTruth {
  reference::Picture picture;
  std::size_t patches = 0;
};

/// The exact surface integral, where the variable needs it.
IntegralTruth integralTruth(const reference::Geometry& geometry,
                            const reference::Irradiance& irradiance,
                            const reference::IntegralOptions& integral,
                            const reference::PictureOptions& picture,
                            const reference::PictureProgress& progress);

/// What the particles followed so far show.
reference::Picture pathTruth(const reference::PathTracer& tracer,
                             const reference::Geometry& geometry,
                             const reference::Irradiance& irradiance,
                             const reference::PictureOptions& picture,
                             const reference::PictureProgress& progress = {});

/// Warns where so much light slipped through gaps of the surface that the truth is none.
void warnOfLostLight(const reference::PathTracer& tracer, const LogCallback& log);

/// The limits as they are, or the usual one where there is none.
reference::PathLimits orUsual(const reference::PathLimits& limits);

/// How much of the way to the nearest limit is done, in [0, 1].
double shareDone(const reference::PathLimits& limits, std::uint64_t particles, double seconds,
                 double error);

}  // namespace opaline::app
