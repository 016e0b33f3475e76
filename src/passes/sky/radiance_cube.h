#pragma once

#include "environment/sky.h"
#include "gpu/image.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// The sky's radiance by direction, for rays that each stand for a part of the sphere: a
/// small cube with levels (skyRadianceFrom() of lib/sky.glsl). For set-up and when the light
/// changes.
gpu::GpuImage makeRadianceCube(gpu::Device& device, const SkyParts& sky);

}  // namespace opaline::passes
