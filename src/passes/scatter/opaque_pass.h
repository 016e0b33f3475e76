#pragma once

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "shaders/boundary/cut_pieces.comp.h"
#include "shaders/boundary/opaque.comp.h"
#include "shaders/boundary/opaque_shares.comp.h"
#include "shaders/scatter/light_behind.comp.h"
#include "shaders/scatter/opaque_fragments.comp.h"
#include "shaders/scatter/opaque_vertices.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Light on opaque bodies, and what they give back of it. Places find what comes from lights with
/// shadow maps by themselves, and OpaqueLightsPass what comes from area lights; clusters find the
/// rest, and what they send to each other.
class OpaquePass {
 public:
  explicit OpaquePass(gpu::Device& device);

  struct Inputs {
    FrameView& frame;
    SceneTables& tables;
    ShadowMaps& shadows;
  };

  /// Takes pieces away where opaque bodies have holes. For set-up.
  void cutOut(gpu::Device& device, Surfels& surfels, OpaqueTables& opaque,
              SceneTables& tables) const;
  /// SceneTables::opaqueShares, once the rest of the tables is there; no more than what is bound
  /// all the same where there are not `any` opaque materials. For set-up.
  void makeShares(gpu::Device& device, DeformedMesh& mesh, Surfels& surfels, Clusters& clusters,
                  OpaqueTables& opaque, bool any, SceneTables& tables) const;
  /// The same again in a frame, where materials have changed.
  void recordShares(gpu::CommandList& commands, DeformedMesh& mesh, Surfels& surfels,
                    Clusters& clusters, OpaqueTables& opaque, SceneTables& tables) const;

  /// What clusters find: of lights and the sky, of what other clusters send, or of bounces that are
  /// not followed. As boundary/opaque.comp has it.
  enum class From { Lights, Clusters, FurtherBounces };
  void overClusters(gpu::CommandList& commands, const Inputs& inputs, From from, int bounces,
                    Clusters& clusters) const;
  /// Where the site is the vertices; none elsewhere.
  void overVertices(gpu::CommandList& commands, const Inputs& inputs, ScatterSite site,
                    const Places& vertices) const;
  /// And what the surfaces are made of.
  void overFragments(gpu::CommandList& commands, const Inputs& inputs, OpaqueTables& opaque,
                     ScatterSite site, const SeenSurfaces& seen) const;
  /// All light on the other side of what lets light through, but that of area lights.
  void behindFragments(gpu::CommandList& commands, const Inputs& inputs, Clusters& clusters,
                       const SeenSurfaces& seen) const;

 private:
  gpu::Sampler nearest_;
  gpu::Compute<shaders::BoundaryCutPieces> cutPieces_;
  gpu::Compute<shaders::BoundaryOpaqueShares> shares_;
  gpu::Compute<shaders::BoundaryOpaque> clusters_;
  gpu::Compute<shaders::ScatterOpaqueVertices> vertices_;
  gpu::Compute<shaders::ScatterOpaqueFragments> fragments_;
  gpu::Compute<shaders::ScatterLightBehind> behind_;
};

}  // namespace opaline::passes
