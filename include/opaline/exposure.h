#pragma once

#include "opaline/scene.h"

namespace opaline {

/// The exposure, in stops, that suits a scene's light: what `opaline render` uses unless it is
/// given one. Images are linear and not scaled by it; multiply by 2^stops before a tone curve.
///
/// It follows from lights and sky alone, not from camera, media or time, so that it is the same for
/// all of a film. W is the radiance of a white diffuse surface that faces where most light comes
/// from, in its largest channel: from directional lights, from point lights at the middle of the
/// box around the scene at rest, no nearer than half its diagonal, and from ambient light and
/// environment in spherical harmonics of bands 0–2. Where W is ordinary, from ¼ to 2½, the exposure
/// is 0; beyond, it brings W to the nearer of these. In [-32, 32], in hundredths; 0 where nothing
/// shines.
float automaticExposureStops(const Scene& scene);

}  // namespace opaline
