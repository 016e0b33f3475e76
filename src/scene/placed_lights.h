#pragma once

#include "opaline/scene.h"
#include "scene/matrix.h"

namespace opaline::scene {

/// Scales lights with their scene so that they light it as before: intensities grow with the square
/// of the factor, and area lights in size. False where a number leaves the range of a float.
[[nodiscard]] bool scaleLights(double factor, Lighting& lighting);

/// The same for lights that are placed with a model; none of them is an area light. They turn with
/// it, and intensities grow with its area.
[[nodiscard]] bool placeLights(const Matrix4& matrix, Lighting& lighting);

/// Scales or places a camera with what it sees. False where a number leaves the range of a float.
[[nodiscard]] bool scaleCamera(double factor, Camera& camera);
[[nodiscard]] bool placeCamera(const Matrix4& matrix, Camera& camera);

/// The same for the lights and cameras in clips.
[[nodiscard]] bool scaleChanges(double factor, std::vector<ClipChanges>& changes);
[[nodiscard]] bool placeChanges(const Matrix4& matrix, std::vector<ClipChanges>& changes);

}  // namespace opaline::scene
