#include "scene/gltf/lights.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "opaline/options/scene.h"
#include "scene/text.h"
#include "scene/vector_math.h"

namespace opaline::scene {

namespace {

/// The direction of an axis of a node, none where its transform is not invertible.
std::optional<Double3> axisOf(const Matrix4& world, std::size_t axis) {
  const Double3& column = world.column[axis];
  const double size = length(column);
  if (!isFinite(column) || !(size > 0)) return std::nullopt;
  return (1 / size) * column;
}

Rgb lightColor(const Input& input, const tinygltf::Light& light) {
  Rgb rgb{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double value = (c < light.color.size() ? light.color[c] : 1.0) * light.intensity;
    if (!(value >= 0) || value > 1e30) {
      failGltf(input, fmt::format("the intensity of light '{}' is {}, but must be from 0 to 1e30",
                                  cleanText(light.name, 60), value));
    }
    rgb[c] = static_cast<float>(value);
  }
  return rgb;
}

SpotLight spotLight(const Input& input, const tinygltf::Light& light, const Matrix4& world,
                    std::size_t nodeIndex) {
  const auto back = axisOf(world, 2);
  if (!back) failGltf(input, fmt::format("light node {} has no direction", nodeIndex));
  constexpr double toDegrees = 180 / std::numbers::pi;
  const double inner = light.spot.innerConeAngle * toDegrees;
  const double outer = light.spot.outerConeAngle * toDegrees;
  // The extension allows no more than these. Rounding of π/2 is no mistake of the file.
  if (!(inner >= 0) || !(outer >= inner) || !(outer > 0) || !(outer <= 90 + 1e-4)) {
    failGltf(input, fmt::format("the cone of light '{}' goes from {:g} to {:g} degrees, but must "
                                "end between its inner angle and 90 degrees",
                                cleanText(light.name, 60), inner, outer));
  }
  SpotLight spot;
  spot.positionMm = toFloat(world.column[3]);
  spot.direction = toFloat(-1.0 * *back);
  spot.intensity = lightColor(input, light);
  spot.outerDegrees = static_cast<float>(std::min(outer, 90.0));
  spot.innerDegrees = std::min(static_cast<float>(inner), spot.outerDegrees);
  return spot;
}

}  // namespace

std::optional<LightOfFile> readLight(const Input& input, const tinygltf::Light& light,
                                     const Matrix4& world, std::size_t node) {
  if (light.type == "directional") {
    const auto back = axisOf(world, 2);
    if (!back) failGltf(input, fmt::format("light node {} has no direction", node));
    return DirectionalLight{toFloat(*back), lightColor(input, light)};
  }
  if (light.type == "point") return PointLight{toFloat(world.column[3]), lightColor(input, light)};
  if (light.type == "spot") return spotLight(input, light, world, node);
  return std::nullopt;
}

Camera readCamera(const Input& input, const tinygltf::Camera& camera, const Matrix4& world) {
  const auto back = axisOf(world, 2);
  const auto up = axisOf(world, 1);
  const double degrees = camera.perspective.yfov * 180 / std::numbers::pi;
  const std::string name = cleanText(camera.name, 60);
  if (!back || !up || !isFinite(world.column[3])) {
    failGltf(input, fmt::format("the node of camera '{}' gives it no place or no direction: its "
                                "transform must be finite and invertible",
                                name));
  }
  const options::Range degreesAllowed = options::fieldOf<Camera>("fov_degrees").allowed.range;
  if (!degreesAllowed.holds(degrees)) {
    failGltf(input, fmt::format("the vertical field of view of camera '{}' is {:g} degrees, but "
                                "must be {}",
                                name, degrees, options::describe(degreesAllowed)));
  }
  return {.positionMm = toFloat(world.column[3]),
          .targetMm = toFloat(world.column[3] - *back),
          .up = toFloat(*up),
          .verticalFovDegrees = static_cast<float>(degrees)};
}

bool hasDirections(const Matrix4& world) {
  return axisOf(world, 1) && axisOf(world, 2) && isFinite(world.column[3]);
}

}  // namespace opaline::scene
