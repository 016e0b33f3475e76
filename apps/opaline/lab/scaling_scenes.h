#pragma once

#include "opaline/scene.h"

namespace opaline::app {

/// Every channel's σ_tr divided by `divisor` by taking away absorption; σ_s' stays as it is.
Medium withSmallerSigmaTr(const Medium& medium, double divisor);

/// The same for all objects of a scene.
Scene withSmallerSigmaTr(Scene scene, double divisor);

/// By what to multiply all coefficients so that the renderer wants at least so many surfels of the
/// scene; 1 where it does already.
double densityFor(const Scene& scene, int surfels);

/// The scene with all coefficients multiplied.
Scene withDenserMedia(Scene scene, double factor);

}  // namespace opaline::app
