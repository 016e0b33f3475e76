#pragma once

#include <cstdint>

namespace opaline {

/// Counts that rise when something of a scene changes.
struct SceneChanges {
  std::uint64_t whole = 0;   ///< everything that a view uses on the device; see
                             ///< PreparedScene::changes
  std::uint64_t media = 0;   ///< media, or the division of the surface for them
  std::uint64_t sky = 0;     ///< see environment/sky.h
  std::uint64_t lights = 0;  ///< any light
  std::uint64_t pose = 0;    ///< where the vertices lie

  /// All changes except those of lights and sky.
  SceneChanges withoutLight() const { return {.whole = whole, .media = media, .pose = pose}; }

  bool operator==(const SceneChanges&) const = default;
};

}  // namespace opaline
