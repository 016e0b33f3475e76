#pragma once

#include <memory>

#include "opaline/renderer.h"
#include "renderer/timing.h"

namespace opaline::bench {

/// A frame of the same scene without translucency: the renderer's own shadow and surface passes,
/// then Lambert's law with the same shadow map.
class OpaqueFrame {
 public:
  OpaqueFrame(const Scene& scene, const RenderOptions& options);
  ~OpaqueFrame();

  void render(FrameTimes& times);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace opaline::bench
