#pragma once

#include <optional>

#include "opaline/material.h"
#include "opaline/medium.h"

namespace opaline::scene {

/// Whether most of the light that it returns is reflected as by metal.
bool isMetal(const OpaqueMaterial& material);

/// Whether it lets some light through to the other side.
bool letsLightThrough(const OpaqueMaterial& material);

/// What a translucent object is made of.
struct Translucent {
  Medium medium;
  std::optional<Paint> paint;
  std::optional<TranslucentSurface> surface;
};

/// The parts of an opaque material that describe its surface, for a medium in its place. None if
/// nothing is said.
std::optional<TranslucentSurface> surfaceFrom(const OpaqueMaterial& material);

/// Gives an object, or a raw one, that medium alone. The surface keeps what its own material says.
template <typename AnyObject>
void putMedium(const Medium& medium, AnyObject& object) {
  if (object.opaque) object.surface = surfaceFrom(*object.opaque);
  object.paint.reset();
  object.opaque.reset();
  object.medium = medium;
}

/// A body with that appearance. A texture of colours, multiplied by the appearance's colour,
/// becomes the paint on a medium of the texture's brightest colours: in each channel as bright as
/// all but the brightest twentieth.
Translucent bodyOf(const Appearance& appearance, std::optional<Texture> colors);

/// The texture as paint on a medium, which is left bare where the texture is brightest.
Paint paintOn(const Medium& medium, Texture colors);

}  // namespace opaline::scene
