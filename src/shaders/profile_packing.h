#pragma once

#include <array>
#include <numbers>

#include "bssrdf/profile.h"
#include "shaders/shared/profile_data.h"

namespace opaline::shaders {

/// What lib/profile.glsl needs of the profiles of three channels, all of the same model.
inline shared::Profile packProfile(const std::array<bssrdf::Profile, 3>& channels) {
  shared::Profile packed{};
  for (int c = 0; c < 3; ++c) {
    const bssrdf::Profile& profile = channels[static_cast<std::size_t>(c)];
    const bool better = profile.model == bssrdf::Model::BetterDipole;
    const double zReal = profile.zRealMm;
    const double zVirtual = profile.zVirtualMm;
    const double albedo = profile.albedo / (4.0 * std::numbers::pi);
    const double flux = better ? albedo * profile.cE : albedo;
    packed.zRealSquared[c] = static_cast<float>(zReal * zReal);
    packed.zVirtualSquared[c] = static_cast<float>(zVirtual * zVirtual);
    packed.zSquaredDifference[c] = static_cast<float>((zVirtual - zReal) * (zVirtual + zReal));
    packed.sigmaTr[c] = static_cast<float>(profile.sigmaTrPerMm);
    packed.sigmaTrBase2[c] = static_cast<float>(profile.sigmaTrPerMm * std::numbers::log2e);
    packed.weightReal[c] = static_cast<float>(flux * zReal);
    packed.weightVirtual[c] = static_cast<float>(flux * zVirtual);
    packed.weightFluence[c] =
        better ? static_cast<float>(albedo * profile.cPhi / profile.diffusionMm) : 0.0F;
  }
  return packed;
}

}  // namespace opaline::shaders
