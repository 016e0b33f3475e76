#pragma once

#include <memory>
#include <vector>

#include "opaline/log.h"
#include "renderer/scene/prepared_scene.h"

namespace opaline {

/// The scene on the device, shared by all views that divide it in the same way. A prepared scene
/// lives as long as one of its views; the last one that a frame used is also kept for later views.
class PreparedScenes {
 public:
  PreparedScenes(gpu::Device& device, Passes& passes, LogCallback log);

  /// The prepared scene for a frame of a view that uses `present`, which may be null: `present` if
  /// it fits, else another view's that fits, else a new one.
  std::shared_ptr<PreparedScene> share(const RenderOptions& options, const FramePlan& plan,
                                       const EditedScene& edited,
                                       std::shared_ptr<PreparedScene> present);
  /// Drops everything, because another scene will be set.
  void clear();

 private:
  gpu::Device& device_;
  Passes& passes_;
  LogCallback log_;
  std::vector<std::weak_ptr<PreparedScene>> shared_;
  std::shared_ptr<PreparedScene> last_;
};

}  // namespace opaline
