#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "opaline/export.h"
#include "opaline/motion.h"
#include "opaline/scene.h"

namespace opaline {

/// The scene's camera at a time of a clip. Here and below, the scene must be one that
/// Renderer::setScene accepts.
OPALINE_API Camera cameraAt(const Scene& scene, const SceneTime& time);

/// Whether a clip moves the camera.
OPALINE_API bool movesCamera(const Scene& scene, int clip);

/// The scene's lights at a time of a clip.
OPALINE_API Lighting lightingAt(const Scene& scene, const SceneTime& time);

/// Which materials clips change after edits: those that are as they are in a scene.
class OPALINE_API MaterialClips {
 public:
  MaterialClips() = default;
  explicit MaterialClips(const Scene& scene);
  /// To be called after an edit of an object's material. The scene's clips change it, or no longer
  /// do.
  void follow(std::size_t object, Scene& scene) const;

 private:
  std::vector<ClipChanges> changes_;
  std::map<std::size_t, Material> materials_;  // of objects that clips change
};

}  // namespace opaline
