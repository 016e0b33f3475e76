#pragma once

#include <span>
#include <vector>

#include "boundary/channel.h"
#include "boundary/clusters.h"

namespace opaline::test::boundary {

/// How much of the light that leaves one cluster enters another: E' = entries · M. It depends only
/// on shape and index of refraction.
class Reentry {
 public:
  /// Counts every pair that sees each other, from start to start.
  static Reentry ofPairs(const reference::Geometry& geometry, const TriangleClusters& clusters,
                         const Diffusion& medium);
  /// Traces `rays` from every cluster, stratified by the cosine.
  static Reentry ofRays(const reference::Geometry& geometry, const TriangleClusters& clusters,
                        const Diffusion& medium, int rays);
  /// The same from places all over each cluster, about the facets' normals.
  static Reentry ofSpreadRays(const reference::Geometry& geometry, const TriangleClusters& clusters,
                              const Diffusion& medium, int rays);

  std::vector<double> entering(std::span<const double> exitance) const;
  std::size_t entries() const;

 private:
  struct Entry {
    std::uint32_t from;
    float factor;
  };
  std::vector<std::vector<Entry>> rows_;
};

}  // namespace opaline::test::boundary
