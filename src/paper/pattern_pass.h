#pragma once

#include "bssrdf/profile.h"
#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "paper/pattern_layout.h"
#include "paper/products.h"
#include "passes/products.h"
#include "shaders/pattern_fragments.comp.h"
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

  /// For set-up, not for frames.
  static PatternTable makeTable(gpu::Device& device, const RestScene& scene,
                                const PatternLayout& layout, double texelMm, bssrdf::Model model);

  struct Inputs {
    passes::SceneTables& tables;
    Map& map;
    passes::Exitance& exitance;  ///< the result
  };
  /// The far samples, and with `everything` the near block too.
  void overVertices(gpu::CommandList& commands, passes::ScatterTransport transport, bool everything,
                    const Inputs& inputs, FlatScene& flat, passes::DeformedMesh& mesh) const;
  /// Adds the near block to the far samples' part, which the vertices have.
  void overFragments(gpu::CommandList& commands, passes::ScatterTransport transport,
                     const Inputs& inputs, FlatScene& flat, const passes::SeenSurfaces& seen) const;

 private:
  struct Pipelines {
    gpu::Compute<shaders::PatternFragments> patternFragments;
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
