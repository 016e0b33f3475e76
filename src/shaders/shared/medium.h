// A medium as the shaders see it. Included by C++ and GLSL.
#ifndef OPALINE_SHARED_MEDIUM_H
#define OPALINE_SHARED_MEDIUM_H

#include "profile_data.h"

#ifdef __cplusplus
#include <cstdint>
#include <glm/vec4.hpp>
namespace opaline::shared {
using glm::uvec4;
using glm::vec4;
#define OPALINE_PATTERN_CONSTANT constexpr std::uint32_t
#else
#define OPALINE_PATTERN_CONSTANT const uint
#endif

/// What diffusion in the body itself takes of a medium.
struct BoundaryMedium {
  vec4 diffusion;   // rgb: D, mm (Grosjean 1956); w: A = (1 + 3C₂) / (1 - 2C₁)
  vec4 sigma;       // rgb: √(σ_a / D), 1/mm; w: mean cosine inside of diffuse light that entered
  vec4 extinction;  // rgb: σ_t', 1/mm; w: mean transmittance of diffuse light, F̄_t
  vec4 albedo;      // rgb: α'; w: critical cosine √(1 - 1/η²)
};

struct MediumData {
  Profile profile;
  BoundaryMedium inside;
  vec4 boundary;  // x: η; y: radiance per exitance without F_t, 1/π or 1/(π F̄_t); z, w: mean square
                  // radius of the piece of surface that a near and a far sample stand for, mm²
  uvec4 tables;  // x: cube of the sky's irradiance; y: number of near samples; z: 0;
                 // w: first entry of the specular albedo
};

/// The pattern of Gong et al. 2008, Figure 5, as a list of entries. The first two are about the
/// centre: [0] rgb: reflectance of its cell, a: area of a texel in the rest pose, mm²; [1] rgb: its
/// logarithmic derivative by area, a: number of texels in the cell of a near sample. Then follow
/// the near samples, rgb: square of the part of its distance at which a sample's piece of surface
/// reflects as much as in the mean, a: its offset in texels, two signed 16-bit integers (x low, y
/// high) as a float's bits. The next entry is about the eight far samples, rgb: the same, a: number
/// of texels that one stands for.
struct PatternEntry {
  vec4 value;
};

/// A near block of 31² samples and the other entries: what every device reads as one uniform block.
OPALINE_PATTERN_CONSTANT maxPatternEntries = 31 * 31 + 2;

#ifdef __cplusplus
static_assert(sizeof(PatternEntry) * maxPatternEntries <= 16384);
}  // namespace opaline::shared
#endif

#endif
