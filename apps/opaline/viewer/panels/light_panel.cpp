#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "opaline/environment.h"
#include "opaline/scene_file.h"
#include "viewer/panels/controls.h"
#include "viewer/panels/light_sliders.h"
#include "viewer/panels/panels.h"
#include "viewer/picture/new_lights.h"
#include "viewer/session/light_list.h"

namespace opaline::app::viewer {

namespace {

// Whether the renderer accepts the scene with one more light of this kind.
template <typename Light>
bool hasRoomFor(Lighting lighting, std::vector<Light> Lighting::*lights) {
  (lighting.*lights).emplace_back();
  return complaintAbout(lighting).empty();
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

/// Adds lights to a session by buttons.
class Adding {
 public:
  Adding(Session& session, const Projection& projection)
      : session_(session), projection_(projection) {}

  /// A button that adds the light that `make` takes from NewLights, and selects it. True if
  /// pressed.
  template <typename Light, typename Make>
  bool draw(LightKind kind, const char* about, std::vector<Light> Lighting::*lights, Make&& make,
            const char* shape = nullptr) {
    const std::string name = "add " + (shape != nullptr ? shape : nameOf(kind));
    Lighting& lighting = session_.scene.lighting;
    ImGui::BeginDisabled(!hasRoomFor(lighting, lights));
    const bool pressed = controls::button(name.c_str(), about);
    ImGui::EndDisabled();
    if (!pressed) return false;
    (lighting.*lights).push_back(make(NewLights(session_, projection_)));
    session_.light = static_cast<int>(numberOfLast(kind, lighting));
    return true;
  }

 private:
  Session& session_;
  const Projection& projection_;
};

bool drawAdding(Session& session, const Projection& projection) {
  Adding adding(session, projection);
  bool changed =
      adding.draw(LightKind::Directional, "A light from infinitely far away.",
                  &Lighting::directional, [](const NewLights& l) { return l.directional(); });
  controls::sameLineFor("add point");
  changed |= adding.draw(LightKind::Point, "A light from one place.", &Lighting::points,
                         [](const NewLights& l) { return l.point(); });
  controls::sameLineFor("add spot");
  changed |= adding.draw(LightKind::Spot, "A light from one place into a cone.", &Lighting::spots,
                         [](const NewLights& l) { return l.spot(); });
  const auto addArea = [&](const char* name, const char* about, auto&& make) {
    changed |= adding.draw(LightKind::Area, about, &Lighting::areas, make, name);
  };
  addArea("rectangle", "An even panel: soft shadows, and its shape in the reflection.",
          [](const NewLights& l) { return l.rectangle(); });
  controls::sameLineFor("add disc");
  addArea("disc", "An even disc.", [](const NewLights& l) { return l.disc(); });
  controls::sameLineFor("add sphere");
  addArea("sphere", "An even ball.", [](const NewLights& l) { return l.sphere(); });
  controls::sameLineFor("add tube");
  addArea("tube", "An even tube, without its ends.", [](const NewLights& l) { return l.tube(); });
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

bool drawChosen(Session& session) {
  Lighting& lighting = session.scene.lighting;
  const LightEntry entry = entryOf(lighting, static_cast<std::size_t>(session.light));
  bool changed = drawSliders(entry, session);
  if (controls::button("delete", "Removes the selected light.")) {
    erase(entry, lighting);
    session.light = -1;
    changed = true;
  }
  return changed;
}

bool drawHeight(float& groundMm, const Session& session) {
  float height = placeInFile({0, groundMm, 0}, session)[1];
  const float reach = 3 * session.diagonalMm;
  const bool changed = controls::length(
      "height of the ground", height, -reach, reach,
      "From the middle of the box around all objects at rest, as in scene files. What lies below "
      "the ground is hidden by it.");
  if (changed) groundMm = placeInScene({0, height, 0}, session)[1];
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
    changed |= drawHeight(*ground->heightMm, session);
  }
  if (changed) setGround(ground, session);
}

}  // namespace

void drawLightPanel(Session& session, const Projection& projection) {
  if (!controls::section("Light", false)) return;
  Lighting& lighting = session.scene.lighting;
  // The buttons stay in place while the list below them grows.
  bool changed = drawAdding(session, projection);
  drawList(lighting, session.light);
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
      controls::hint(fmt::format("{} of its lights cast{} shadows: marked in the picture", suns,
                                 suns == 1 ? "s" : ""));
    changed |= turnEnvironment(session);
    if (controls::button("take it away", "Removes the environment.")) {
      lighting.environment.reset();
      session.environment.reset();
      session.source.environment.reset();
      changed = true;
    }
  } else {
    ImGui::SameLine();
    controls::hint("or drop a .hdr or .exr on the window");
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
