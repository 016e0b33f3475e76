#pragma once

#include "opaline/scene.h"
#include "scene/matrix.h"

namespace opaline::scene {

/// Lights that are scaled with their scene shine on it as before: intensities grow with the square,
/// and area lights with it.
/// False where something of a light leaves the range of a float.
[[nodiscard]] bool scaleLights(double factor, Lighting& lighting);

/// The same for lights that are placed with a model, none of which has an extent. They turn, and
/// intensities grow with its area.
[[nodiscard]] bool placeLights(const Matrix4& matrix, Lighting& lighting);

/// A camera that is scaled or placed with what it sees, false where it leaves the range of a float.
[[nodiscard]] bool scaleCamera(double factor, Camera& camera);
[[nodiscard]] bool placeCamera(const Matrix4& matrix, Camera& camera);

/// The same of what clips make of lights and cameras.
[[nodiscard]] bool scaleChanges(double factor, std::vector<ClipChanges>& changes);
[[nodiscard]] bool placeChanges(const Matrix4& matrix, std::vector<ClipChanges>& changes);

}  // namespace opaline::scene
