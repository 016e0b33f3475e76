#pragma once

#include "opaline/material.h"

namespace opaline::scene {

/// Whether most of what it gives back is what metal reflects.
bool isMetal(const OpaqueMaterial& material);

/// Mean of a picture of sRGB colours, linear.
Rgb meanColor(const TexturePixels& pixels);

}  // namespace opaline::scene
