// A medium as the shaders see it. Included by C++ and GLSL.
#ifndef OPALINE_SHARED_MEDIUM_H
#define OPALINE_SHARED_MEDIUM_H

#include "profile_data.h"

#ifdef __cplusplus
#include <glm/vec4.hpp>
namespace opaline::shared {
using glm::uvec4;
using glm::vec4;
#endif

/// What diffusion in the body itself needs of a medium.
struct BoundaryMedium {
  vec4 diffusion;   // rgb: D, mm (Grosjean 1956); w: A = (1 + 3C₂) / (1 - 2C₁)
  vec4 sigma;       // rgb: √(σ_a / D), 1/mm; w: mean cosine inside of diffuse light that entered
  vec4 extinction;  // rgb: σ_t', 1/mm; w: mean transmittance of diffuse light, F̄_t
  vec4 albedo;      // rgb: α'; w: critical cosine √(1 - 1/η²)
  // For single collisions, without forward peaks (bssrdf::ScaledScattering).
  vec4 collision;  // rgb: σ_t*, 1/mm; w: mean cosine g*
  vec4 scatters;   // rgb: α*; w: share of diffuse light that a plane on the other side mirrors
                   // (bssrdf::mirroredOfEntered)
  vec4 reflected;  // rgb: share of the light that entered a half-space which leaves it
};

struct MediumData {
  Profile profile;
  BoundaryMedium inside;
  vec4 exits;  // two directions that stand for all in which light leaves (bssrdf::ExitDirections);
               // x, y: cosines inside; z, w: reflectances there
  vec4 boundary;  // x: η; y: radiance per exitance without F_t, 1/π or 1/(π F̄_t); z, w: plain lobe
                  // and 1 / stretch of the light that enters (lights/fresnel_lobes.h)
  uvec4 tables;   // x: cube of the sky's irradiance; y: index of its opaque material
                  // (shared/opaque.h); z: index of its paint plus 1, 0 without; w: first entry of
                  // the specular albedo
  uvec4 surface;  // x: 1 where its material gives its surface a roughness or normals of its own; y:
                  // first entry of the specular albedo for such roughnesses
};

#ifdef __cplusplus
}  // namespace opaline::shared
#endif

#endif
