#pragma once

#include <cstdint>
#include <vector>

#include "opaline/scene.h"
#include "passes/products.h"
#include "renderer/scene/scene_resources.h"

namespace opaline::gpu {
class Device;
}

namespace opaline {

/// Where an object's part lies in the tables of all objects.
struct ObjectRange {
  std::uint32_t firstVertex = 0;
  std::uint32_t vertexCount = 0;
  std::uint32_t firstWeight = 0;  ///< first of its morph targets' weights
  std::uint32_t weightCount = 0;
  std::uint32_t firstMatrix = 0;  ///< first of its joints' matrices
  std::uint32_t matrixCount = 0;
  bool normalsFromMesh = false;  ///< even if its positions are not given
};

/// One range per object.
std::vector<ObjectRange> rangesOf(const Scene& scene);

/// The constant tables of passes::Motion; for set-up. The scene has been validated.
passes::Motion makeMotionTables(gpu::Device& device, const Scene& scene,
                                const scene::MergedMesh& merged,
                                const std::vector<ObjectRange>& ranges);

}  // namespace opaline
