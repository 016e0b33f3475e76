#pragma once

#include <memory>
#include <vector>

#include "opaline/log.h"
#include "renderer/scene/prepared_scene.h"

namespace opaline {

/// The scene on the device, once for all views that divide it alike. It stays as long as one of
/// them, and the one that a frame used last for the views to come.
class PreparedScenes {
 public:
  PreparedScenes(gpu::Device& device, Passes& passes, LogCallback log);

  /// For a frame of a view that has `present`, or none yet: that one if it fits its options, else
  /// one that another has and that does, else a new one.
  std::shared_ptr<PreparedScene> share(const RenderOptions& options, const FramePlan& plan,
                                       const Lighting& lighting,
                                       std::shared_ptr<PreparedScene> present);
  /// Another scene will be set.
  void clear();

 private:
  gpu::Device& device_;
  Passes& passes_;
  LogCallback log_;
  std::vector<std::weak_ptr<PreparedScene>> shared_;
  std::shared_ptr<PreparedScene> last_;
};

}  // namespace opaline
