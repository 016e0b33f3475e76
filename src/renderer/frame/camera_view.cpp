#include "renderer/frame/camera_view.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace opaline {

namespace {

// A direction that is not along the axis.
glm::vec3 usableUp(const glm::vec3& wanted, const glm::vec3& axis) {
  const glm::vec3 across = glm::cross(axis, wanted);
  if (glm::dot(across, across) > 1e-8F * std::max(glm::dot(wanted, wanted), 1e-20F)) return wanted;
  return std::abs(axis.z) < 0.9F ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0);
}

}  // namespace

CameraView makeCameraView(const Camera& camera, float aspect) {
  CameraView view;
  view.position = glm::make_vec3(camera.positionMm.data());
  const glm::vec3 target = glm::make_vec3(camera.targetMm.data());
  view.axis = glm::normalize(target - view.position);
  const glm::vec3 right =
      glm::normalize(glm::cross(view.axis, usableUp(glm::make_vec3(camera.up.data()), view.axis)));
  const glm::vec3 up = glm::cross(right, view.axis);

  view.isParallel = camera.orthographicHeightMm.has_value();
  const float focal = view.isParallel
                          ? 2 / *camera.orthographicHeightMm
                          : 1 / std::tan(0.5F * glm::radians(camera.verticalFovDegrees));

  const auto row = [&](const glm::vec3& v) { return glm::vec4(v, -glm::dot(v, view.position)); };
  const glm::vec4 w = view.isParallel ? glm::vec4(0, 0, 0, 1) : row(view.axis);
  const glm::vec4 x = (focal / aspect) * row(right) - 2 * camera.shiftX * w;
  const glm::vec4 y = -focal * row(up) + 2 * camera.shiftY * w;
  const glm::vec4 z(0, 0, 0, view.isParallel ? glm::dot(view.axis, view.position) : 1.0F);
  view.worldToClip = glm::transpose(glm::mat4(x, y, z, w));
  return view;
}

std::span<const glm::vec2> samplePattern(int samples) {
  static const std::array<glm::vec2, 1> one{{{0, 0}}};
  static const std::array<glm::vec2, 2> two{{{.25F, .25F}, {-.25F, -.25F}}};
  static const std::array<glm::vec2, 4> four{
      {{-.125F, -.375F}, {.375F, -.125F}, {-.375F, .125F}, {.125F, .375F}}};
  static const std::array<glm::vec2, 8> eight{{{.0625F, -.1875F},
                                               {-.0625F, .1875F},
                                               {.3125F, .0625F},
                                               {-.1875F, -.3125F},
                                               {-.3125F, .3125F},
                                               {-.4375F, -.0625F},
                                               {.1875F, .4375F},
                                               {.4375F, -.4375F}}};
  switch (samples) {
    case 1:
      return one;
    case 2:
      return two;
    case 4:
      return four;
    case 8:
      return eight;
    default:
      assert(false);
      return one;
  }
}

void fillSamples(int samples, shared::FrameData& frame) {
  const std::span<const glm::vec2> pattern = samplePattern(std::max(samples, 1));
  for (std::size_t i = 0; i < pattern.size(); ++i) frame.samples[i] = {pattern[i], 0, 0};
  frame.counts.z = static_cast<std::uint32_t>(pattern.size());
}

}  // namespace opaline
