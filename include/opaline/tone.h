#pragma once

#include <optional>

#include "opaline/export.h"
#include "opaline/image.h"
#include "opaline/types.h"

namespace opaline {

/// The curve from radiance to what a display can show.
enum class ToneCurve {
  None,     ///< clip at 1
  Neutral,  ///< Khronos PBR Neutral (Khronos Group 2024)
};

/// How radiance becomes colour.
struct ToneOptions {
  float exposureStops = 0;  ///< radiance is multiplied by 2^exposureStops, in [-32, 32]
  ToneCurve curve = ToneCurve::Neutral;
  std::optional<Rgb> background;  ///< linear, laid under the picture; none: alpha is coverage
};

/// Encodes sRGB by IEC 61966-2-1: linear in [0,1] to encoded in [0,1].
OPALINE_API float encodeSrgb(float linear);

/// The inverse: encoded in [0,1] to linear in [0,1].
OPALINE_API float decodeSrgb(float encoded);

/// Applies exposure and tone curve and encodes sRGB.
OPALINE_API Image8 toneMap(const Image& radiance, const ToneOptions& options = {});

}  // namespace opaline
