#pragma once

#include "core/rest_surface.h"
#include "paper/products.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::paper {

/// Makes an atlas of the surface for a map of that edge, texels, and puts it on the device.
FlatScene makeFlatScene(gpu::Device& device, const core::RestSurface& surface, int mapSize);

}  // namespace opaline::paper
