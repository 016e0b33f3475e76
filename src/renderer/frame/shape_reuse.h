#pragma once

#include <optional>

#include "renderer/frame/frame_plan.h"
#include "renderer/scene/scene_changes.h"

namespace opaline {

/// Knows for which frame the resources of a scene on the device hold its shape: where everything
/// lies, what clusters see, and which clusters act on which.
class ShapeReuse {
 public:
  /// Whether the next frame has to find the shape, or may `reuse` it. If it has to, the shape
  /// counts as found from now on.
  bool mustFind(const RenderOptions& options, const FramePlan& plan, bool reuse,
                const SceneChanges& changes);

 private:
  struct Shape {
    SceneChanges changes;  // except those of lights
    Transport transport;
    float tolerance;
    bool clusters;
    bool rays;
    bool looksAround;
    bool looksThrough;
    bool solves;
    bool entersFromEverywhere;

    bool operator==(const Shape&) const = default;
  };
  std::optional<Shape> shape_;
};

}  // namespace opaline
