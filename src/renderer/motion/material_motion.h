#pragma once

#include <cstddef>
#include <vector>

#include "gpu/command_list.h"
#include "gpu/transfer.h"
#include "opaline/render_options.h"
#include "opaline/scene.h"
#include "passes/products.h"
#include "renderer/scene/scene_resources.h"
#include "renderer/scene/scene_tables.h"

namespace opaline {

/// Changes of materials by clips. The host evaluates them for every frame, and the tables on the
/// device follow. The scene and its resources outlive it.
class MaterialMotion {
 public:
  /// Whether any clip changes a material.
  static bool isNeeded(const Scene& scene);

  MaterialMotion(gpu::Device& device, const Scene& scene, const SceneResources& resources,
                 Transport transport, TablesOnHost onHost);

  /// Updates the tables to that time; allocates nothing.
  void record(gpu::CommandList& commands, const SceneTime& time, passes::OpaqueTables& opaque,
              passes::SceneTables& tables);

  bool changesOpaque() const { return !surfaces_.empty(); }

 private:
  struct Surface {
    std::size_t object;
    OpaqueMaterial now;  // only its numbers change
  };

  const Scene& scene_;
  const SceneResources& resources_;
  Transport transport_;
  std::vector<Surface> surfaces_;
  std::vector<std::size_t> bodies_;  // objects whose media change
  // What is uploaded for a frame.
  std::vector<shared::OpaqueData> materials_;
  TablesOnHost onHost_;
  gpu::UploadRing ring_;
};

}  // namespace opaline
