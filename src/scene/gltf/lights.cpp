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

/// The direction of a node's axis; none where the axis has no length or is not finite.
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
  // The extension allows no more than 90 degrees. The tolerance is for π/2 rounded.
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

float degreesSeen(const Input& input, const tinygltf::Camera& camera, const std::string& name) {
  const double degrees = camera.perspective.yfov * 180 / std::numbers::pi;
  const options::Range allowed = options::fieldOf<Camera>("fov_degrees").allowed.range;
  if (!allowed.holds(degrees)) {
    failGltf(input, fmt::format("the vertical field of view of camera '{}' is {:g} degrees, but "
                                "must be {}",
                                name, degrees, options::describe(allowed)));
  }
  return static_cast<float>(degrees);
}

/// The full height that an orthographic camera sees, in units of the file.
float heightSeen(const Input& input, const tinygltf::Camera& camera, const std::string& name) {
  const auto height = static_cast<float>(2 * camera.orthographic.ymag);
  if (!std::isfinite(height) || height <= 0) {
    failGltf(input, fmt::format("camera '{}' sees a height of {:g}, but it must be above 0", name,
                                2 * camera.orthographic.ymag));
  }
  return height;
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
  const std::string name = cleanText(camera.name, 60);
  if (!back || !up || !isFinite(world.column[3])) {
    failGltf(input, fmt::format("the node of camera '{}' gives it no place or no direction: its "
                                "transform must be finite and invertible",
                                name));
  }
  Camera read{.positionMm = toFloat(world.column[3]),
              .targetMm = toFloat(world.column[3] - *back),
              .up = toFloat(*up)};
  if (camera.type == "orthographic")
    read.orthographicHeightMm = heightSeen(input, camera, name);
  else
    read.verticalFovDegrees = degreesSeen(input, camera, name);
  return read;
}

bool hasDirections(const Matrix4& world) {
  return axisOf(world, 1) && axisOf(world, 2) && isFinite(world.column[3]);
}

}  // namespace opaline::scene
