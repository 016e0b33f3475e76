#pragma once

#include <optional>

#include "renderer/frame/frame_plan.h"
#include "renderer/scene/scene_changes.h"

namespace opaline {

/// Knows what the resources of a scene on the device hold of its shape: where everything lies in
/// the frame, what of the scene is seen from where, and what acts on what.
class ShapeReuse {
 public:
  /// Whether the next frame has to find it, or may `reuse` what is there. If it has to, it counts
  /// as found from now on.
  bool mustFind(const RenderOptions& options, const FramePlan& plan, bool reuse,
                const SceneChanges& changes);

 private:
  struct Shape {
    SceneChanges changes;  // but of lights
    Transport transport;
    float tolerance;
    bool clusters;
    bool rays;
    bool looksAround;
    bool solves;
    bool entersFromEverywhere;

    bool operator==(const Shape&) const = default;
  };
  std::optional<Shape> shape_;
};

}  // namespace opaline
