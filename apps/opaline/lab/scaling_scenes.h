#pragma once

#include "opaline/scene.h"

namespace opaline::app {

/// Divides every channel's σ_tr by `divisor` by reducing absorption; σ_s' stays.
Medium withSmallerSigmaTr(const Medium& medium, double divisor);

/// The same for all objects of a scene.
Scene withSmallerSigmaTr(Scene scene, double divisor);

/// The factor on all coefficients with which the renderer wants at least so many surfels of the
/// scene; 1 where it does already.
double densityFor(const Scene& scene, int surfels);

/// The scene with all coefficients multiplied.
Scene withDenserMedia(Scene scene, double factor);

}  // namespace opaline::app
