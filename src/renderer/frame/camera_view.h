#pragma once

#include <span>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "opaline/scene.h"
#include "shaders/shared/frame.h"

namespace opaline {

/// A camera as the shaders need it.
struct CameraView {
  glm::mat4 worldToClip{1};  ///< reversed depth, no far plane, y down as in Vulkan
  glm::vec3 position{0};
  glm::vec3 axis{0, 0, -1};  ///< unit, towards the scene
  bool isParallel = false;   ///< orthographic

  bool operator==(const CameraView&) const = default;
};

/// With a near plane of 1 mm; passes::FitPass moves it. For an orthographic camera, worldToClip has
/// the place of the camera along its axis instead of depth.
CameraView makeCameraView(const Camera& camera, float aspect);

/// Offsets of the antialiasing samples from the pixel's centre, in pixels: the standard patterns of
/// Direct3D for 1, 2, 4 and 8 samples.
std::span<const glm::vec2> samplePattern(int samples);

/// Sets the frame's sample pattern; 0 samples count as one.
void fillSamples(int samples, shared::FrameData& frame);

}  // namespace opaline
