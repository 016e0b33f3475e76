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
  /// Mean cosine of scattering, in [-0.99, 0.99]. The coefficients are reduced by it, so it changes
  /// only what scattered a few times: boundary transport and path tracing follow that, half-spaces
  /// know reduced coefficients alone.
  double g = 0;

  bool operator==(const Medium&) const = default;
};

/// Why the medium cannot be rendered, as a sentence; empty if it can.
OPALINE_API std::string complaintAbout(const Medium& medium);

/// What the colour of an Appearance means.
enum class ColorModel {
  Observed,  ///< as OpenPBR's subsurface_color: the share of the light that entered which leaves
             ///< again, of a thick body in even light
  Khr,       ///< the multiple-scattering albedo of KHR_materials_volume_scatter, whose formula
             ///< (Kulla and Conty 2017) knows no reflection inside: bodies are seen darker
};

/// A medium by what is seen of it.
struct Appearance {
  std::array<double, 3> color{0.8, 0.8, 0.8};     ///< as colorModel says, in [0, 1]
  std::array<double, 3> meanFreePathMm{1, 1, 1};  ///< 1/σ_t, in [1e-6, 1e6]
  double g = 0;                                   ///< mean cosine of scattering, in [-0.99, 0.99]
  double eta = 1.4;                               ///< in [1.01, 1.6]
  ColorModel colorModel = ColorModel::Observed;
  /// Diameter of the ball that has the observed color; 0: of a body without end. In [0, 1e9]. Other
  /// convex bodies have about that of a ball with as much volume for its surface.
  double ballMm = 0;

  bool operator==(const Appearance&) const = default;
};

/// Why no medium looks like that, as a sentence; empty if one does.
OPALINE_API std::string complaintAbout(const Appearance& appearance);

/// The medium that looks like that. Observed colours are inverted by a fit to diffusion with
/// Fresnel's boundary, which is right within 0.003; those of a ball by diffusion in it.
OPALINE_API Medium mediumOf(const Appearance& appearance);

/// The other way: the colour that a thick body of the medium has in even light, by the same fit,
/// which knows indices of refraction up to 1.6.
OPALINE_API Rgb colorOf(const Medium& medium);

}  // namespace opaline
