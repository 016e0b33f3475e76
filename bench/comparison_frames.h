#pragma once

#include <cstddef>
#include <memory>

#include "opaline/renderer.h"
#include "renderer/timing.h"

namespace opaline::bench {

/// Frames that the renderer itself does not render, of the internal passes put together otherwise.
class ComparisonFrames {
 public:
  ComparisonFrames(const Scene& scene, const RenderOptions& options);
  ~ComparisonFrames();

  /// Shadow, surface and Lambert's law.
  void renderOpaque(FrameTimes& times);
  /// The surface with the pattern summed in the vertex stage.
  void renderVertexStage(FrameTimes& times);
  /// Invocations of that stage if every corner is shaded once.
  std::size_t corners() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace opaline::bench
