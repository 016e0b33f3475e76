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
  std::optional<TranslucentSurface> surface;
};

/// What an opaque material's textures say of the surface, for a medium in its place; none if they
/// say nothing.
std::optional<TranslucentSurface> surfaceFrom(const OpaqueMaterial& material);

/// Makes an object, or a raw one, of that medium alone. Its surface stays as its own material says.
template <typename AnyObject>
void putMedium(const Medium& medium, AnyObject& object) {
  if (object.opaque) object.surface = surfaceFrom(*object.opaque);
  object.paint.reset();
  object.opaque.reset();
  object.medium = medium;
}

/// Of a picture of sRGB colours, linear: in each channel as bright as all but the brightest
/// twentieth. That of a medium below a paint, which can only be darker.
Rgb brightColor(const TexturePixels& pixels);

}  // namespace opaline::scene
