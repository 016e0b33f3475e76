#pragma once

#include <vector>

#include "boundary/clusters.h"

namespace opaline::test::boundary {

/// Light of a directional lamp of irradiance 1 at the surface of a body, by its triangles. Each is
/// wholly in shadow or in light, with the cosine of its own normal.
struct LightEntering {
  std::vector<double> irradiance;  ///< per cluster
  /// The clusters moved to where light enters them: centroid, normal and start are those of the lit
  /// part.
  TriangleClusters places;
  /// Irradiance of light that enters after being mirrored on the outside, at any cosine.
  std::vector<double> mirrored;
};

LightEntering lightEntering(const reference::Geometry& geometry, const TriangleClusters& clusters,
                            double eta, const Vector& directionToLight);

}  // namespace opaline::test::boundary
