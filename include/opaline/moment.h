#pragma once

#include <cstddef>

#include "opaline/export.h"
#include "opaline/motion.h"
#include "opaline/scene.h"

namespace opaline {

/// The scene's camera where its clip has it at a time.
OPALINE_API Camera cameraAt(const Scene& scene, const SceneTime& time);

/// Whether a clip moves the camera.
OPALINE_API bool movesCamera(const Scene& scene, int clip);

/// The same of its lights.
OPALINE_API Lighting lightingAt(const Scene& scene, const SceneTime& time);

/// An object that somebody makes of something else follows no clip any more.
OPALINE_API void stopMaterial(Scene& scene, std::size_t object);

}  // namespace opaline
