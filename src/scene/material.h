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

/// A body that looks like that, or as a texture of colours says, which the colour then multiplies:
/// it is the paint on a medium of the texture's brightest colours, in each channel all but the
/// brightest twentieth.
Translucent bodyOf(const Appearance& appearance, std::optional<Texture> colors);

/// The texture as paint on a medium that is bare where the texture has its brightest colours.
Paint paintOn(const Medium& medium, Texture colors);

}  // namespace opaline::scene
