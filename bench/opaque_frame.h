#pragma once

#include <memory>
#include <string>

#include "opaline/renderer.h"
#include "renderer/frame/timing.h"

namespace opaline::bench {

/// A frame of the same scene without translucency: the renderer's own shadow and surface passes,
/// then Lambert's law with the same shadow map.
class OpaqueFrame {
 public:
  /// `device`: as gpu::DeviceOptions::selector.
  OpaqueFrame(const Scene& scene, const RenderOptions& options, const std::string& device);
  ~OpaqueFrame();

  void render(double seconds, FrameTimes& times);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace opaline::bench
