#include "scene/placed_lights.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>
#include <variant>

#include "opaline/error.h"
#include "scene/vector_math.h"

namespace opaline::scene {

namespace {

bool scaleLight(double factor, Rgb& light) {
  for (float& channel : light) channel = static_cast<float>(double{channel} * factor);
  return std::all_of(light.begin(), light.end(), [](float x) { return std::isfinite(x); });
}

/// Applies a change to all lights and cameras in clips, as if they were those of a scene.
template <typename ChangeLights, typename ChangeCamera>
bool changeAll(std::vector<ClipChanges>& changes, const ChangeLights& changeLights,
               const ChangeCamera& changeCamera) {
  bool finite = true;
  const auto change = [&](auto& all, auto Lighting::*lights) {
    for (auto& keys : all) {
      Lighting moment;
      std::swap(moment.*lights, keys.values);
      finite = changeLights(moment) && finite;
      std::swap(moment.*lights, keys.values);
    }
  };
  for (ClipChanges& of : changes) {
    change(of.directional, &Lighting::directional);
    change(of.points, &Lighting::points);
    change(of.spots, &Lighting::spots);
    for (Keys<Camera>& keys : of.cameras)
      for (Camera& camera : keys.values) finite = changeCamera(camera) && finite;
  }
  return finite;
}

}  // namespace

bool placeLights(const Matrix4& matrix, Lighting& lighting) {
  const auto turn = [&](Vec3& direction) {
    direction = toFloat(unit(matrix.direction(toDouble(direction))));
  };
  const double area = std::pow(std::abs(matrix.determinant()), 2.0 / 3);
  const auto place = [&](Vec3& position, Rgb& intensity) {
    position = toFloat(matrix.point(toDouble(position)));
    return scaleLight(area, intensity) && isFinite(position);
  };
  bool finite = true;
  for (DirectionalLight& light : lighting.directional) turn(light.directionToLight);
  for (PointLight& light : lighting.points)
    finite = place(light.positionMm, light.intensity) && finite;
  for (SpotLight& light : lighting.spots) {
    turn(light.direction);
    finite = place(light.positionMm, light.intensity) && finite;
  }
  return finite;
}

bool scaleLights(double factor, Lighting& lighting) {
  bool finite = true;
  const auto scale = [&](Vec3& position, Rgb& intensity) {
    position = toFloat(factor * toDouble(position));
    finite = scaleLight(factor * factor, intensity) && isFinite(position) && finite;
  };
  for (PointLight& light : lighting.points) scale(light.positionMm, light.intensity);
  for (SpotLight& light : lighting.spots) scale(light.positionMm, light.intensity);
  const auto lengthen = [&](Vec3& vector) {
    vector = toFloat(factor * toDouble(vector));
    finite = isFinite(vector) && finite;
  };
  for (AreaLight& area : lighting.areas)
    std::visit(
        [&](auto& light) {
          using Light = std::remove_reference_t<decltype(light)>;
          if constexpr (std::is_same_v<Light, TubeLight>) {
            lengthen(light.fromMm);
            lengthen(light.toMm);
          } else {
            lengthen(light.centreMm);
          }
          if constexpr (std::is_same_v<Light, RectangleLight>) {
            lengthen(light.uMm);
            lengthen(light.vMm);
          } else {
            light.radiusMm = static_cast<float>(double{light.radiusMm} * factor);
          }
        },
        area);
  return finite;
}

bool placeCamera(const Matrix4& matrix, Camera& camera) {
  camera.positionMm = toFloat(matrix.point(toDouble(camera.positionMm)));
  camera.targetMm = toFloat(matrix.point(toDouble(camera.targetMm)));
  camera.up = toFloat(unit(matrix.direction(toDouble(camera.up))));
  return isFinite(camera.positionMm) && isFinite(camera.targetMm);
}

bool scaleCamera(double factor, Camera& camera) {
  camera.positionMm = toFloat(factor * toDouble(camera.positionMm));
  camera.targetMm = toFloat(factor * toDouble(camera.targetMm));
  if (auto& heightMm = camera.orthographicHeightMm)
    *heightMm = static_cast<float>(factor * double{*heightMm});
  return isFinite(camera.positionMm) && isFinite(camera.targetMm) &&
         std::isfinite(camera.orthographicHeightMm.value_or(0));
}

bool scaleChanges(double factor, std::vector<ClipChanges>& changes) {
  return changeAll(
      changes, [&](Lighting& lighting) { return scaleLights(factor, lighting); },
      [&](Camera& camera) { return scaleCamera(factor, camera); });
}

bool placeChanges(const Matrix4& matrix, std::vector<ClipChanges>& changes) {
  return changeAll(
      changes, [&](Lighting& lighting) { return placeLights(matrix, lighting); },
      [&](Camera& camera) { return placeCamera(matrix, camera); });
}

}  // namespace opaline::scene

namespace opaline {

void scaleLightsAndCamera(double factor, Scene& scene) {
  Lighting lighting = scene.lighting;
  Camera camera = scene.camera;
  std::vector<ClipChanges> changes = scene.changes;
  const bool isSound = factor > 0 && scene::scaleLights(factor, lighting) &&
                       scene::scaleCamera(factor, camera) && scene::scaleChanges(factor, changes);
  if (!isSound) {
    throw UsageError(
        fmt::format("Lights and camera cannot be scaled by {}: that is not above 0 or takes them "
                    "out of the range of a float.",
                    factor));
  }
  scene.lighting = std::move(lighting);
  scene.camera = camera;
  scene.changes = std::move(changes);
}

}  // namespace opaline
