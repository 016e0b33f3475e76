#pragma once

#include "opaline/scene.h"

namespace opaline {

/// How a spot light falls off with the cosine to its axis: (scale · cosine + offset)², where the
/// sum is clamped to [0, 1] before it is squared. KHR_lights_punctual, "Inner and Outer Cone
/// Angles".
struct SpotFalloff {
  double scale = 0;
  double offset = 1;

  double operator()(double cosine) const;
};

SpotFalloff falloffOf(const SpotLight& light);

}  // namespace opaline
