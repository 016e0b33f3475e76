#pragma once

#include "gpu/image.h"
#include "opaline/image.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// An environment of at most so many columns, latitude-longitude, with levels. A larger image is
/// reduced first. For set-up.
gpu::GpuImage makeEnvironmentMap(gpu::Device& device, const Image& image, int mostColumns);

}  // namespace opaline::passes
