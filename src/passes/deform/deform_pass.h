#pragma once

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "opaline/types.h"
#include "passes/products.h"
#include "shaders/deform/normals.comp.h"
#include "shaders/deform/replace.comp.h"
#include "shaders/deform/vertices.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Moves every vertex to its place in this frame by morph targets, skinning and deformers;
/// recomputes normals that do not follow; finds the box around all vertices.
class DeformPass {
 public:
  explicit DeformPass(gpu::Device& device);

  /// Copies a buffer of floats in which positions lie `stride` floats apart, from the float
  /// `offset` on, to where the frame reads given positions, for `count` vertices from `first` on.
  void replace(gpu::CommandList& commands, gpu::Buffer& given, std::uint32_t offset,
               std::uint32_t stride, std::uint32_t first, std::uint32_t count, const Vec3& originMm,
               Motion& motion) const;

  void record(gpu::CommandList& commands, Motion& motion, DeformedMesh& mesh) const;

 private:
  gpu::Compute<shaders::DeformReplace> replace_;
  gpu::Compute<shaders::DeformVertices> vertices_;
  gpu::Compute<shaders::DeformNormals> normals_;
};

}  // namespace opaline::passes
