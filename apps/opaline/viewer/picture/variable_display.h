#pragma once

#include "opaline/image.h"
#include "opaline/renderer.h"
#include "opaline/tone.h"

namespace opaline::app::viewer {

/// The channels of Aov::Surfels.
enum class SurfelIndex { Surfel, Cluster, Node };

/// Whether a variable is light, so that exposure and tone curve apply to it.
bool isLight(Aov aov);

/// How the colours of other variables are shown: as they are, before the same background.
inline ToneOptions plainTone(const ToneOptions& tone) {
  return {0, ToneCurve::None, tone.background};
}

/// Shows a variable that is not light in colours between 0 and 1. Places are relative to their box,
/// directions are centred on grey, counts and lengths go from their least to their largest. Objects
/// and indices of surfels get distinct colours.
Image asColors(const Image& values, Aov aov, SurfelIndex surfelIndex);

}  // namespace opaline::app::viewer
