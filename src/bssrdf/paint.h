#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "opaline/medium.h"

namespace opaline::bssrdf {

/// Diffuse light at a boundary under an absorbing layer of optical thickness a, index matched to
/// the medium below. With the reflectance r(μ) = F e^{-2a/μ} and the transmittance t(μ) = (1 - F)
/// e^{-a/μ} from inside, their moments are 2C₁' = 2∫rμ, 3C₂' = 3∫rμ², T₁ = 2∫tμ and T₂ = 3∫tμ²; A'
/// = (1 + 3C₂')/(1 - 2C₁') and κ' = 2/(1 + 3C₂'). Of an irradiance E that passed the interface, the
/// share `entering` passes the layer as E' and drives a fluence φ with -D ∂φ/∂n = φ/2A' - κ'E'. The
/// exitance is φT₁/4 + T₂/2 (φ/2A' - κ'E').
struct PaintedBoundary {
  double thickness = 0;  ///< a
  double entering = 1;   ///< E'/E of diffuse light, T₁ over that without the layer
  double layer = 1;      ///< A/A'
  double leaving = 1;    ///< factor of φ/2A
  double takenOff = 0;   ///< factor of E: T₂κ'E'/2E
  double source = 0;     ///< κ'E'/E
  /// Diffusion lets too much light from sources at a depth out through a layer. This is a plane's
  /// exact share, which is nearly that of even light from outside, divided by that of diffusion.
  /// Depends on the medium; 1 except in a table.
  double deep = 1;
};

PaintedBoundary paintedBoundary(double eta, double thickness);

/// Optical thickness of a layer through which nothing is seen.
constexpr double thickestPaint = 8;

/// For each channel, n layers that give a thick body of the medium a colour in even light: number i
/// of 0 to n - 1 gives (i/(n-1))² times its colour without a layer.
std::array<std::vector<PaintedBoundary>, 3> paints(const Medium& medium, std::size_t n);

/// Colours in even light that layers of ascending thickness give a medium, in one channel.
struct LayerColors {
  std::vector<double> thick;  ///< of an infinitely thick body
  std::vector<double> ball;
};

std::array<LayerColors, 3> layerColors(const Medium& medium, double ballMm);

}  // namespace opaline::bssrdf
