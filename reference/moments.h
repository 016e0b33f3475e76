#pragma once

#include <array>
#include <vector>

#include "reference/kernel.h"
#include "reference/vector.h"

namespace opaline::reference {

/// A piece of surface as a distant point sees it: moments about its centre of the flux that entered
/// it, ∫E dA, ∫E δ dA and so on to the third order, and what is needed to estimate the error of
/// using them.
struct Moments {
  struct Channel {
    double flux = 0;
    Vector first{};
    std::array<double, 6> second{};  ///< xx yy zz yz zx xy
    std::array<double, 10> third{};  ///< xxx xxy xxz xyy xyz xzz yyy yyz yzz zzz
    double fourth = 0;               ///< ∫|E||δ|⁴ dA, or a bound
    double smoothError = 0;          ///< of the flux: bound, from E's interpolation
    double borderVariance = 0;       ///< of the flux, where borders of shadow cross
  };

  Vector centre{};
  double radiusMm = 0;  ///< of the ball around the centre that holds the piece
  std::array<Channel, 3> channels{};

  bool isDark() const;
};

/// A point of a piece of surface with the flux it stands for.
struct FluxSample {
  Vector position{};
  Colour flux{};
};

/// About the samples' centroid, by flux; `corners` are what the piece's ball must hold.
template <std::size_t Count>
Moments momentsOf(const std::array<FluxSample, Count>& samples,
                  const std::array<Vector, 3>& corners);

/// Of several pieces together.
Moments joined(const Moments* first, std::size_t count);

/// What a piece contributes to the exitance at a point.
struct Contribution {
  Colour exitance{};
  Colour bound{};        ///< of the expansion's error
  Colour reflectance{};  ///< R_d at the piece's centre, mm⁻²
};

/// Whether a piece is small enough, beside its distance or the depth of the nearest source, for
/// contribution() to know its error.
bool isExpandable(const Moments& moments, const Vector& place, double depthMm);

/// By a Taylor expansion to third order about the centre, whose remainder is bounded by the fourth
/// derivatives: those at the centre, times what they can grow by over the piece.
Contribution contribution(const Moments& moments, const Vector& place,
                          const std::array<Kernel, 3>& kernels);

}  // namespace opaline::reference
