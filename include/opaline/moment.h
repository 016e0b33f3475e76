#pragma once

#include <cstddef>

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

/// Removes the keys of an object's material from every clip, so that a new material stays as it is
/// set.
OPALINE_API void stopMaterial(Scene& scene, std::size_t object);

}  // namespace opaline
