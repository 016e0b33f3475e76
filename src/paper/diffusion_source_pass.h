#pragma once

#include <cstdint>
#include <vector>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "paper/atlas/neighbourhood.h"
#include "paper/atlas/texel_area.h"
#include "paper/products.h"
#include "paper/shaders/shared/atlas.h"
#include "passes/products.h"
#include "shaders/cells.comp.h"
#include "shaders/coverage.frag.h"
#include "shaders/dsm.frag.h"
#include "shaders/dsm.vert.h"
#include "shaders/neighbours.comp.h"
#include "shaders/occlude.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::paper {

/// What the map takes from the atlas: how much of each texel is surface, and layouts with aprons
/// for the near and the far samples of the pattern.
struct AtlasMaps {
  std::vector<atlas::TexelArea> texelAreas;
  atlas::Neighbourhoods nearby;
  atlas::Neighbourhoods distant;     ///< its size is a multiple of cellEdge
  std::uint32_t distantMapSize = 0;  ///< edge of the atlas in the texels of `distant`, ≤ mapSize
  std::uint32_t cellEdge = 1;        ///< of the far samples' cells, in texels of `distant`
  std::vector<shared::FarPlace> farPlaces;  ///< eight per vertex
};

/// Gathers irradiance (Gong et al. 2008, section 3): draws the mesh into its atlas, in one pass
/// with three targets, and lays it out anew so that charts go on beyond their seams.
class DiffusionSourcePass {
 public:
  explicit DiffusionSourcePass(gpu::Device& device);

  /// Makes the map and finds out which texels carry surface; blocks. For set-up, not for frames: it
  /// depends on the atlas, not on the pose.
  DiffusionSources prepare(gpu::Device& device, passes::DeformedMesh& mesh, FlatScene& flat,
                           const AtlasMaps& maps) const;

  struct Inputs {
    passes::FrameView& frame;
    passes::DeformedMesh& mesh;
    passes::SceneTables& tables;
    passes::ShadowMaps& shadows;
    passes::Sky& sky;
    FlatScene& flat;
    passes::Clusters* occlusion;  ///< how much of the sky is seen; null: all of it
  };
  void record(gpu::CommandList& commands, const Inputs& inputs, DiffusionSources& sources) const;

 private:
  void recordMap(gpu::CommandList& commands, const Inputs& inputs, DiffusionSources& sources) const;
  void occlude(gpu::CommandList& commands, const Inputs& inputs, DiffusionSources& sources) const;
  void recordNeighbours(gpu::CommandList& commands, DiffusionSources& sources) const;

  gpu::Sampler nearest_;
  gpu::Sampler linear_;
  gpu::Graphics<shaders::DsmVert, shaders::CoverageFrag> coverage_;
  gpu::Graphics<shaders::DsmVert, shaders::DsmFrag> map_;
  gpu::Compute<shaders::Occlude> occlude_;
  gpu::Compute<shaders::Neighbours> neighbours_;
  gpu::Compute<shaders::Cells> cells_;
};

}  // namespace opaline::paper
