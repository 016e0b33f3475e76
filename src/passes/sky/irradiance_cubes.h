#pragma once

#include <vector>

#include "environment/spherical_harmonics.h"
#include "gpu/image.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// The ambient cube map (Gong et al. 2008, section 3.2 and Figure 4b): irradiance that enters, by
/// surface normal, from spherical-harmonic radiance; one cube for each index of refraction.
/// For set-up and when the light changes.
gpu::GpuImage makeIrradianceCubes(gpu::Device& device, const ShCoefficients& radiance,
                                  const std::vector<double>& etas);

}  // namespace opaline::passes
