#pragma once

#include <optional>

#include "opaline/material.h"
#include "opaline/medium.h"

namespace opaline::scene {

/// Whether most of what it gives back is what metal reflects.
bool isMetal(const OpaqueMaterial& material);

/// Whether some light goes through it to its other side.
bool letsLightThrough(const OpaqueMaterial& material);

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

/// A body that looks like that, or as a texture of colours says, which the colour then multiplies:
/// it is the paint on a medium of the texture's brightest colours, in each channel all but the
/// brightest twentieth.
Translucent bodyOf(const Appearance& appearance, std::optional<Texture> colors);

/// The texture as paint on a medium that is bare where the texture has its brightest colours.
Paint paintOn(const Medium& medium, Texture colors);

}  // namespace opaline::scene
