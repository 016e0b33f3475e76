#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "opaline/medium.h"

namespace opaline::bssrdf {

/// Diffuse light at a boundary under an absorbing layer of optical thickness a, index matched to
/// the medium below. With the reflectance r(μ) = F e^{-2a/μ} and the transmittance t(μ) = (1 - F)
/// e^{-a/μ} from inside, their moments 2C₁' = 2∫rμ, 3C₂' = 3∫rμ², T₁ = 2∫tμ, T₂ = 3∫tμ², and A' =
/// (1 + 3C₂')/(1 - 2C₁'), κ' = 2/(1 + 3C₂'), of an irradiance E that got through the interface, as
/// much as `entering` gets through the layer, to drive a fluence φ with -D ∂φ/∂n = φ/2A' - κ'E';
/// what leaves is φT₁/4 + T₂/2 (φ/2A' - κ'E').
struct PaintedBoundary {
  double thickness = 0;  ///< a
  double entering = 1;   ///< E'/E of diffuse light, T₁ over that without the layer
  double layer = 1;      ///< A/A'
  double leaving = 1;    ///< of φ/2A
  double takenOff = 0;   ///< of E: T₂κ'E'/2E
  double source = 0;     ///< κ'E'/E
  /// Of light from sources at a depth diffusion lets too much out through a layer: a plane's exact
  /// share, which is all but that of even light from outside, over that of diffusion. Depends on
  /// the medium, and is 1 but in a table.
  double deep = 1;
};

PaintedBoundary paintedBoundary(double eta, double thickness);

/// Through which nothing is seen.
constexpr double thickestPaint = 8;

/// The layers that give a thick body of the medium a colour in even light, for each channel: for
/// (i/(n-1))² times its colour without a layer, with i from 0 to n - 1.
std::array<std::vector<PaintedBoundary>, 3> paints(const Medium& medium, std::size_t n);

/// Colours in even light that layers of ascending thickness give a medium, in one channel.
struct LayerColors {
  std::vector<double> thick;  ///< of a body without end
  std::vector<double> ball;
};

std::array<LayerColors, 3> layerColors(const Medium& medium, double ballMm);

}  // namespace opaline::bssrdf
