#pragma once

#include "opaline/export.h"
#include "opaline/scene.h"

namespace opaline {

/// The exposure, in stops, that suits a scene's light; `opaline render` uses it by default. Images
/// are linear and not scaled by it: multiply by 2^stops before a tone curve.
///
/// It depends only on lights and environment, not on camera, media or time, so a film has one
/// exposure. W is the radiance of a white diffuse surface that faces most of the light, in its
/// largest channel. W counts directional lights; point lights as seen from the middle of the box
/// around the scene at rest, but no nearer than half its diagonal; and ambient light and
/// environment in spherical harmonics of bands 0–2. If W is from ¼ to 2½, the exposure is 0.
/// Otherwise it brings W to the nearer of these. In [-32, 32], in hundredths; 0 without light.
OPALINE_API float automaticExposureStops(const Scene& scene);

}  // namespace opaline
