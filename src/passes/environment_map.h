#pragma once

#include "gpu/image.h"
#include "opaline/image.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// A latitude-longitude environment with levels. It is scaled down if the device has no images that
/// large. For set-up.
gpu::GpuImage makeEnvironmentMap(gpu::Device& device, const Image& image);

}  // namespace opaline::passes
