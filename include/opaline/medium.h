#pragma once

#include <array>
#include <string>

#include "opaline/export.h"
#include "opaline/types.h"

namespace opaline {

/// A homogeneous, highly scattering medium behind a smooth dielectric boundary, per colour channel.
struct Medium {
  std::string name;
  std::array<double, 3> sigmaSPrimePerMm{};  ///< reduced scattering σ_s', mm⁻¹, in (0, 1e6]
  std::array<double, 3> sigmaAPerMm{};       ///< absorption σ_a, mm⁻¹, in [0, 1e6]
  double eta = 1.3;                          ///< relative index of refraction, in [1.01, 3]
  /// Mean cosine of scattering, in [-0.99, 0.99]. The coefficients above are already reduced by it,
  /// so it only matters for light that scattered a few times. Boundary transport and path tracing
  /// use it; the dipoles use reduced coefficients alone.
  double g = 0;

  bool operator==(const Medium&) const = default;
};

/// Why the medium cannot be rendered, as a sentence; empty if it can.
OPALINE_API std::string complaintAbout(const Medium& medium);

/// What the colour of an Appearance means.
enum class ColorModel {
  Observed,  ///< as OpenPBR's subsurface_color: of the light that entered a thick body in even
             ///< light, the share that leaves again
  Khr,  ///< the multiple-scattering albedo of KHR_materials_volume_scatter, whose formula (Kulla
        ///< and Conty 2017) ignores internal reflection: bodies look darker than that
};

/// A medium described by its look.
struct Appearance {
  std::array<double, 3> color{0.8, 0.8, 0.8};     ///< as colorModel says, in [0, 1]
  std::array<double, 3> meanFreePathMm{1, 1, 1};  ///< 1/σ_t, in [1e-6, 1e6]
  double g = 0;                                   ///< mean cosine of scattering, in [-0.99, 0.99]
  double eta = 1.4;                               ///< in [1.01, 1.6]
  ColorModel colorModel = ColorModel::Observed;
  /// Diameter of the ball that has the observed color, in [0, 1e9]; 0: an infinitely thick body has
  /// it. Another convex body looks about like a ball with the same ratio of volume to surface.
  double ballMm = 0;

  bool operator==(const Appearance&) const = default;
};

/// Why no medium has this appearance, as a sentence; empty if one does.
OPALINE_API std::string complaintAbout(const Appearance& appearance);

/// The medium with this appearance. Observed colours are inverted by a fit to diffusion with a
/// Fresnel boundary, with an error of at most 0.003; those of a ball by diffusion in the ball.
OPALINE_API Medium mediumOf(const Appearance& appearance);

/// The inverse: the colour of a thick body of the medium in even light, by the same fit, which
/// holds for indices of refraction up to 1.6.
OPALINE_API Rgb colorOf(const Medium& medium);

}  // namespace opaline
