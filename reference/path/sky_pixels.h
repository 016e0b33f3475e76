#pragma once

#include <vector>

#include "opaline/image.h"
#include "reference/path/random.h"
#include "reference/vector.h"

namespace opaline::reference {

/// Samples an environment whose pixels are uniform patches of sky. The density is proportional to
/// brightness by given weights of the channels.
class SkyPixels {
 public:
  /// The image must outlive it.
  SkyPixels(const Image& image, const Colour& weights);

  /// The integral of the weighted radiance over all directions.
  double sum() const { return sumsSoFar_.empty() ? 0 : sumsSoFar_.back(); }
  /// Samples a direction; the sum must be above 0.
  Vector direction(Random& random) const;
  /// The density of such directions, per steradian.
  double density(const Vector& direction) const;
  Colour radiance(const Vector& direction) const;

 private:
  std::size_t pixelAt(const Vector& direction) const;
  double solidAngle(int row) const;

  const Image& image_;
  std::vector<double> sumsSoFar_;  ///< up to each pixel
};

}  // namespace opaline::reference
