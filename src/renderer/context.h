#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "gpu/device.h"
#include "opaline/error.h"
#include "opaline/renderer.h"
#include "opaline/view.h"
#include "renderer/frame/frame.h"
#include "renderer/scene/edited_scene.h"
#include "renderer/scene/prepared_scenes.h"

namespace opaline {

/// The implementation of a renderer, a view or a soft body. Throws UsageError for one that has been
/// moved from.
template <typename T>
T& present(const std::unique_ptr<T>& part, std::string_view whole) {
  if (!part) throw UsageError(fmt::format("this {} has been moved into another", whole));
  return *part;
}

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

/// The description of a device.
DeviceDescription describe(const gpu::DeviceInfo& info);

}  // namespace opaline
