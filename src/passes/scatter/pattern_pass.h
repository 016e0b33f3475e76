#pragma once

#include <cstdint>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "shaders/scatter/pattern.frag.h"
#include "shaders/scatter/pattern.vert.h"
#include "shaders/scatter/pattern_vertices.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// The paper's scattering (Gong et al. 2008, section 4; Eq. 8): exitance of visible fragments or of
/// vertices from the diffusion source map, by the pattern.
class PatternPass {
 public:
  explicit PatternPass(gpu::Device& device);

  /// Which part of the pattern is summed at the vertices.
  enum class VertexPart { FarSamples, Everything };

  void overVertices(gpu::CommandList& commands, ScatterTransport transport, VertexPart part,
                    SceneTables& tables, DiffusionSources& sources, DeformedMesh& mesh,
                    Exitance& exitance) const;
  /// Adds the near block to the far samples' part, which has been interpolated: surface.exitance.
  void overFragments(gpu::CommandList& commands, ScatterTransport transport, SceneTables& tables,
                     DiffusionSources& sources, VisibleSurface& surface, Exitance& exitance) const;

 private:
  struct Pipelines {
    gpu::Graphics<shaders::ScatterPatternVert, shaders::ScatterPatternFrag> patternFragments;
    gpu::Compute<shaders::ScatterPatternVertices> patternFar;
    gpu::Compute<shaders::ScatterPatternVertices> patternVertices;
  };
  static Pipelines makePipelines(gpu::Device& device, ScatterTransport transport);
  const Pipelines& pipelines(ScatterTransport transport) const {
    return transport == ScatterTransport::Dipole ? dipole_ : betterDipole_;
  }

  gpu::Sampler nearest_;
  gpu::Sampler linear_;
  Pipelines dipole_;
  Pipelines betterDipole_;
};

}  // namespace opaline::passes
