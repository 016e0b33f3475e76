#pragma once

#include <memory>

#include "core/rest_surface.h"
#include "gpu/command_list.h"
#include "opaline/renderer.h"
#include "paper/products.h"
#include "passes/products.h"
#include "shaders/shared/frame.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::paper {

/// Gong, Chen, Zhang, Zeng and Peng, GPU-based rendering for deformable translucent objects (The
/// Visual Computer 24, 2008): irradiance is gathered in a map of the surface laid flat, and
/// scattered from there by a pattern of few samples. All that only this method needs is behind this
/// class; the pipelines are made with it.
class Technique {
 public:
  explicit Technique(gpu::Device& device);
  ~Technique();
  Technique(const Technique&) = delete;
  Technique& operator=(const Technique&) = delete;

  /// For set-up, not for frames: depends on the surface at rest and the map's size, texels.
  static FlatScene layFlat(gpu::Device& device, const core::RestSurface& surface, int mapSize);

  /// For set-up, not for frames; blocks. Depends on the media too and, of the options, on
  /// transport, pattern and size of the picture.
  Map makeMap(gpu::Device& device, const RestScene& scene, FlatScene& flat,
              passes::DeformedMesh& mesh, const RenderOptions& options) const;

  /// What a frame takes from the scene, and what it makes.
  struct Frame {
    passes::FrameView& view;
    passes::DeformedMesh& mesh;
    passes::SceneTables& tables;
    passes::ShadowMaps& shadows;
    passes::Sky& sky;
    passes::VisibleSurfaces& surfaces;
    passes::Exitance& exitance;
    FlatScene& flat;
    Map& map;
  };

  /// Which part of the pattern is summed at the vertices.
  enum class VertexPart { FarSamples, Everything };

  /// Gathers irradiance in the map. If there are clusters, only that of the sky which those around
  /// see.
  void gather(gpu::CommandList& commands, const Frame& frame, passes::Clusters* occlusion) const;
  void scatterAtVertices(gpu::CommandList& commands, passes::ScatterTransport transport,
                         VertexPart part, const Frame& frame) const;
  /// Adds the near block to the far samples' part, for all surfaces that pixels see.
  void scatterAtFragments(gpu::CommandList& commands, passes::ScatterTransport transport,
                          const Frame& frame) const;
  /// The map's irradiance at the first surface of every pixel, in the first three channels.
  void showIrradiance(gpu::CommandList& commands, const Frame& frame,
                      gpu::GpuImage& irradiance) const;

 private:
  struct Passes;
  std::unique_ptr<const Passes> passes_;
};

}  // namespace opaline::paper
