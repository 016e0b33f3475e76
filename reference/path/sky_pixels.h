#pragma once

#include <vector>

#include "opaline/image.h"
#include "reference/path/random.h"
#include "reference/vector.h"

namespace opaline::reference {

/// An environment whose pixels are even patches of sky, for sampling: as dense as they are bright
/// by given weights of the channels.
class SkyPixels {
 public:
  /// The image must live as long.
  SkyPixels(const Image& image, const Colour& weights);

  /// The weighted radiance from all around, integrated.
  double sum() const { return sumsSoFar_.empty() ? 0 : sumsSoFar_.back(); }
  /// A direction; the sum must be above 0.
  Vector direction(Random& random) const;
  /// How dense directions are there, per steradian.
  double density(const Vector& direction) const;
  Colour radiance(const Vector& direction) const;

 private:
  std::size_t pixelAt(const Vector& direction) const;
  double solidAngle(int row) const;

  const Image& image_;
  std::vector<double> sumsSoFar_;  ///< up to each pixel
};

}  // namespace opaline::reference
