#pragma once

#include <cstdint>
#include <vector>

#include "atlas/atlas.h"
#include "opaline/renderer.h"
#include "opaline/scene.h"
#include "passes/products.h"

namespace opaline::gpu {
class Device;
}

namespace opaline {

/// All objects laid end to end.
struct MergedMesh {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> objectOfTriangle;

  atlas::Surface surface() const;
};

/// A scene on the device: what depends on the rest pose alone. Objects are laid end to end and
/// share one atlas.
struct SceneResources {
  passes::DeformedMesh mesh;
  MergedMesh merged;
  atlas::Atlas atlas;
  std::uint32_t objects = 0;
  std::uint32_t triangles = 0;
  std::vector<Medium> media;  ///< the different ones
  std::vector<std::uint32_t> mediumOfObject;
  std::vector<double> meanEdgeOfObjectMm;
  std::vector<double> areaOfObjectMm2;
};

SceneResources makeSceneResources(gpu::Device& device, const Scene& scene, int dsmSize);

/// Shortest mean free path of the three channels, mm.
double shortestMeanFreePathMm(const Medium& medium);

}  // namespace opaline
