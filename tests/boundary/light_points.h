#pragma once

#include <cstdint>
#include <vector>

#include "boundary/channel.h"
#include "boundary/clusters.h"

namespace opaline::test::boundary {

/// A place where light that entered through a cluster scatters, per unit of its flux.
struct LightPoint {
  Vector placeMm{};
  double weight = 0;
  double depthMm = 0;  ///< below the cluster's plane
  std::uint32_t cluster = 0;
  bool direct = false;  ///< not mirrored inside before
};

/// First collisions of light from one direction. Clusters that do not face it have none.
std::vector<LightPoint> firstCollisions(const reference::Geometry& geometry,
                                        const TriangleClusters& clusters, const Diffusion& medium,
                                        const Vector& directionToLight);

/// The same for diffuse light.
std::vector<LightPoint> firstCollisionsOfDiffuse(const reference::Geometry& geometry,
                                                 const TriangleClusters& clusters,
                                                 const Diffusion& medium);

/// The second collisions that follow first ones, without the albedo. None is direct.
std::vector<LightPoint> secondCollisions(const reference::Geometry& geometry,
                                         const std::vector<LightPoint>& first,
                                         const TriangleClusters& clusters, const Diffusion& medium,
                                         int directions = 4);

/// Light that leaves after one collision, as a share of a cluster's flux, without the albedo.
struct SingleExit {
  std::uint32_t from = 0;
  std::uint32_t at = 0;
  double share = 0;
};

/// Exits by rays from first collisions, each with its losses at the walls on its way.
std::vector<SingleExit> singleExits(const reference::Geometry& geometry,
                                    const std::vector<LightPoint>& first,
                                    const TriangleClusters& clusters, const Diffusion& medium,
                                    int directions = 4);

}  // namespace opaline::test::boundary
