#pragma once

#include <cstdint>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "shaders/pattern.frag.h"
#include "shaders/pattern.vert.h"
#include "shaders/pattern_vertices.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::paper {

/// The paper's scattering (Gong et al. 2008, section 4; Eq. 8): exitance of visible fragments or of
/// vertices from the diffusion source map, by the pattern.
class PatternPass {
 public:
  explicit PatternPass(gpu::Device& device);

  /// Which part of the pattern is summed at the vertices.
  enum class VertexPart { FarSamples, Everything };

  void overVertices(gpu::CommandList& commands, passes::ScatterTransport transport, VertexPart part,
                    passes::SceneTables& tables, passes::DiffusionSources& sources,
                    passes::DeformedMesh& mesh, passes::Exitance& exitance) const;
  /// Adds the near block to the far samples' part, which has been interpolated: surface.exitance.
  void overFragments(gpu::CommandList& commands, passes::ScatterTransport transport,
                     passes::SceneTables& tables, passes::DiffusionSources& sources,
                     passes::VisibleSurface& surface, passes::Exitance& exitance) const;

 private:
  struct Pipelines {
    gpu::Graphics<shaders::PatternVert, shaders::PatternFrag> patternFragments;
    gpu::Compute<shaders::PatternVertices> patternFar;
    gpu::Compute<shaders::PatternVertices> patternVertices;
  };
  static Pipelines makePipelines(gpu::Device& device, passes::ScatterTransport transport);
  const Pipelines& pipelines(passes::ScatterTransport transport) const {
    return transport == passes::ScatterTransport::Dipole ? dipole_ : betterDipole_;
  }

  gpu::Sampler nearest_;
  gpu::Sampler linear_;
  Pipelines dipole_;
  Pipelines betterDipole_;
};

}  // namespace opaline::paper
