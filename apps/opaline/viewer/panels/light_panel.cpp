#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "opaline/environment.h"
#include "opaline/scene_file.h"
#include "viewer/panels/controls.h"
#include "viewer/panels/panels.h"
#include "viewer/session/light_list.h"

namespace opaline::app::viewer {

namespace {

constexpr float toDegrees = 180 / std::numbers::pi_v<float>;
constexpr float leastConeDegrees = 1;

// Whether the renderer accepts the scene with one more light of this kind.
template <typename Light>
bool hasRoomFor(const Light& light, Lighting lighting, std::vector<Light> Lighting::*lights) {
  (lighting.*lights).push_back(light);
  return complaintAbout(lighting).empty();
}

// A direction as an angle about the vertical, from +z towards +x, and a height above the horizon.
bool drawDirection(Vec3& direction) {
  float turn = std::atan2(direction[0], direction[2]) * toDegrees;
  float height = std::asin(std::clamp(direction[1], -1.0F, 1.0F)) * toDegrees;
  const bool turned = controls::slider("turn", turn, -180, 180, "%.1f deg",
                                       "Where it shines from: 0 is from the front of the scene.");
  const bool raised = controls::slider("height", height, -89.9F, 89.9F, "%.1f deg",
                                       "Where it shines from: 90 is from above.");
  if (!turned && !raised) return false;
  const float c = std::cos(height / toDegrees);
  direction = {c * std::sin(turn / toDegrees), std::sin(height / toDegrees),
               c * std::cos(turn / toDegrees)};
  return true;
}

bool drawDirectional(DirectionalLight& light) {
  bool changed = drawDirection(light.directionToLight);
  changed |= controls::slider("radius", light.angularRadiusDegrees, 0, 10, "%.2f deg",
                              "Of the disc that surfaces mirror. The sun's is 0.27.");
  return controls::light("irradiance", light.irradiance,
                         "Light on a surface that faces the source; pi on white paper looks white "
                         "at exposure 0.") ||
         changed;
}

bool drawPlace(Vec3& positionMm, float diagonalMm) {
  bool changed = false;
  constexpr std::array<const char*, 3> axes{"x", "y", "z"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float reach = 3 * diagonalMm;
    changed |=
        controls::length(axes[axis], positionMm[axis], -reach, reach, "Its place in the scene.");
  }
  return changed;
}

bool drawIntensity(Rgb& intensity) {
  return controls::light("intensity", intensity,
                         "Irradiance on a facing surface is this over the distance squared, in mm: "
                         "a more distant light needs much more.");
}

bool drawPoint(PointLight& light, float diagonalMm) {
  const bool moved = drawPlace(light.positionMm, diagonalMm);
  return drawIntensity(light.intensity) || moved;
}

bool drawSpot(SpotLight& light, float diagonalMm) {
  bool changed = drawPlace(light.positionMm, diagonalMm);
  Vec3 from = light.direction;
  for (float& component : from) component = -component;
  if (drawDirection(from)) {
    for (std::size_t axis = 0; axis < 3; ++axis) light.direction[axis] = -from[axis];
    changed = true;
  }
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

// A rectangle's edges and its rotation are dragged in the picture.
bool drawShape(RectangleLight& light, float diagonalMm) {
  bool changed = drawPlace(light.centreMm, diagonalMm);
  float size = 1;
  if (controls::slider("scale", size, 0.9F, 1.1F, "x %.2f", "Both edges of it.")) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      light.uMm[axis] *= size;
      light.vMm[axis] *= size;
    }
    changed = true;
  }
  changed |= drawRadiance(light.radiance);
  changed |= drawTwoSided(light.twoSided);
  return drawVisible(light.visible) || changed;
}

bool drawShape(DiscLight& light, float diagonalMm) {
  bool changed = drawPlace(light.centreMm, diagonalMm);
  changed |= drawDirection(light.normal);
  changed |= drawRadius(light.radiusMm, diagonalMm);
  changed |= drawRadiance(light.radiance);
  changed |= drawTwoSided(light.twoSided);
  return drawVisible(light.visible) || changed;
}

bool drawShape(SphereLight& light, float diagonalMm) {
  bool changed = drawPlace(light.centreMm, diagonalMm);
  changed |= drawRadius(light.radiusMm, diagonalMm);
  changed |= drawRadiance(light.radiance);
  return drawVisible(light.visible) || changed;
}

bool drawShape(TubeLight& light, float diagonalMm) {
  bool changed = drawRadius(light.radiusMm, diagonalMm);
  changed |= drawRadiance(light.radiance);
  return drawVisible(light.visible) || changed;
}

// Draws an area light. An edit that makes an impossible light is dropped.
bool drawArea(AreaLight& light, float diagonalMm) {
  AreaLight edited = light;
  const bool changed =
      std::visit([&](auto& shape) { return drawShape(shape, diagonalMm); }, edited);
  if (!changed || !complaintAbout(edited).empty()) return false;
  light = edited;
  return true;
}

void drawList(const Lighting& lighting, int& chosen) {
  const auto count = static_cast<int>(countOf(lighting));
  for (int i = 0; i < count; ++i) {
    const std::string name = nameOf(lighting, entryOf(lighting, static_cast<std::size_t>(i)));
    if (ImGui::Selectable(name.c_str(), chosen == i)) chosen = chosen == i ? -1 : i;
    controls::note(name.c_str());
  }
  chosen = std::min(chosen, count - 1);
}

// A button that adds the light and selects it.
template <typename Light>
bool drawAdd(LightKind kind, const char* about, const Light& light,
             std::vector<Light> Lighting::*lights, Session& session, const char* shape = nullptr) {
  const std::string name = "add " + (shape != nullptr ? shape : nameOf(kind));
  Lighting& lighting = session.scene.lighting;
  ImGui::BeginDisabled(!hasRoomFor(light, lighting, lights));
  const bool pressed = controls::button(name.c_str(), about);
  ImGui::EndDisabled();
  if (!pressed) return false;
  (lighting.*lights).push_back(light);
  session.light = static_cast<int>(numberOfLast(kind, lighting));
  return true;
}

// A place behind the scene and to the side, from which a light is as bright as the default ones.
Vec3 placeBehind(const Session& session) {
  const Vec3& target = session.scene.camera.targetMm;
  const float d = session.diagonalMm;
  return {target[0] + 0.5F * d, target[1] + 0.4F * d, target[2] - 0.4F * d};
}

bool drawAdding(Session& session) {
  const float power = 3 * session.diagonalMm * session.diagonalMm;
  const Vec3 place = placeBehind(session);
  bool changed = drawAdd(LightKind::Directional, "A light from infinitely far away.",
                         DirectionalLight{{0.37F, 0.48F, -0.795F}, {3, 3, 3}},
                         &Lighting::directional, session);
  controls::sameLineFor("add point");
  changed |= drawAdd(LightKind::Point, "A light from one place.",
                     PointLight{place, {power, power, power}}, &Lighting::points, session);
  controls::sameLineFor("add spot");
  changed |= drawAdd(LightKind::Spot, "A light from one place into a cone.",
                     SpotLight{place, {-0.66F, -0.53F, 0.53F}, {power, power, power}, 20, 30},
                     &Lighting::spots, session);
  const Vec3 target = session.scene.camera.targetMm;
  const auto addArea = [&](const char* name, const char* about, const AreaLight& light) {
    changed |= drawAdd(LightKind::Area, about, light, &Lighting::areas, session, name);
  };
  // As bright in the middle of the scene as the other new lights.
  const float d = session.diagonalMm;
  const Rgb radiance{14, 14, 14};
  const Vec3 u{0.16F * d, 0, 0.2F * d};
  const Vec3 v{0.12F * d, -0.24F * d, -0.1F * d};
  addArea("rectangle", "An even panel: soft shadows, and its shape in the reflection.",
          RectangleLight{place, v, u, radiance});
  controls::sameLineFor("add disc");
  addArea("disc", "An even disc.", DiscLight{place, {-0.66F, -0.53F, 0.53F}, 0.28F * d, radiance});
  controls::sameLineFor("add sphere");
  addArea("sphere", "An even ball.", SphereLight{place, 0.2F * d, {24, 24, 24}});
  controls::sameLineFor("add tube");
  addArea("tube", "An even tube, without its ends.",
          TubeLight{{place[0], target[1] - 0.5F * d, place[2]},
                    {place[0], target[1] + 0.5F * d, place[2]},
                    0.05F * d,
                    {30, 30, 30}});
  return changed;
}

bool turnEnvironment(Session& session) {
  if (!session.environment || !session.source.environment) return false;
  EnvironmentFile& file = *session.source.environment;
  if (!controls::slider(
          "rotation", file.rotationDegrees, -180, 180, "%.1f deg",
          "Rotates the environment about the vertical, counter-clockwise seen from above.")) {
    return false;
  }
  session.scene.lighting.environment =
      std::make_shared<const Image>(turned(*session.environment, file.rotationDegrees));
  return true;
}

bool drawEntry(const LightEntry& entry, Lighting& lighting, float diagonalMm) {
  switch (entry.kind) {
    case LightKind::Directional:
      return drawDirectional(lighting.directional[entry.index]);
    case LightKind::Point:
      return drawPoint(lighting.points[entry.index], diagonalMm);
    case LightKind::Spot:
      return drawSpot(lighting.spots[entry.index], diagonalMm);
    case LightKind::Area:
      break;
  }
  return drawArea(lighting.areas[entry.index], diagonalMm);
}

bool drawChosen(Session& session) {
  Lighting& lighting = session.scene.lighting;
  const LightEntry entry = entryOf(lighting, static_cast<std::size_t>(session.light));
  bool changed = drawEntry(entry, lighting, session.diagonalMm);
  if (controls::button("delete", "Removes the selected light.")) {
    erase(entry, lighting);
    session.light = -1;
    changed = true;
  }
  return changed;
}

void drawGround(Session& session) {
  std::optional<Ground> ground = describeGround(session.scene);
  bool on = ground.has_value();
  bool changed =
      controls::checkbox("ground", on, "An opaque plane that takes shadows and gives light back.");
  if (changed) ground = on ? std::optional(Ground{}) : std::nullopt;
  if (ground && ground->heightMm) {
    changed |= controls::light("color of the ground", ground->color,
                               "Share of light that it gives back, from 0 to 1.");
    for (float& share : ground->color) share = std::min(share, 1.0F);
    const float reach = 3 * session.diagonalMm;
    changed |= controls::length("height of the ground", *ground->heightMm, -reach, reach,
                                "What lies below is hidden by it.");
  }
  if (changed) setGround(ground, session);
}

}  // namespace

void drawLightPanel(Session& session) {
  if (!controls::section("Light", false)) return;
  Lighting& lighting = session.scene.lighting;
  drawList(lighting, session.light);
  bool changed = drawAdding(session);
  if (session.light >= 0) changed |= drawChosen(session);
  changed |=
      controls::light("ambient", lighting.ambient, "Radiance, the same from all directions.");
  if (controls::button("environment...", "Light from all around, from a picture: .hdr or .exr.")) {
    session.wantedFile = FileUse::OpenEnvironment;
  }
  if (lighting.environment) {
    ImGui::Text("environment of %d x %d pixels", lighting.environment->width,
                lighting.environment->height);
    if (const std::size_t suns = session.suns.size(); suns > 0)
      ImGui::TextDisabled("%zu of its lights cast%s shadows: marked in the picture", suns,
                          suns == 1 ? "s" : "");
    changed |= turnEnvironment(session);
    if (controls::button("take it away", "Removes the environment.")) {
      lighting.environment.reset();
      session.environment.reset();
      session.source.environment.reset();
      changed = true;
    }
  } else {
    ImGui::SameLine();
    ImGui::TextDisabled("or drop a .hdr or .exr on the window");
  }
  drawGround(session);
  if (controls::checkbox("handles in the picture", session.gizmos,
                         "Shows lights as handles that you can drag.")) {
    session.edits.picture = true;
  }
  static const Choices<int> shadowSizes{
      {"256", 256}, {"512", 512}, {"1024", 1024}, {"2048", 2048}, {"4096", 4096}};
  if (controls::choice("shadow map", session.options.shadowSize, shadowSizes,
                       "Edge of each light's shadow map, texels. Williams 1978.")) {
    session.edits.picture = true;
  }
  if (changed) session.edits.lighting = true;
}

}  // namespace opaline::app::viewer
