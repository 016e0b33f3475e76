#pragma once

#include "gpu/image.h"
#include "opaline/image.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// An environment, latitude-longitude, with levels; smaller where the device has no images as
/// large. For set-up.
gpu::GpuImage makeEnvironmentMap(gpu::Device& device, const Image& image);

}  // namespace opaline::passes
