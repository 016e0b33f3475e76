#pragma once

#include "reference/geometry.h"
#include "reference/vector.h"

namespace opaline::reference {

/// What an opaque body is made of at a point: glTF 2.0, section 3.9 and appendix B, with
/// KHR_materials_ior, _specular, _emissive_strength, _diffuse_transmission and _unlit.
struct OpaqueSurface {
  Colour diffuse{};      ///< share of light reflected diffusely, mirrored light not subtracted
  Colour through{};      ///< the same of light that comes through from the other side
  Colour dielectric{};   ///< F₀ of the part that is not metal
  double grazing = 0;    ///< F₉₀ of that part
  Colour metal{};        ///< F₀ of metal
  double metallic = 0;   ///< share of the surface that is metal
  double alpha = 1;      ///< roughness²
  double occlusion = 1;  ///< factor on light not straight from a light
  Colour emission{};     ///< radiance
  bool unlit = false;    ///< radiance is `emission` under any light
};

/// The body must be opaque.
OpaqueSurface opaqueSurfaceAt(const Body& body, const SurfacePoint& point);

/// The share of even light that it returns in one channel, treated as if it were matt.
double mattShare(const OpaqueSurface& surface, std::size_t channel);

/// The share of light that it returns in a medium touching it. Only metal mirrors there, since no
/// boundary lies between the two.
double shareInMedium(const OpaqueSurface& surface, std::size_t channel);

/// Whether alpha is below the cutoff, so that the surface has a hole.
bool isCutOut(const Body& body, std::uint32_t triangle, const std::array<double, 3>& weights);

}  // namespace opaline::reference
