#pragma once

#include <optional>

#include "opaline/material.h"
#include "opaline/medium.h"

namespace opaline::scene {

/// Whether most of what it gives back is what metal reflects.
bool isMetal(const OpaqueMaterial& material);

/// What a translucent object is made of.
struct Translucent {
  Medium medium;
  std::optional<Paint> paint;
};

/// Of a picture of sRGB colours, linear: in each channel as bright as all but the brightest
/// twentieth. That of a medium below a paint, which can only be darker.
Rgb brightColor(const TexturePixels& pixels);

}  // namespace opaline::scene
