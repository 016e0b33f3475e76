#pragma once

#include "opaline/scene.h"

namespace opaline {

/// How a spot light falls off from its axis, by the cosine to that: (scale · cosine + offset)²,
/// clamped between 0 and 1. KHR_lights_punctual, "Inner and Outer Cone Angles".
struct SpotFalloff {
  double scale = 0;
  double offset = 1;

  double operator()(double cosine) const;
};

SpotFalloff falloffOf(const SpotLight& light);

}  // namespace opaline
