#pragma once

#include <cstdint>
#include <optional>

#include "gpu/device.h"
#include "opaline/renderer.h"
#include "opaline/view.h"
#include "renderer/frame/frame.h"
#include "renderer/scene/edited_scene.h"
#include "renderer/scene/prepared_scenes.h"

namespace opaline {

/// What the views of a renderer share.
class RendererContext {
 public:
  explicit RendererContext(const RendererOptions& options);

  gpu::Device device;
  Passes passes;
  EditedScene edited;
  PreparedScenes prepared;
  std::optional<View> view;  ///< of Renderer::render
};

/// What a device says of itself.
DeviceDescription describe(const gpu::DeviceInfo& info);

}  // namespace opaline
