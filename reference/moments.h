#pragma once

#include <array>
#include <vector>

#include "reference/kernel.h"
#include "reference/vector.h"

namespace opaline::reference {

/// What a distant point needs to know of a piece of surface: moments about the piece's centre of
/// the flux that entered it, ∫E dA, ∫E δ dA and so on to third order, and data to estimate the
/// error of using them.
struct Moments {
  struct Channel {
    double flux = 0;
    Vector first{};
    std::array<double, 6> second{};  ///< xx yy zz yz zx xy
    std::array<double, 10> third{};  ///< xxx xxy xxz xyy xyz xzz yyy yyz yzz zzz
    double fourth = 0;               ///< ∫|E||δ|⁴ dA, or a bound
    double smoothError = 0;          ///< bound on the flux's error by E's interpolation
    double borderVariance = 0;       ///< of the flux, in patches that borders of shadow cross
  };

  Vector centre{};
  double radiusMm = 0;  ///< of the ball around the centre that contains the piece
  std::array<Channel, 3> channels{};

  bool isDark() const;
};

/// A point of a piece of surface with the flux that it represents.
struct FluxSample {
  Vector position{};
  Colour flux{};
};

/// Moments about the flux-weighted centroid of the samples. The piece's ball contains `corners`.
template <std::size_t Count>
Moments momentsOf(const std::array<FluxSample, Count>& samples,
                  const std::array<Vector, 3>& corners);

/// The moments of several pieces together.
Moments joined(const Moments* first, std::size_t count);

/// What a piece contributes to the exitance at a point.
struct Contribution {
  Colour exitance{};
  Colour bound{};        ///< of the expansion's error
  Colour reflectance{};  ///< R_d at the piece's centre, mm⁻²
};

/// Whether a piece is so small, compared to its distance or the depth of the nearest source, that
/// contribution() can bound its error.
bool isExpandable(const Moments& moments, const Vector& place, double depthMm);

/// A Taylor expansion to third order about the centre. Its remainder is bounded by the fourth
/// derivatives at the centre, times the factor by which they can grow over the piece.
Contribution contribution(const Moments& moments, const Vector& place,
                          const std::array<Kernel, 3>& kernels);

}  // namespace opaline::reference
