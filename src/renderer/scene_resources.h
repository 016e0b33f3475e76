#pragma once

#include <cstdint>
#include <vector>

#include "atlas/atlas.h"
#include "opaline/renderer.h"
#include "opaline/scene.h"
#include "passes/products.h"
#include "scene/merged_mesh.h"

namespace opaline::gpu {
class Device;
}

namespace opaline {

/// As the atlas wants it; `merged` outlives it.
atlas::Surface surfaceOf(const scene::MergedMesh& merged);

/// A scene on the device: what depends on the rest pose alone. Objects are laid end to end and
/// share one atlas.
struct SceneResources {
  const scene::MergedMesh* merged = nullptr;  ///< that it was made from
  passes::DeformedMesh mesh;
  atlas::Atlas atlas;
  std::uint32_t objects = 0;
  std::uint32_t triangles = 0;
  std::vector<Medium> media;  ///< the different ones
  std::vector<std::uint32_t> mediumOfObject;
  std::vector<double> meanEdgeOfObjectMm;
  std::vector<double> areaOfObjectMm2;
};

/// `merged` is of the scene and outlives the resources.
SceneResources makeSceneResources(gpu::Device& device, const Scene& scene,
                                  const scene::MergedMesh& merged, int dsmSize);

/// Shortest mean free path of the three channels, mm.
double shortestMeanFreePathMm(const Medium& medium);

}  // namespace opaline
