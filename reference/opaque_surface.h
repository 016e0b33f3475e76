#pragma once

#include "reference/geometry.h"
#include "reference/vector.h"

namespace opaline::reference {

/// What an opaque body is made of at a point: glTF 2.0, section 3.9 and appendix B, with
/// KHR_materials_ior, _specular, _emissive_strength, _diffuse_transmission and _unlit.
struct OpaqueSurface {
  Colour diffuse{};      ///< share of light given back diffusely, less by what is mirrored
  Colour through{};      ///< share of light on the other side that leaves here diffusely, the same
  Colour dielectric{};   ///< F₀ of the part that is no metal
  double grazing = 0;    ///< F₉₀ of that part
  Colour metal{};        ///< F₀ of metal
  double metallic = 0;   ///< share that is metal
  double alpha = 1;      ///< roughness²
  double occlusion = 1;  ///< share of light that does not come straight from a light
  Colour emission{};     ///< radiance
  bool unlit = false;    ///< its radiance is `emission`, whatever the light
};

/// The body must be opaque.
OpaqueSurface opaqueSurfaceAt(const Body& body, const SurfacePoint& point);

/// All that it gives back of light from everywhere in one channel, as if it were matt.
double mattShare(const OpaqueSurface& surface, std::size_t channel);

/// What it gives back of light in a medium that it is in contact with: nothing lies between the two
/// that would mirror it, but for metal.
double shareInMedium(const OpaqueSurface& surface, std::size_t channel);

/// Whether alpha is less than its cutoff, so that there is no surface.
bool isCutOut(const Body& body, std::uint32_t triangle, const std::array<double, 3>& weights);

}  // namespace opaline::reference
