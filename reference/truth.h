#pragma once

#include <cstddef>
#include <cstdint>

#include "opaline/renderer.h"
#include "reference/geometry.h"
#include "reference/integral.h"
#include "reference/irradiance.h"
#include "reference/path/path_run.h"
#include "reference/path/path_tracer.h"
#include "reference/picture.h"

namespace opaline::reference {

/// Only half-spaces have an integral, so boundary transport is judged by the dipole's.
Transport transportOfIntegral(Transport transport);

struct IntegralTruth {
  Picture picture;
  std::size_t patches = 0;
};

/// A picture by the exact surface integral, where the variable needs it.
IntegralTruth integralTruth(const Geometry& geometry, const Irradiance& irradiance,
                            const IntegralOptions& integral, const PictureOptions& picture,
                            const PictureProgress& progress);

/// The picture that the particles traced so far show.
Picture pathTruth(const PathTracer& tracer, const Geometry& geometry, const Irradiance& irradiance,
                  const PictureOptions& picture, const PictureProgress& progress = {});

/// The limits themselves, or the default one if none is set.
PathLimits orUsual(const PathLimits& limits);

/// The share of the way to the nearest limit, in [0, 1].
double shareDone(const PathLimits& limits, std::uint64_t particles, double seconds, double error);

}  // namespace opaline::reference
