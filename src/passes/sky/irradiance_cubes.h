#pragma once

#include <vector>

#include "environment/sky.h"
#include "gpu/image.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// The ambient cube map (Gong et al. 2008, section 3.2 and Figure 4b): irradiance that enters, by
/// surface normal, with one cube for each index of refraction. For set-up and when the light
/// changes.
gpu::GpuImage makeIrradianceCubes(gpu::Device& device, const SkyParts& sky,
                                  const std::vector<double>& etas);

}  // namespace opaline::passes
