#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>

#include "scene/environment_file.h"
#include "viewer/panels/controls.h"
#include "viewer/panels/panels.h"

namespace opaline::app::viewer {

namespace {

constexpr float toDegrees = 180 / std::numbers::pi_v<float>;

// Whether the renderer takes the scene with so many lights. A point light has a shadow view for
// each side of a cube about it.
bool within(std::size_t directional, std::size_t points) {
  return directional + points <= Lighting::maxLights &&
         directional + 6 * points <= Lighting::maxShadowMaps;
}

// A direction as turn about the vertical, from +z towards +x, and height above the horizon.
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
  const bool moved = drawDirection(light.directionToLight);
  return controls::light("irradiance", light.irradiance,
                         "Light on a surface that faces the source; pi on white paper looks white "
                         "at exposure 0.") ||
         moved;
}

bool drawPoint(PointLight& light, float diagonalMm) {
  bool changed = false;
  constexpr std::array<const char*, 3> axes{"x", "y", "z"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float reach = 3 * diagonalMm;
    changed |= controls::length(axes[axis], light.positionMm[axis], -reach, reach,
                                "Its place in the scene.");
  }
  return controls::light("intensity", light.intensity,
                         "Irradiance on a facing surface is this over the distance squared, in mm: "
                         "a more distant light needs much more.") ||
         changed;
}

// Entries of the list: directional lights, then points.
bool drawList(Lighting& lighting, int& chosen) {
  const auto entry = [&](const std::string& text, int index) {
    if (ImGui::Selectable(text.c_str(), chosen == index)) chosen = chosen == index ? -1 : index;
    controls::note(text.c_str());
  };
  int index = 0;
  for (std::size_t i = 0; i < lighting.directional.size(); ++i, ++index) {
    entry(fmt::format("directional {}", i + 1), index);
  }
  for (std::size_t i = 0; i < lighting.points.size(); ++i, ++index) {
    entry(fmt::format("point {}", i + 1), index);
  }
  chosen = std::min(chosen, index - 1);
  bool changed = false;
  const std::size_t directional = lighting.directional.size();
  const std::size_t points = lighting.points.size();
  ImGui::BeginDisabled(!within(directional + 1, points));
  if (controls::button("add directional", "A light from infinitely far away.")) {
    lighting.directional.push_back({{0.37F, 0.48F, -0.795F}, {3, 3, 3}});
    chosen = static_cast<int>(directional);
    changed = true;
  }
  ImGui::EndDisabled();
  controls::sameLineFor("add point");
  ImGui::BeginDisabled(!within(directional, points + 1));
  if (controls::button("add point", "A light from one place.")) {
    lighting.points.emplace_back();
    chosen = index;
    changed = true;
  }
  ImGui::EndDisabled();
  return changed;
}

void place(PointLight& light, const Session& session) {
  const Vec3& target = session.scene.camera.targetMm;
  const float d = session.diagonalMm;
  light.positionMm = {target[0] + 0.5F * d, target[1] + 0.4F * d, target[2] - 0.4F * d};
  light.intensity = {3 * d * d, 3 * d * d, 3 * d * d};
}

bool turnEnvironment(Session& session) {
  if (!session.environment || !session.source.environment) return false;
  scene::EnvironmentFile& file = *session.source.environment;
  if (!controls::slider(
          "rotation", file.rotationDegrees, -180, 180, "%.1f deg",
          "Rotates the environment about the vertical, counter-clockwise seen from above.")) {
    return false;
  }
  session.scene.lighting.environment =
      std::make_shared<const Image>(scene::turned(*session.environment, file.rotationDegrees));
  return true;
}

bool drawChosen(Session& session) {
  Lighting& lighting = session.scene.lighting;
  const auto index = static_cast<std::size_t>(session.light);
  const std::size_t directional = lighting.directional.size();
  bool changed = index < directional
                     ? drawDirectional(lighting.directional[index])
                     : drawPoint(lighting.points[index - directional], session.diagonalMm);
  if (controls::button("delete", "Removes the selected light.")) {
    if (index < directional) {
      lighting.directional.erase(lighting.directional.begin() + session.light);
    } else {
      lighting.points.erase(lighting.points.begin() +
                            (session.light - static_cast<int>(directional)));
    }
    session.light = -1;
    changed = true;
  }
  return changed;
}

}  // namespace

void drawLightPanel(Session& session) {
  if (!controls::section("Light", false)) return;
  Lighting& lighting = session.scene.lighting;
  const std::size_t points = lighting.points.size();
  bool changed = drawList(lighting, session.light);
  if (lighting.points.size() > points) place(lighting.points.back(), session);
  if (session.light >= 0) changed |= drawChosen(session);
  changed |=
      controls::light("ambient", lighting.ambient, "Radiance, the same from all directions.");
  if (controls::button("environment...", "Light from all around, from a picture: .hdr or .exr.")) {
    session.wantedFile = FileUse::OpenEnvironment;
  }
  if (lighting.environment) {
    ImGui::Text("environment of %d x %d pixels", lighting.environment->width,
                lighting.environment->height);
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
