#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "shaders/scatter/cutout_surface.frag.h"
#include "shaders/scatter/cutout_surface.vert.h"
#include "shaders/scatter/listed_surfaces.comp.h"
#include "shaders/scatter/nearest_triangles.comp.h"
#include "shaders/scatter/seen.comp.h"
#include "shaders/scatter/seen_at_once.comp.h"
#include "shaders/scatter/seen_nearest.comp.h"
#include "shaders/scatter/surface.frag.h"
#include "shaders/scatter/surface.vert.h"
#include "shaders/scatter/surfaces.comp.h"
#include "shaders/scatter/visible_lights.frag.h"
#include "shaders/scatter/visible_lights.vert.h"
#include "shaders/shared/frame.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Finds what the camera sees: draws the triangles for every antialiasing sample, and lists the
/// surfaces that the samples of each pixel see. Only these get sums and shading.
class SurfacePass {
 public:
  explicit SurfacePass(gpu::Device& device);

  /// Throws Error if the picture is too large for the device.
  static VisibleSurfaces makeSurfaces(gpu::Device& device, VkExtent2D extent, std::uint32_t samples,
                                      KeptOfSeen kept);

  /// What a picture shows besides surfaces.
  struct Beside {
    bool backdrop = false;  ///< samples that see no surface show something
    bool lights = false;    ///< visible lights may hide surfaces; they need a backdrop, too
  };
  /// `samples`: offsets from the pixel's centre, pixels; several have to be those of
  /// shared::FrameData.
  void draw(gpu::CommandList& commands, const SeenSurfaces& seen, const CutOuts& cutOuts,
            std::span<const shared::vec2> samples, Beside beside) const;

  /// Lists the surfaces of the band that starts at `firstRow`, after draw() with as many samples.
  void list(gpu::CommandList& commands, const SeenSurfaces& seen, std::uint32_t firstRow,
            std::uint32_t samples) const;

  /// Clears the lists of Asked for a band that is already listed.
  static void askAnew(gpu::CommandList& commands, VisibleSurfaces& surfaces);

 private:
  void bindCutOut(gpu::CommandList& commands, const SeenSurfaces& seen, const CutOuts& cutOuts,
                  shared::vec2 jitter) const;

  void drawSample(gpu::CommandList& commands, const SeenSurfaces& seen, const CutOuts& cutOuts,
                  std::uint32_t sample, shared::vec2 place, bool visibleLights) const;
  void drawAtOnce(gpu::CommandList& commands, const SeenSurfaces& seen) const;
  void drawByInvocations(gpu::CommandList& commands, const SeenSurfaces& seen,
                         std::uint32_t samples) const;
  void bindSeen(gpu::CommandList& commands, const SeenSurfaces& seen, std::uint32_t firstRow,
                std::uint32_t samples) const;

  gpu::Sampler nearest_;
  gpu::Graphics<shaders::ScatterSurfaceVert, shaders::ScatterSurfaceFrag> triangles_;
  std::array<gpu::Graphics<shaders::ScatterSurfaceVert, shaders::ScatterSurfaceFrag>, 3>
      atOnce_;  // for 2, 4 and 8 samples
  gpu::Graphics<shaders::ScatterCutoutSurfaceVert, shaders::ScatterCutoutSurfaceFrag> cutOut_;
  gpu::Graphics<shaders::ScatterVisibleLightsVert, shaders::ScatterVisibleLightsFrag> lights_;
  gpu::Compute<shaders::ScatterSeen> seen_;
  gpu::Compute<shaders::ScatterSeenAtOnce> seenAtOnce_;
  gpu::Compute<shaders::ScatterNearestTriangles> nearestTriangles_;
  gpu::Compute<shaders::ScatterSeenNearest> seenNearest_;
  gpu::Compute<shaders::ScatterSurfaces> surfaces_;
  gpu::Compute<shaders::ScatterListedSurfaces> listed_;
};

/// Calls `record(firstRow)` for each band of the picture.
template <typename Record>
void forEachBand(const VisibleSurfaces& surfaces, const Record& record) {
  const std::uint32_t rows = surfaces.words.extent().height;
  for (std::uint32_t row = 0; row < rows; row += surfaces.rowsOfBand) record(row);
}

}  // namespace opaline::passes
