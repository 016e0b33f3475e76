#pragma once

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/light_through.h"
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

/// Light on opaque bodies, and the light that they reflect. Vertices and fragments find the light
/// of lights with shadow maps themselves, and OpaqueLightsPass that of area lights. Clusters find
/// the rest, and the light that they send to each other.
class OpaquePass {
 public:
  explicit OpaquePass(gpu::Device& device);

  struct Inputs {
    FrameView& frame;
    SceneTables& tables;
    ShadowMaps& shadows;
    BodiesBetween between;
  };

  /// Removes pieces where opaque bodies have holes. For set-up.
  void cutOut(gpu::Device& device, Surfels& surfels, OpaqueTables& opaque,
              SceneTables& tables) const;
  /// Makes SceneTables::opaqueShares once the other tables exist. Without `any` opaque materials,
  /// they are a minimal buffer that can be bound. For set-up.
  void makeShares(gpu::Device& device, DeformedMesh& mesh, Surfels& surfels, Clusters& clusters,
                  OpaqueTables& opaque, bool any, SceneTables& tables) const;
  /// Updates them in a frame in which materials have changed.
  void recordShares(gpu::CommandList& commands, DeformedMesh& mesh, Surfels& surfels,
                    Clusters& clusters, OpaqueTables& opaque, SceneTables& tables) const;

  /// The light that clusters find: from lights and sky, from other clusters, or from bounces that
  /// are not followed. See boundary/opaque.comp.
  enum class From { Lights, Clusters, FurtherBounces };
  void overClusters(gpu::CommandList& commands, const Inputs& inputs, From from, int bounces,
                    Clusters& clusters) const;
  /// Finds light at vertices of objects whose site they are; elsewhere it is 0.
  void overVertices(gpu::CommandList& commands, const Inputs& inputs, ScatterSite site,
                    const Places& vertices) const;
  /// Finds light at fragments, and the materials of their surfaces.
  void overFragments(gpu::CommandList& commands, const Inputs& inputs, OpaqueTables& opaque,
                     ScatterSite site, const SeenSurfaces& seen) const;
  /// Finds all light on the other side of surfaces that let light through, except that of area
  /// lights.
  void behindFragments(gpu::CommandList& commands, const Inputs& inputs,
                       const SeenSurfaces& seen) const;

 private:
  gpu::Sampler nearest_;
  gpu::Compute<shaders::BoundaryCutPieces> cutPieces_;
  gpu::Compute<shaders::BoundaryOpaqueShares> shares_;
  gpu::Compute<shaders::BoundaryOpaque> clusters_;
  ThroughVariants<shaders::ScatterOpaqueVertices> vertices_;
  ThroughVariants<shaders::ScatterOpaqueFragments> fragments_;
  ThroughVariants<shaders::ScatterLightBehind> behind_;
};

}  // namespace opaline::passes
