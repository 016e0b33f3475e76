#include "viewer/panels/light_sliders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <variant>

#include "viewer/panels/controls.h"
#include "viewer/picture/vectors.h"
#include "viewer/session/area_lights.h"

namespace opaline::app::viewer {

namespace {

constexpr float toDegrees = 180 / std::numbers::pi_v<float>;
constexpr float leastConeDegrees = 1;
// Straight above, a light could not be turned about the vertical.
constexpr float mostHeightDegrees = 89.9F;

// The direction to a light, as an angle about the vertical, from +z towards +x, and a height above
// the horizon.
bool drawDirectionToLight(glm::vec3& direction) {
  float turn = std::atan2(direction.x, direction.z) * toDegrees;
  float height = std::asin(std::clamp(direction.y, -1.0F, 1.0F)) * toDegrees;
  const bool turned = controls::slider("turn", turn, -180, 180, "%.1f deg",
                                       "Where it shines from: 0 is from the front of the scene.");
  const bool raised = controls::slider("height", height, -mostHeightDegrees, mostHeightDegrees,
                                       "%.1f deg", "Where it shines from: 90 is from above.");
  if (!turned && !raised) return false;
  height = std::clamp(height, -mostHeightDegrees, mostHeightDegrees);
  const float c = std::cos(height / toDegrees);
  direction = {c * std::sin(turn / toDegrees), std::sin(height / toDegrees),
               c * std::cos(turn / toDegrees)};
  return true;
}

// The same for a light of which is known along which direction it shines.
bool drawDirectionOfLight(glm::vec3& direction) {
  glm::vec3 towards = -direction;
  const bool changed = drawDirectionToLight(towards);
  if (changed) direction = -towards;
  return changed;
}

bool drawDirectionOfLight(Vec3& direction) {
  glm::vec3 turned = toGlm(direction);
  const bool changed = drawDirectionOfLight(turned);
  if (changed) direction = fromGlm(turned);
  return changed;
}

bool drawDirectional(DirectionalLight& light) {
  glm::vec3 direction = toGlm(light.directionToLight);
  bool changed = drawDirectionToLight(direction);
  if (changed) light.directionToLight = fromGlm(direction);
  changed |= controls::slider("radius", light.angularRadiusDegrees, 0, 10, "%.2f deg",
                              "Of the disc that surfaces mirror. The sun's is 0.27.");
  return controls::light("irradiance", light.irradiance,
                         "Light on a surface that faces the source; pi on white paper looks white "
                         "at exposure 0.") ||
         changed;
}

bool drawPlace(Vec3& positionMm, const Session& session) {
  Vec3 place = placeInFile(positionMm, session);
  bool changed = false;
  constexpr std::array<const char*, 3> axes{"x", "y", "z"};
  const float reach = 3 * session.diagonalMm;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    changed |= controls::length(
        axes[axis], place[axis], -reach, reach,
        "Its place, from the middle of the box around all objects at rest, as in scene files.");
  }
  if (changed) positionMm = placeInScene(place, session);
  return changed;
}

bool drawMiddle(AreaLight& light, const Session& session) {
  Vec3 middle = fromGlm(middleOfArea(light));
  const bool moved = drawPlace(middle, session);
  if (moved) moveArea(toGlm(middle), light);
  return moved;
}

bool drawIntensity(Rgb& intensity) {
  return controls::light("intensity", intensity,
                         "Irradiance on a facing surface is this over the distance squared, in mm: "
                         "a more distant light needs much more.");
}

bool drawPoint(PointLight& light, const Session& session) {
  const bool moved = drawPlace(light.positionMm, session);
  return drawIntensity(light.intensity) || moved;
}

bool drawSpot(SpotLight& light, const Session& session) {
  bool changed = drawPlace(light.positionMm, session);
  changed |= drawDirectionOfLight(light.direction);
  if (controls::slider("inner angle", light.innerDegrees, 0, 90, "%.1f deg",
                       "From the axis, up to where it is as bright as there.")) {
    light.outerDegrees = std::max({light.outerDegrees, light.innerDegrees, leastConeDegrees});
    changed = true;
  }
  if (controls::slider("outer angle", light.outerDegrees, leastConeDegrees, 90, "%.1f deg",
                       "From the axis, where it ends.")) {
    light.innerDegrees = std::min(light.innerDegrees, light.outerDegrees);
    changed = true;
  }
  return drawIntensity(light.intensity) || changed;
}

bool drawRadius(float& radiusMm, float diagonalMm) {
  return controls::length("radius", radiusMm, 1e-3F * diagonalMm, diagonalMm,
                          "A larger light has softer shadows.");
}

bool drawRadiance(Rgb& radiance) {
  return controls::light("radiance", radiance,
                         "How bright the light itself looks: a larger one gives more light.");
}

bool drawTwoSided(bool& on) {
  return controls::checkbox("both sides", on, "Shines to its back too.");
}

bool drawVisible(bool& on) {
  return controls::checkbox("visible", on, "Seen in the picture itself, not only in reflections.");
}

bool drawEdges(RectangleLight& light, float diagonalMm) {
  glm::vec2 edges = edgesMm(light);
  const auto draw = [&](const char* name, float& edge, const char* about) {
    return controls::length(name, edge, 1e-3F * diagonalMm, 2 * diagonalMm, about);
  };
  bool changed = draw("width", edges.x, "Length of its edges along u.");
  changed |= draw("length", edges.y, "Length of its edges along v.");
  if (changed) setEdges(edges, light);
  return changed;
}

bool drawShape(RectangleLight& light, float diagonalMm) {
  glm::vec3 normal = normalOf(light);
  bool changed = drawDirectionOfLight(normal);
  if (changed) turnTo(normal, light);
  changed |= drawEdges(light, diagonalMm);
  changed |= drawRadiance(light.radiance);
  changed |= drawTwoSided(light.twoSided);
  return drawVisible(light.visible) || changed;
}

bool drawShape(DiscLight& light, float diagonalMm) {
  bool changed = drawDirectionOfLight(light.normal);
  changed |= drawRadius(light.radiusMm, diagonalMm);
  changed |= drawRadiance(light.radiance);
  changed |= drawTwoSided(light.twoSided);
  return drawVisible(light.visible) || changed;
}

bool drawShape(SphereLight& light, float diagonalMm) {
  bool changed = drawRadius(light.radiusMm, diagonalMm);
  changed |= drawRadiance(light.radiance);
  return drawVisible(light.visible) || changed;
}

bool drawShape(TubeLight& light, float diagonalMm) {
  bool changed = drawRadius(light.radiusMm, diagonalMm);
  changed |= drawRadiance(light.radiance);
  return drawVisible(light.visible) || changed;
}

// Draws an area light. An edit that makes an impossible light is dropped.
bool drawArea(AreaLight& light, const Session& session) {
  AreaLight edited = light;
  bool changed = drawMiddle(edited, session);
  changed |= std::visit([&](auto& shape) { return drawShape(shape, session.diagonalMm); }, edited);
  if (!changed || !complaintAbout(edited).empty()) return false;
  light = edited;
  return true;
}

}  // namespace

bool drawSliders(const LightEntry& entry, Session& session) {
  Lighting& lighting = session.scene.lighting;
  switch (entry.kind) {
    case LightKind::Directional:
      return drawDirectional(lighting.directional[entry.index]);
    case LightKind::Point:
      return drawPoint(lighting.points[entry.index], session);
    case LightKind::Spot:
      return drawSpot(lighting.spots[entry.index], session);
    case LightKind::Area:
      break;
  }
  return drawArea(lighting.areas[entry.index], session);
}

}  // namespace opaline::app::viewer
